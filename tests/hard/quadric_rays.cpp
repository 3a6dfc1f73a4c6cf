#include "tests/hard/quadric_rays.hpp"

#include "tests/hard/aimed_rays.hpp"

namespace trace::hard {
namespace {

constexpr double turn = 6.283185307179586;

// 1e-1 ... 1e-(digits), either way.
double small(Random& random, int digits) {
  const double size = std::pow(10.0, -random.between(1, digits));
  return random.below(2) == 0 ? size : -size;
}

// At `target`, from `distance` away in any direction.
Ray towards(Random& random, const Vec3& target, double distance) {
  const Vec3 origin = target + distance * unit_vector(random);
  return {origin, glm::normalize(target - origin)};
}

double widest(const RoundShape& shape) {
  return std::max(shape.bottom, shape.top);
}

// Below, within or above the shape, some way off its ends.
double some_height(Random& random, const RoundShape& shape) {
  return shape.height * random.between(-4, 5);
}

}  // namespace

Ray along_axis(Random& random, const RoundShape& shape) {
  const double angle = random.between(0, turn);
  double distance = widest(shape) * random.between(0, 1.5);
  if (random.below(2) == 0) {
    distance = random.below(2) == 0 ? shape.bottom : shape.top;
    distance *= 1 + 0x1p-52 * (static_cast<int>(random.below(9)) - 4);
  }
  return {{distance * std::cos(angle), distance * std::sin(angle), some_height(random, shape)},
          {0, 0, random.below(2) == 0 ? 1.0 : -1.0}};
}

Ray almost_along_axis(Random& random, const RoundShape& shape) {
  Ray ray = along_axis(random, shape);
  const double angle = random.between(0, turn), tilt = small(random, 12);
  ray.direction = glm::normalize(ray.direction + tilt * Vec3(std::cos(angle), std::sin(angle), 0));
  return ray;
}

Ray on_generator(Random& random, const RoundShape& shape) {
  const double angle = random.between(0, turn);
  const Vec3 bottom = shape.on_side(angle, 0), top = shape.on_side(angle, shape.height);
  const Vec3 along = glm::normalize(top - bottom);
  if (random.below(2) == 0) return {bottom - random.between(0.5, 5) * along, along};
  return {top + random.between(0.5, 5) * along, -along};
}

Ray along_generator(Random& random, const RoundShape& shape) {
  Ray ray = on_generator(random, shape);
  const Vec3 outward = glm::normalize(Vec3(ray.origin.x, ray.origin.y, 0));
  ray.origin += small(random, 9) * outward;
  return ray;
}

Ray tangent(Random& random, const RoundShape& shape) {
  const double angle = random.between(0, turn), z = shape.height * random.between(-0.1, 1.1);
  const Vec3 outward(std::cos(angle), std::sin(angle), 0);
  const Vec3 along_side = glm::normalize(shape.on_side(angle, shape.height) - shape.on_side(angle, 0));
  const Vec3 direction = glm::normalize(Vec3(-outward.y, outward.x, 0) + random.between(-1, 1) * along_side);
  const Vec3 touched = shape.on_side(angle, z) + small(random, 15) * outward;
  return {touched - random.between(0.5, 20) * direction, direction};
}

Ray at_rim(Random& random, const RoundShape& shape) {
  const double angle = random.between(0, turn), z = random.below(2) == 0 ? 0 : shape.height;
  const double distance = random.between(0.5, 20);
  return towards(random, shape.on_side(angle, z), distance);
}

Ray at_apex(Random& random, const RoundShape& shape) {
  const Vec3 target(0, 0, shape.height * shape.bottom / (shape.bottom - shape.top));
  const double distance = random.between(0.5, 20);
  return towards(random, target, distance);
}

Ray from_afar(Random& random, const RoundShape& shape) {
  const Vec3 target = 1.5 * random.in_cube(std::max(widest(shape), shape.height));
  const double distance = std::pow(10.0, random.between(0, 8));
  return towards(random, target, distance);
}

}  // namespace trace::hard
