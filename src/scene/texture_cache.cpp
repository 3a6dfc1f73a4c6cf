#include "scene/texture_cache.hpp"

#include <fmt/format.h>

namespace trace {

TextureId TextureCache::open(const std::string& file, parser::Span span, bool or_working_folder) {
  std::filesystem::path path = scene_folder_ / file;
  if (or_working_folder && !images_.exists(path) && images_.exists(file)) path = file;
  if (const auto known = opened_.find(path); known != opened_.end()) return known->second;
  try {
    textures_.emplace_back(images_.read(path));
  } catch (const ImageError& e) {
    diagnostics_.error(span, fmt::format("cannot read texture '{}': {}", file, e.what()));
    return no_texture;
  }
  const auto id = static_cast<TextureId>(textures_.size() - 1);
  opened_.emplace(std::move(path), id);
  return id;
}

}  // namespace trace
