// Opens the pictures that a scene names, each once.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "image/image_source.hpp"
#include "parser/description.hpp"
#include "parser/diagnostic.hpp"
#include "scene/material.hpp"
#include "scene/scene_files.hpp"
#include "scene/texture.hpp"

namespace trace {

class TextureCache {
 public:
  // `permissive`: what cannot be read is left out with a warning, however it is written.
  TextureCache(std::filesystem::path scene_folder, ImageSource& images, parser::Diagnostics& diagnostics,
               bool permissive = false)
      : files_(std::move(scene_folder), images),
        images_(images),
        diagnostics_(diagnostics),
        permissive_(permissive) {}

  // The picture of a map, or two laid over one another. It is looked for beside the scene; with
  // `or_working_folder` then in the working folder too, where the course's renderer looks for maps of
  // shininess and index. no_texture where it cannot be read, and at `span` an error, or of a bare string,
  // whose programs go on without, a warning, once a file.
  TextureId open(const parser::MapFile& map, parser::Span span, bool or_working_folder);
  // The picture `file`, as a bare string names it. no_texture and the reason in `problem` where it cannot be
  // read.
  TextureId open(const std::string& file, std::string& problem);

  // The same for a picture that is needed only now: it is not kept.
  std::optional<Texture> picture(const std::string& file, std::string& problem);

  TextureId add(const Texture& texture);

  std::vector<Texture> take() { return std::move(textures_); }
  const Texture& operator[](TextureId id) const { return textures_[static_cast<std::size_t>(id)]; }

  const SceneFiles& files() const { return files_; }
  bool permissive() const { return permissive_; }

 private:
  TextureId read(const std::filesystem::path& path, std::string& problem);

  SceneFiles files_;
  ImageSource& images_;
  parser::Diagnostics& diagnostics_;
  bool permissive_;
  std::vector<Texture> textures_;
  std::map<std::filesystem::path, TextureId> opened_;
  std::set<std::string> warned_of_;
};

}  // namespace trace
