#include "tests/hard/solids.hpp"

#include "tests/hard/closed_meshes.hpp"
#include "tests/support/scene_make.hpp"

namespace trace::hard {
namespace {

constexpr double cone_bottom = 1, cone_top = 0.25, cone_height = 1.5;

// A place on the surface or near it to aim at: anywhere, or at an edge.
Vec3 target_on(Random& random, SolidKind kind) {
  const Vec3 towards = unit_vector(random);
  const bool at_edge = random.below(4) == 0;
  const auto side = [&](double half) { return random.below(2) == 0 ? half : -half; };
  const auto near = [&](double x) { return steps_from(x, static_cast<int>(random.below(9)) - 4); };
  switch (kind) {
    case SolidKind::sphere:
      return (at_edge ? 1.0 - 1e-6 * fraction(random) : random.between(0, 1)) * towards;
    case SolidKind::box: {
      Vec3 p = random.in_cube(0.5);
      if (at_edge) p[0] = near(side(0.5)), p[1] = near(side(0.5));
      return at_edge && random.below(2) == 0 ? Vec3(p.z, p.x, p.y) : p;
    }
    case SolidKind::square:
      return {at_edge ? near(side(0.5)) : random.between(-0.5, 0.5), random.between(-0.5, 0.5), 0};
    case SolidKind::cylinder:
    case SolidKind::cone: {
      const double height = kind == SolidKind::cone ? cone_height : 1, turn = random.between(0, 6.283);
      const bool top = random.below(2) == 0;
      const double rim = kind == SolidKind::cone && top ? cone_top : 1;
      if (at_edge) return {near(rim * std::cos(turn)), rim * std::sin(turn), top ? height : 0};
      return {rim * random.between(-1, 1), rim * random.between(-1, 1), random.between(0, height)};
    }
    case SolidKind::mesh:
      break;
  }
  static const Mesh mesh = icosahedron_mesh();
  const Corners c = mesh.corners(random.below(20));
  const double v = at_edge ? 0 : fraction(random);
  const double u = fraction(random) * (1 - v);
  return c.a + u * (c.b - c.a) + v * (c.c - c.a);
}

// Outward, from where the object was hit; the square's towards the ray. In the space of the object.
Vec3 outward_normal(const Scene& scene, const Hit& hit, const Vec3& p) {
  const Shape& shape = scene.objects[hit.object].shape;
  if (const auto* id = std::get_if<MeshId>(&shape)) {
    return face_normal(scene.meshes[id->index].geometry.triangle(hit.local.part));
  }
  if (!std::holds_alternative<Cone>(shape)) return hit.local.normal;
  // The cone's own normals are the course's, neither outward nor always at right angles to it.
  if (hit.local.normal.x == 0 && hit.local.normal.y == 0) return {0, 0, p.z < cone_height / 2 ? -1 : 1};
  const double slope = (cone_bottom - cone_top) / cone_height;
  return {p.x, p.y, slope * std::sqrt(p.x * p.x + p.y * p.y)};
}

}  // namespace

std::string_view name_of(SolidKind kind) {
  constexpr std::string_view names[] = {"sphere", "box", "square", "cylinder", "cone", "mesh"};
  return names[static_cast<int>(kind)];
}

Solid random_solid(Random& random, SolidKind kind) {
  Solid solid{name_of(kind), {}, std::pow(10, random.between(-8, 8)), 0};
  const Vec3 stretch{1, std::pow(10, random.between(0, 2)), std::pow(10, random.between(0, 1))};
  solid.offset = random.below(4) == 0 ? 0 : std::min(1e8, solid.size * std::pow(10, random.between(-2, 6)));
  const Vec3 away = solid.offset * unit_vector(random);
  const Mat4 turn = random_turn(random);
  const Mat4 place = glm::translate(Mat4(1), away) * turn *
                     glm::scale(Mat4(1), solid.size * (random.below(4) == 0 ? -stretch : stretch));
  switch (kind) {
    case SolidKind::sphere:
      test::add(solid.scene, Sphere{}, place, Material{});
      break;
    case SolidKind::box:
      test::add(solid.scene, Box{}, place, Material{});
      break;
    case SolidKind::square:
      test::add(solid.scene, Square{}, place, Material{});
      break;
    case SolidKind::cylinder:
      test::add(solid.scene, Cylinder{}, place, Material{});
      break;
    case SolidKind::cone:
      test::add(solid.scene, Cone(cone_bottom, cone_top, cone_height, true), place, Material{});
      break;
    case SolidKind::mesh:
      test::add(solid.scene, icosahedron_mesh(), place, Material{});
  }
  return solid;
}

std::optional<Touch> touch(Random& random, const Solid& solid, const SceneTree& tree) {
  const Frame& frame = solid.scene.frames[0];
  SolidKind kind{};
  for (int i = 0; i < solid_kinds; ++i) {
    if (name_of(static_cast<SolidKind>(i)) == solid.name) kind = static_cast<SolidKind>(i);
  }
  const Vec3 target(frame.to_world * Vec4(target_on(random, kind), 1));
  const Vec3 towards = unit_vector(random);
  const Vec3 origin(frame.to_world * Vec4(random.between(4, 40) * towards, 1));
  Touch result{{origin, glm::normalize(target - origin)}, {}, Vec3(0), Vec3(0)};
  result.hit = tree.closest(result.ray, false);
  if (!result.hit) return std::nullopt;
  const ObjectRay local(frame, result.ray);
  result.local = local.ray.at(result.hit.local.t);
  result.outward = frame.world_normal(outward_normal(solid.scene, result.hit, result.local));
  return result;
}

}  // namespace trace::hard
