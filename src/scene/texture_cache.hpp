// Opens the pictures that a scene names, each once.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "image/image_source.hpp"
#include "parser/diagnostic.hpp"
#include "scene/material.hpp"
#include "scene/texture.hpp"

namespace trace {

class TextureCache {
 public:
  TextureCache(std::filesystem::path scene_folder, ImageSource& images, parser::Diagnostics& diagnostics)
      : scene_folder_(std::move(scene_folder)), images_(images), diagnostics_(diagnostics) {}

  // The picture `file`, looked for beside the scene; with `or_working_folder` then in the working folder too,
  // where the course's renderer looks for maps of shininess and index. no_texture and an error at `span`
  // where it cannot be read.
  TextureId open(const std::string& file, parser::Span span, bool or_working_folder);

  std::vector<Texture> take() { return std::move(textures_); }
  const Texture& operator[](TextureId id) const { return textures_[static_cast<std::size_t>(id)]; }

 private:
  std::filesystem::path scene_folder_;
  ImageSource& images_;
  parser::Diagnostics& diagnostics_;
  std::vector<Texture> textures_;
  std::map<std::filesystem::path, TextureId> opened_;
};

}  // namespace trace
