#include "scene/perlin_noise.hpp"

#include <array>
#include <cstdint>

namespace trace {
namespace {

// The numbers 0 to 255 in the order that Perlin published.
constexpr std::array<std::uint8_t, 256> permutation = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103, 30,
    69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,  197, 62,
    94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136,
    171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122,
    60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143, 54,  65,  25,  63,  161,
    1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196, 135, 130, 116, 188, 159, 86,
    164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124, 123, 5,   202, 38,  147, 118, 126,
    255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,  182, 189, 28,  42,  223, 183, 170, 213,
    119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,   129, 22,  39,  253,
    19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,  242, 193,
    238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,
    181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,
    222, 114, 67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180};

constexpr bool has_each_number_once() {
  std::array<bool, 256> seen{};
  for (const std::uint8_t n : permutation) {
    if (seen[n]) return false;
    seen[n] = true;
  }
  return true;
}
static_assert(has_each_number_once());

int hash(int n) {
  return permutation[static_cast<std::size_t>(n & 255)];
}

double fade(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

double mixed(double t, double a, double b) {
  return a + t * (b - a);
}

// The product of (x, y, z) with one of the twelve directions from a cube's centre to its edges.
double gradient(int corner, double x, double y, double z) {
  const int h = corner & 15;
  const double u = h < 8 ? x : y;
  const double v = h < 4 ? y : h == 12 || h == 14 ? x : z;
  return ((h & 1) == 0 ? u : -u) + ((h & 2) == 0 ? v : -v);
}

// The cell of a coordinate, of 256; at any distance.
int cell(double floor) {
  return static_cast<int>(floor - 256 * std::floor(floor / 256));
}

}  // namespace

double perlin_noise(const Vec3& p) {
  if (!is_finite(p)) return 0;
  const Vec3 corner = glm::floor(p), at = p - corner;
  const int x = cell(corner.x), y = cell(corner.y), z = cell(corner.z);
  const double u = fade(at.x), v = fade(at.y), w = fade(at.z);
  const auto on_edge = [&](int dy, int dz) {
    const auto value = [&](int dx) {
      const int h = hash(hash(hash(x + dx) + y + dy) + z + dz);
      return gradient(h, at.x - dx, at.y - dy, at.z - dz);
    };
    return mixed(u, value(0), value(1));
  };
  return mixed(w, mixed(v, on_edge(0, 0), on_edge(1, 0)), mixed(v, on_edge(0, 1), on_edge(1, 1)));
}

}  // namespace trace
