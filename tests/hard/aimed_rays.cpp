#include "tests/hard/aimed_rays.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace trace::hard {

double steps_from(double x, int steps) {
  for (; steps > 0; --steps) x = std::nextafter(x, std::numeric_limits<double>::infinity());
  for (; steps < 0; ++steps) x = std::nextafter(x, -std::numeric_limits<double>::infinity());
  return x;
}

double fraction(Random& random) {
  const std::uint64_t high = random.below(1u << 26), low = random.below(1u << 26);
  return static_cast<double>(high << 26 | low) * 0x1p-52;
}

Vec3 unit_vector(Random& random) {
  for (;;) {
    const Vec3 v = random.in_cube(1);
    const double squared = glm::dot(v, v);
    if (squared > 0.01 && squared <= 1) return glm::normalize(v);
  }
}

Mat4 random_turn(Random& random) {
  const Vec3 axis = unit_vector(random);
  return glm::rotate(Mat4(1), random.between(0, 6), axis);
}

Ray aimed_at_edges(Random& random, const Mesh& mesh, const Vec3& origin) {
  const FaceCorners& face = mesh.faces[random.below(static_cast<std::uint32_t>(mesh.faces.size()))];
  const std::uint32_t side = random.below(3);
  const Vec3 &a = mesh.points[face[side]], &b = mesh.points[face[(side + 1) % 3]];
  Vec3 target = a;
  switch (random.below(3)) {
    case 0:
      break;
    case 1:
      target = 0.5 * a + 0.5 * b;
      break;
    default:
      target = a + fraction(random) * (b - a);
  }
  Ray ray{origin, glm::normalize(target - origin)};
  if (random.below(2) == 0) {
    const int steps = 1 << random.below(7);
    double& coordinate = ray.direction[static_cast<int>(random.below(3))];
    coordinate = steps_from(coordinate, random.below(2) == 0 ? steps : -steps);
  }
  return ray;
}

}  // namespace trace::hard
