#include "scene/make_surroundings.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trace {
namespace {

constexpr std::array<const char*, 6> cube_words{"posx", "negx", "posy", "negy", "posz", "negz"},
    sky_words{"right", "left", "top", "bottom", "front", "back"};

std::filesystem::path place_of(const std::string& file, const std::filesystem::path& folder,
                               ImageSource& images) {
  std::filesystem::path as_written = folder / file;
  if (file.find('\\') == std::string::npos || images.exists(as_written)) return as_written;
  std::string with_slashes = file;
  std::replace(with_slashes.begin(), with_slashes.end(), '\\', '/');
  return folder / with_slashes;
}

}  // namespace

std::optional<CubeMap> make_surroundings(const parser::Surroundings& said,
                                         const std::filesystem::path& folder, ImageSource& images,
                                         parser::Diagnostics& diagnostics) {
  const char* block = said.skybox ? "skybox" : "cubemap";
  const auto none = [&](parser::Span place, const std::string& problem) {
    diagnostics.warning(place, fmt::format("no surroundings: {}", problem));
    return std::nullopt;
  };
  if (said.file) {
    std::string problem;
    std::optional<CubeMap> result =
        read_cube_map(place_of(said.file->value, folder, images).string(), images, problem);
    if (!result) return none(said.file->span, problem);
    return result;
  }
  std::vector<Texture> faces;
  for (std::size_t face = 0; face < said.faces.size(); ++face) {
    const auto& name = said.faces[face];
    if (!name) {
      return none(said.keyword,
                  fmt::format("the {} has no '{}'", block, (said.skybox ? sky_words : cube_words)[face]));
    }
    try {
      faces.emplace_back(images.read(place_of(name->value, folder, images)));
    } catch (const ImageError& e) {
      return none(name->span, fmt::format("cannot read '{}': {}", name->value, e.what()));
    }
  }
  return CubeMap(std::move(faces));
}

}  // namespace trace
