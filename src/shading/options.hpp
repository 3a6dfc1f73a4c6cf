// Switches of the shading model; the defaults are the course's.
#pragma once

#include <optional>
#include <string_view>

namespace trace {

// What a transmissive object leaves of the light that it stands in the way of.
enum class TransmissiveShadows {
  distance,  // the course's rule: each passage out of it leaves kt to the power of the way inside
  surface,   // kt for each passage out of it, however long the way was
  none,      // all: it casts no shadow
};
// "distance"
std::string_view name_of(TransmissiveShadows rule);
std::optional<TransmissiveShadows> transmissive_shadows_named(std::string_view name);

struct ShadingOptions {
  bool shadows = true;
  bool smooth_shading = true;       // meshes use their vertex normals
  bool backface_culling = true;     // primary and reflected rays pass mesh faces seen from behind
  bool internal_reflection = true;  // surfaces mirror on their inside too
  bool backface_specular = false;   // highlights of lights behind a transmissive surface

  // For the lights of dialects that have a size: n x n shadows of each (scene/light.hpp), and as many
  // mirrored rays of glossy surfaces. 1 to max_light_samples.
  int light_samples = 4;
  TransmissiveShadows transmissive_shadows = TransmissiveShadows::distance;

  // Ours: a mirrored or refracted ray that can carry less than this to the picture is not traced
  // (contribution.hpp); 0 to 1, and 0 traces them all.
  double least_contribution = 0;

  // Nothing is left out for adding nothing (scene/needs.hpp lists what that is): it is computed and thrown
  // away. The picture is the same.
  bool model_everything = false;

  // Fills RayCounts::work.
  bool count_work = false;
};

inline constexpr int max_light_samples = 64;

}  // namespace trace
