// The surroundings that a scene names itself.
#pragma once

#include <filesystem>
#include <optional>

#include "image/image_source.hpp"
#include "parser/description.hpp"
#include "parser/diagnostic.hpp"
#include "scene/cube_map.hpp"

namespace trace {

// Files are looked for from the scene's folder; where there is none of that name, '\' counts as '/'. None,
// and a warning at its place, where a face is missing or cannot be read.
std::optional<CubeMap> make_surroundings(const parser::Surroundings& said,
                                         const std::filesystem::path& folder, ImageSource& images,
                                         parser::Diagnostics& diagnostics);

}  // namespace trace
