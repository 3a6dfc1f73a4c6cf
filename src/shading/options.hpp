// Switches of the shading model; the defaults are the course's.
#pragma once

namespace trace {

struct ShadingOptions {
  bool shadows = true;
  bool smooth_shading = true;       // meshes use their vertex normals
  bool backface_culling = true;     // primary and reflected rays pass mesh faces seen from behind
  bool internal_reflection = true;  // surfaces mirror on their inside too
  bool backface_specular = false;   // highlights of lights behind a transmissive surface

  // Ours: a mirrored or refracted ray that can carry less than this to the picture is not traced
  // (contribution.hpp); 0 to 1, and 0 traces them all.
  double least_contribution = 0;

  // Nothing is left out for adding nothing (scene/needs.hpp lists what that is): it is computed and thrown
  // away. The picture is the same.
  bool model_everything = false;

  // Fills RayCounts::work.
  bool count_work = false;
};

}  // namespace trace
