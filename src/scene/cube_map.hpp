// Six pictures around the scene: the colour of every ray that hits nothing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/texture.hpp"

namespace trace {

class CubeMap {
 public:
  explicit CubeMap(std::vector<Texture> faces) : faces_(std::move(faces)) {}

  // Faces are in the order +x -x +y -y posz negz. With |d.x| the largest the x faces, else with |d.y| > |d.z|
  // the y faces, else the z faces, of which `posz` is seen along -z. No filtering across edges.
  // A direction of length zero or not finite sees the lower left corner of `negz`; of `posz` if its z is
  // negative.
  Rgb lookup(const Vec3& direction) const;
  // The same in another kind of number: float, double or long double.
  template <class T>
  glm::vec<3, T, glm::defaultp> lookup_in(const glm::vec<3, T, glm::defaultp>& direction) const;

  // In the order above.
  const std::vector<Texture>& faces() const { return faces_; }

 private:
  std::vector<Texture> faces_;
};

// `-c ONE_FACE`: the folder of that file is searched for the six faces by name: ".bmp" or ".png" in it, "pos"
// or "neg", and later an x, y or z. A name without "/" is the folder itself. Where the set is not complete
// the result is empty and `problem` says why.
std::optional<CubeMap> read_cube_map(const std::string& one_face, ImageSource& images, std::string& problem);

}  // namespace trace
