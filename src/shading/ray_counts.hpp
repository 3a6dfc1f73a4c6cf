// How many rays of each kind were traced.
#pragma once

#include <cstdint>

namespace trace {

struct RayCounts {
  std::uint64_t primary = 0, reflected = 0, refracted = 0, shadow = 0;

  RayCounts& operator+=(const RayCounts& other) {
    primary += other.primary;
    reflected += other.reflected;
    refracted += other.refracted;
    shadow += other.shadow;
    return *this;
  }
  std::uint64_t total() const { return primary + reflected + refracted + shadow; }
};

}  // namespace trace
