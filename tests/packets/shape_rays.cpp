#include "tests/packets/shape_rays.hpp"

namespace trace::test {
namespace {

Bounds bounds_of(const Shape& shape) {
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return cylinder->bounds();
  if (const auto* cone = std::get_if<Cone>(&shape)) return cone->bounds();
  if (std::holds_alternative<Sphere>(shape)) return {Vec3(-1), Vec3(1)};
  return {Vec3(-0.5), Vec3(0.5)};
}

Vec3 within(const Bounds& b, Random& random) {
  const double x = random.between(b.min.x, b.max.x);
  const double y = random.between(b.min.y, b.max.y);
  return {x, y, random.between(b.min.z, b.max.z)};
}

Vec3 any_direction(Random& random) {
  Vec3 result(0);
  while (!(glm::dot(result, result) > 1e-3)) result = random.in_cube(1);
  return glm::normalize(result);
}

Vec3 on_circle(double radius, double z, Random& random) {
  const double angle = random.below(4) == 0 ? random.below(4) * std::acos(0.0) : random.between(0, 6.3);
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

// On an edge, a corner, a rim, at a tip; of a sphere on a great circle.
Vec3 edge_of(const Shape& shape, Random& random) {
  if (const auto* cone = std::get_if<Cone>(&shape)) {
    const auto which = random.below(3);
    if (which == 0) return {0, 0, -cone->apex_offset()};
    return which == 1 ? on_circle(cone->bottom_radius(), 0, random)
                      : on_circle(cone->top_radius(), cone->height(), random);
  }
  if (std::holds_alternative<Cylinder>(shape)) return on_circle(1, random.below(2), random);
  if (std::holds_alternative<Sphere>(shape)) return on_circle(1, 0, random);
  Vec3 result(0.5);
  for (int axis = 0; axis < 3; ++axis) {
    if (random.below(2) == 0) result[axis] = -0.5;
  }
  if (std::holds_alternative<Square>(shape)) result.z = 0;
  if (random.below(2) == 0) result[static_cast<int>(random.below(3))] = random.between(-0.5, 0.5);
  return result;
}

struct Place {
  Vec3 point, normal;
};

// A place on the surface that a ray towards it meets.
Place on_surface(const Shape& shape, Random& random) {
  for (;;) {
    const Ray ray = ray_at(shape, RayKind::towards, random);
    const auto hit = meet(shape, ray);
    if (hit) return {ray.at(hit->t), hit->normal};
  }
}

double some_error(Random& random) {
  return random.below(2) == 0 ? 0 : std::pow(10.0, random.between(-17, -8));
}

}  // namespace

std::optional<LocalHit> meet(const Shape& shape, const Ray& ray) {
  LocalHit hit;
  const bool found = std::visit(
      [&](const auto& s) {
        if constexpr (requires { s.intersect(ray, hit); }) return s.intersect(ray, hit);
        return false;
      },
      shape);
  if (!found) return std::nullopt;
  return hit;
}

Ray ray_at(const Shape& shape, RayKind kind, Random& random) {
  const Bounds bounds = bounds_of(shape);
  const auto between = [](const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    return Ray{from, way == Vec3(0) ? Vec3(0, 0, 1) : glm::normalize(way)};
  };
  switch (kind) {
    case RayKind::towards: {
      const Vec3 origin = 5.0 * any_direction(random);
      return between(origin, within(bounds, random));
    }
    case RayKind::past: {
      const Vec3 origin = random.in_cube(5);
      return {origin, any_direction(random)};
    }
    case RayKind::inside: {
      const Vec3 origin = within(bounds, random);
      return {origin, any_direction(random)};
    }
    case RayKind::leaving: {
      const Place place = on_surface(shape, random);
      const Vec3 direction = any_direction(random);
      const double height = std::pow(10.0, random.between(-16, -14));
      const double cosine = std::abs(glm::dot(glm::normalize(place.normal), direction));
      return {place.point, direction, 4 * height, 4 * height / cosine};
    }
    case RayKind::on_grid: {
      const Vec3 origin = random.on_grid(8, 0.25);
      Vec3 direction(0);
      while (direction == Vec3(0)) {
        const Vec3 signs = random.on_grid(1, 1);
        direction = random.on_grid(1, 1);
        for (int axis = 0; axis < 3; ++axis) {
          if (direction[axis] == 0 && signs[axis] < 0) direction[axis] = -0.0;
        }
      }
      return {origin, glm::normalize(direction), some_error(random)};
    }
    case RayKind::far_away: {
      const Vec3 origin = 1e6 * any_direction(random);
      return between(origin, random.below(2) == 0 ? within(bounds, random) : edge_of(shape, random));
    }
    case RayKind::tiny: {
      const Place place = on_surface(shape, random);
      const double offset = random.between(-1e-6, 1e-6);
      return {place.point + offset * glm::normalize(place.normal), any_direction(random), some_error(random)};
    }
    case RayKind::tangent: {
      const Place place = on_surface(shape, random);
      const Vec3 along = glm::normalize(glm::cross(place.normal, any_direction(random)));
      const double distance = random.below(3) == 0 ? 0 : std::pow(10.0, random.between(-3, 4));
      return {place.point - distance * along, along, some_error(random)};
    }
    case RayKind::through_edge: {
      const Vec3 edge = edge_of(shape, random);
      const Vec3 way = random.below(2) == 0 ? any_direction(random) : within(bounds, random) - edge;
      return between(edge - std::pow(10.0, random.between(-3, 2)) * way, edge);
    }
    default: {
      const Vec3 from = edge_of(shape, random);
      Ray ray = between(from, edge_of(shape, random));
      if (random.below(2) == 0) ray.origin = ray.at(-random.between(0, 3));
      ray.origin_error = some_error(random);
      return ray;
    }
  }
}

}  // namespace trace::test
