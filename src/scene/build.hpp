// From description to runtime scene.
#pragma once

#include "image/image_source.hpp"
#include "parser/diagnostic.hpp"
#include "parser/parse.hpp"
#include "scene/scene.hpp"

namespace trace {

// Composes transforms, inherits materials, opens textures from `images` (relative to the scene's folder),
// closes meshes. Takes the description apart as it goes, so that a large mesh is not held twice. Errors are
// added to `diagnostics` with their place; the result is complete only if there are none. Objects that cannot
// be seen (empty meshes, no inverse transform) are left out.
Scene build_scene(parser::Scene description, const parser::Source& source, ImageSource& images,
                  parser::Diagnostics& diagnostics);

}  // namespace trace
