#include "scene/torus_knot.hpp"

#include <algorithm>
#include <numbers>

namespace trace {
namespace {

constexpr std::uint32_t points_around = 48;
constexpr double most_rings = 8192;

// A place of the knot's surface: the angle around the axis, and around the tube.
class Strand {
 public:
  Strand(const TorusKnot& knot, double side) : knot_(knot), offset_(side * knot.p) {}

  Vec3 point(double a, double b) const {
    return (ring_radius(a) + knot_.tube * std::cos(b)) * outward(a) +
           Vec3(0, height(a) + knot_.tube * std::sin(b), 0);
  }

  // The product of the derivatives by b and a.
  Vec3 normal(double a, double b) const {
    const Vec3 by_b = knot_.tube * (Vec3(0, std::cos(b), 0) - std::sin(b) * outward(a));
    const Vec3 forward(std::cos(a), 0, -std::sin(a));  // of outward, by a
    const double angle = knot_.q * a, growth = knot_.q * offset_;
    const Vec3 by_a = (ring_radius(a) + knot_.tube * std::cos(b)) * forward +
                      growth * std::cos(angle) * outward(a) - Vec3(0, growth * std::sin(angle), 0);
    return glm::cross(by_a, by_b);
  }

  Vec3 middle(double a) const { return ring_radius(a) * outward(a) + Vec3(0, height(a), 0); }

 private:
  static Vec3 outward(double a) { return {std::sin(a), 0, std::cos(a)}; }
  double ring_radius(double a) const { return knot_.radius + offset_ * std::sin(knot_.q * a); }
  double height(double a) const { return offset_ * std::cos(knot_.q * a); }

  const TorusKnot& knot_;
  double offset_;
};

void add_vertex(Mesh& mesh, const Vec3& point, const Vec3& normal, const Vec2& coordinates) {
  mesh.points.push_back(point);
  mesh.normals.push_back(normal);
  mesh.coordinates.push_back(coordinates);
}

void add_face(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const std::uint32_t corners[] = {a, b, c};
  add_polygon(mesh, corners, 3);
}

double angle_of(std::uint32_t step, std::uint32_t steps) {
  return std::numbers::pi * (2.0 * step / steps - 1);
}

// Of two rings or rows that meet the points are the same to the last bit, so that there is no gap: the last
// of the tube are those of `next_strand` at its beginning, where there is one.
void add_tube(Mesh& mesh, const Strand& strand, const Strand* next_strand, std::uint32_t rings) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (std::uint32_t i = 0; i <= rings; ++i) {
    for (std::uint32_t j = 0; j <= points_around; ++j) {
      const bool is_next = next_strand && i == rings;
      const Strand& here = is_next ? *next_strand : strand;
      const double a = angle_of(is_next ? 0 : i, rings), b = angle_of(j % points_around, points_around);
      add_vertex(mesh, here.point(a, b), here.normal(a, b),
                 Vec2(static_cast<double>(i) / rings, static_cast<double>(j) / points_around));
    }
  }
  for (std::uint32_t i = 0; i < rings; ++i) {
    for (std::uint32_t j = 0; j < points_around; ++j) {
      const std::uint32_t here = first + i * (points_around + 1) + j, next = here + points_around + 1;
      add_face(mesh, here, next, next + 1);
      add_face(mesh, here, next + 1, here + 1);
    }
  }
}

// A disk at one end of a strand, facing away from it.
void add_end(Mesh& mesh, const Strand& strand, double a, bool is_last) {
  const Vec3 normal = (is_last ? 1.0 : -1.0) * Vec3(std::cos(a), 0, -std::sin(a));
  const auto middle = static_cast<std::uint32_t>(mesh.points.size());
  const Vec2 half(is_last ? 1 : 0, 0.5);
  add_vertex(mesh, strand.middle(a), normal, half);
  for (std::uint32_t j = 0; j <= points_around; ++j) {
    add_vertex(mesh, strand.point(a, angle_of(j % points_around, points_around)), normal,
               Vec2(half.x, static_cast<double>(j) / points_around));
  }
  for (std::uint32_t j = 1; j <= points_around; ++j) {
    add_face(mesh, middle, middle + (is_last ? j + 1 : j), middle + (is_last ? j : j + 1));
  }
}

}  // namespace

Mesh make_torus_knot(const TorusKnot& knot) {
  Mesh mesh;
  const auto rings = static_cast<std::uint32_t>(std::min(96 * (1 + std::abs(knot.q)), most_rings));
  const bool ends_meet = knot.p == 0 || 2 * knot.q == std::round(2 * knot.q);
  const bool by_itself = knot.p == 0 || knot.q == std::round(knot.q);
  for (const double side : {1.0, -1.0}) {
    if (side < 0 && knot.p == 0) break;
    const Strand strand(knot, side), next(knot, by_itself ? side : -side);
    add_tube(mesh, strand, ends_meet ? &next : nullptr, rings);
    if (ends_meet) continue;
    add_end(mesh, strand, -std::numbers::pi, false);
    add_end(mesh, strand, std::numbers::pi, true);
  }
  return mesh;
}

}  // namespace trace
