#include "scene/texture_cache.hpp"

#include <fmt/format.h>

namespace trace {

TextureId TextureCache::open(const parser::MapFile& map, parser::Span span, bool or_working_folder) {
  const auto picture = [&](const std::string& file) {
    std::string problem;
    const TextureId id = map.bare ? open(file, problem) : read(files_.find(file, or_working_folder), problem);
    if (id != no_texture) return id;
    if (map.bare || permissive_) {
      if (!warned_of_.insert(file).second) return no_texture;
      diagnostics_.warning(span,
                           fmt::format("cannot read texture '{}': {}: this map is left out", file, problem));
    } else {
      diagnostics_.error(span, fmt::format("cannot read texture '{}': {}", file, problem));
    }
    return no_texture;
  };
  const TextureId first = picture(map.file);
  if (map.over.empty()) return first;
  if (!(map.threshold < 1)) {
    diagnostics_.error(span, fmt::format("the threshold {} is not less than 1: nothing of '{}' would be seen",
                                         map.threshold, map.over));
    return no_texture;
  }
  const TextureId second = picture(map.over);
  if (first == no_texture || second == no_texture) return first;
  return add(Texture((*this)[first], (*this)[second], map.threshold));
}

TextureId TextureCache::open(const std::string& file, std::string& problem) {
  return read(files_.find_somewhere(file), problem);
}

std::optional<Texture> TextureCache::picture(const std::string& file, std::string& problem) {
  try {
    return Texture(images_.read(files_.find_somewhere(file)));
  } catch (const ImageError& e) {
    problem = e.what();
    return std::nullopt;
  }
}

TextureId TextureCache::add(const Texture& texture) {
  textures_.push_back(texture);
  return static_cast<TextureId>(textures_.size() - 1);
}

TextureId TextureCache::read(const std::filesystem::path& path, std::string& problem) {
  if (const auto known = opened_.find(path); known != opened_.end()) return known->second;
  try {
    const TextureId id = add(Texture(images_.read(path)));
    opened_.emplace(path, id);
    return id;
  } catch (const ImageError& e) {
    problem = e.what();
    return no_texture;
  }
}

}  // namespace trace
