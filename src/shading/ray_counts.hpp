// How many rays of each kind were traced, and what was done or spared besides.
#pragma once

#include <cstdint>

namespace trace {

// Shadow rays that were not cast, by the reason. Each light of the scene counts once for each surface that is
// shaded: here, or as the start of a shadow ray.
struct SparedShadows {
  std::uint64_t culled = 0;            // a light that adds nothing in the whole scene (counting_lights.hpp)
  std::uint64_t from_back = 0;         // an opaque surface seen from its back
  std::uint64_t reflects_nothing = 0;  // a surface without diffuse and specular colour
  std::uint64_t out_of_reach = 0;      // a light with no direction from there, or no light there
  std::uint64_t behind = 0;            // the light is behind the surface, and no highlight is seen

  SparedShadows& operator+=(const SparedShadows& other) {
    culled += other.culled;
    from_back += other.from_back;
    reflects_nothing += other.reflects_nothing;
    out_of_reach += other.out_of_reach;
    behind += other.behind;
    return *this;
  }
  std::uint64_t total() const { return culled + from_back + reflects_nothing + out_of_reach + behind; }
  bool operator==(const SparedShadows&) const = default;
};

// Counted only where ShadingOptions::count_work asks for it.
struct WorkCounts {
  SparedShadows shadows;
  std::uint64_t faint = 0;         // mirrored and refracted rays below ShadingOptions::least_contribution
  std::uint64_t highlights = 0;    // powers of highlights that were taken
  std::uint64_t maps = 0;          // surfaces whose material was evaluated through its maps
  std::uint64_t surroundings = 0;  // lookups of the cube map

  WorkCounts& operator+=(const WorkCounts& other) {
    shadows += other.shadows;
    faint += other.faint;
    highlights += other.highlights;
    maps += other.maps;
    surroundings += other.surroundings;
    return *this;
  }
  bool operator==(const WorkCounts&) const = default;
};

struct RayCounts {
  std::uint64_t primary = 0, reflected = 0, refracted = 0, shadow = 0;
  WorkCounts work;

  RayCounts& operator+=(const RayCounts& other) {
    primary += other.primary;
    reflected += other.reflected;
    refracted += other.refracted;
    shadow += other.shadow;
    work += other.work;
    return *this;
  }
  std::uint64_t total() const { return primary + reflected + refracted + shadow; }
  bool operator==(const RayCounts&) const = default;
};

}  // namespace trace
