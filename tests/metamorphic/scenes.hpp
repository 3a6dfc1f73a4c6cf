// The scenes that are told in other words. Numbers are odd on purpose: no pixel looks along an edge.
#pragma once

#include "tests/metamorphic/scene_text.hpp"

namespace trace::test {

SceneText shadows_scene();  // spheres and boxes on a floor, with two lights
SceneText glass_scene();    // clear glass, so that distances do not show in its colour
SceneText mirrors_scene();  // mirrors that see each other
SceneText meshes_scene();   // a smooth ball of few faces, and a house of polygons
SceneText round_scene();    // cylinders and cones
SceneText box_scene();      // a room like Cornell's, with two blocks and a ball

std::vector<SceneText> scenes_to_retell();  // the first five

}  // namespace trace::test
