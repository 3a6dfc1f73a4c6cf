#include "tests/hard/torus_rays.hpp"

#include "tests/hard/aimed_rays.hpp"

namespace trace::hard {
namespace {

constexpr double turn = 6.283185307179586;

double either_way(Random& random, double size) {
  return random.below(2) == 0 ? size : -size;
}

double small(Random& random) {
  const double size = std::pow(10.0, -random.between(1, 15));
  return either_way(random, size);
}

// Through `place` in a direction, from some way back.
Ray through(Random& random, const Vec3& place, const Vec3& direction, double size) {
  const Vec3 along = glm::normalize(direction);
  return {place - size * random.between(2, 20) * along, along};
}

// The directions at a place of the surface: out of it, round the axis, round the tube.
struct Directions {
  Vec3 outward, around, along;

  Directions(double a, double b)
      : outward(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)),
        around(-std::sin(a), std::cos(a), 0),
        along(-std::cos(a) * std::sin(b), -std::sin(a) * std::sin(b), std::cos(b)) {}
};

}  // namespace

Ray touching(Random& random, const RingShape& shape) {
  const double a = random.between(0, turn), b = random.between(0, turn), way = random.between(0, turn);
  const Directions at(a, b);
  const double above = shape.minor * small(random);
  return through(random, shape.place(a, b, above), std::cos(way) * at.around + std::sin(way) * at.along,
                 shape.reach());
}

// Where the surface's curvatures along the tube, 1 / r, and around the axis, cos b / (R + r cos b), differ in
// sign, the direction at an angle w from the axis' circles bends by neither: tan^2 w = -curvature around /
// curvature along.
Ray touching_inside(Random& random, const RingShape& shape) {
  const double a = random.between(0, turn), b = turn / 2 + random.between(-1, 1);
  const Directions at(a, b);
  const double around = -std::cos(b) / std::max(shape.major + shape.minor * std::cos(b), 1e-3 * shape.minor);
  const double way = either_way(random, std::atan(std::sqrt(shape.minor * around)));
  const double above = shape.minor * small(random);
  return through(random, shape.place(a, b, above), std::cos(way) * at.around + std::sin(way) * at.along,
                 shape.reach());
}

Ray beside_axis(Random& random, const RingShape& shape) {
  const double angle = random.between(0, turn);
  double distance = shape.reach() * random.between(0, 1.1);
  switch (random.below(4)) {
    case 0:
      distance = 0;
      break;
    case 1:
      distance = shape.reach() * (1 + 0x1p-52 * (static_cast<int>(random.below(9)) - 4));
      break;
    case 2:
      distance =
          std::abs(shape.major - shape.minor) * (1 + 0x1p-52 * (static_cast<int>(random.below(9)) - 4));
      break;
    default:
      break;
  }
  const double height = shape.reach() * random.between(-4, 4), up = either_way(random, 1);
  return {{distance * std::cos(angle), distance * std::sin(angle), height}, {0, 0, up}};
}

Ray in_plane(Random& random, const RingShape& shape) {
  const double angle = random.between(0, turn);
  const Vec3 beside(std::cos(angle), std::sin(angle), 0), along(-beside.y, beside.x, 0);
  double distance = shape.reach() * random.between(0, 1.1);
  const auto which = random.below(4);
  if (which == 0) distance = shape.reach() * (1 + small(random));
  if (which == 1) distance = std::abs(shape.major - shape.minor) * (1 + small(random));
  if (which == 2) distance = 0;
  return through(random, distance * beside, along, shape.reach());
}

Ray at_ring_from_afar(Random& random, const RingShape& shape) {
  const Vec3 target = 1.2 * random.in_cube(shape.reach());
  const double distance = shape.reach() * std::pow(10.0, random.between(0, 8));
  const Vec3 origin = target + distance * unit_vector(random);
  return {origin, glm::normalize(target - origin)};
}

Ray from_inside(Random& random, const RingShape& shape) {
  const double a = random.between(0, turn), b = random.between(0, turn);
  const Vec3 origin = shape.place(a, b, -shape.minor * random.between(0.01, 1));
  return {origin, unit_vector(random)};
}

}  // namespace trace::hard
