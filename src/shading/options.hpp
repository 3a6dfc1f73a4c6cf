// Switches of the shading model; the defaults are the course's.
#pragma once

namespace trace {

struct ShadingOptions {
  bool shadows = true;
  bool smooth_shading = true;       // meshes use their vertex normals
  bool backface_culling = true;     // primary and reflected rays pass mesh faces seen from behind
  bool internal_reflection = true;  // surfaces mirror on their inside too
  bool backface_specular = false;   // highlights of lights behind a transmissive surface
};

}  // namespace trace
