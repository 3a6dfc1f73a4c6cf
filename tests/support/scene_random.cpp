#include "tests/support/scene_random.hpp"

#include "acceleration/mesh_gaps.hpp"

namespace trace::test {
namespace {

Mesh random_mesh(Random& random) {
  Mesh mesh;
  const std::uint32_t points = 3 + random.below(12);
  const bool on_grid = random.below(2) == 0;
  for (std::uint32_t i = 0; i < points; ++i)
    mesh.points.push_back(on_grid ? random.on_grid(1, 1) : random.in_cube(1));
  for (std::uint32_t i = 0; i < 2 * points; ++i) {
    const std::uint32_t corners[] = {random.below(points), random.below(points), random.below(points)};
    add_polygon(mesh, corners, 3);
  }
  return mesh;
}

// What is drawn first is drawn in a statement, or within braces, of its own: the order of arguments and
// operands is the compiler's, and the scenes shall not be.
Mat4 random_place(Random& random, double unit) {
  if (random.below(2) == 0) {
    Mat4 place = glm::translate(Mat4(1), unit * random.on_grid(4, 0.5)) * scaled(unit);
    if (random.below(2) == 0) {
      Vec3 axis(0);
      axis[static_cast<int>(random.below(3))] = 1;
      place = place * glm::rotate(Mat4(1), std::acos(0.0) * (1 + random.below(3)), axis);
    }
    return place;
  }
  const Vec3 offset = unit * random.in_cube(5);
  const double angle = random.between(0, 6);
  const Vec3 axis = random.in_cube(1) + Vec3(0, 0, 1.5);
  const Vec3 size = unit * (Vec3(0.3) + 0.7 * glm::abs(random.in_cube(1)));
  const Vec3 factors = random.below(4) == 0 ? -size : size;
  return glm::translate(Mat4(1), offset) * glm::rotate(Mat4(1), angle, axis) * glm::scale(Mat4(1), factors);
}

}  // namespace

bool nearest_face(const Mesh& mesh, const Ray& ray, bool cull, LocalHit& hit) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  hit.t = infinity;
  MeshGaps gaps;
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    const Triangle triangle = mesh.triangle(face);
    TriangleHit candidate;
    Meeting meeting = meets(triangle, ray, candidate);
    if (meeting == Meeting::unsure) meeting = meets_after_all(mesh.corners(face), ray, candidate);
    if (meeting == Meeting::none) continue;
    const bool from_behind = glm::dot(face_normal(triangle), ray.direction) > 0;
    if (cull && from_behind) continue;
    if (meeting == Meeting::hit) {
      if (candidate.t < hit.t) hit = {candidate.t, {0, 0, 1}, {candidate.u, candidate.v}, face, false};
    } else {
      gaps.add({candidate, face, meeting == Meeting::edge_gap, from_behind});
    }
  }
  const MeshGap* gap = gaps.nearest();
  if (gap && gap->hit.t < hit.t && !same_place(hit.t, gap->hit.t)) {
    hit = {gap->hit.t, {0, 0, 1}, {gap->hit.u, gap->hit.v}, gap->face, true};
  }
  return hit.t < infinity;
}

Scene random_scene(Random& random, int size, double unit) {
  Scene scene;
  for (int i = 0; i < size; ++i) {
    const Mat4 place = random_place(random, unit);
    switch (random.below(6)) {
      case 0:
        add(scene, Sphere{}, place, Material{});
        break;
      case 1:
        add(scene, Box{}, place, Material{});
        break;
      case 2:
        add(scene, Square{}, place, Material{});
        break;
      case 3:
        add(scene, Cylinder{}, place, Material{});
        break;
      case 4: {
        const double top_radius = random.between(0, 2);
        const bool capped = random.below(2) == 0;
        add(scene, Cone(1, top_radius, 1, capped), place, Material{});
        break;
      }
      default: {
        const Mesh mesh = random_mesh(random);
        if (!mesh.faces.empty()) add(scene, mesh, place, Material{});
      }
    }
  }
  return scene;
}

Ray random_ray(Random& random, double unit) {
  const Vec3 origin = unit * (random.below(2) == 0 ? random.on_grid(16, 0.25) : random.in_cube(8));
  Vec3 direction(0);
  while (direction == Vec3(0)) {
    switch (random.below(3)) {
      case 0:
        direction = random.on_grid(1, 1);
        break;  // an axis, or a diagonal of a face or of the cube
      case 1:
        direction = random.in_cube(1);
        direction *= random.on_grid(1, 1);
        break;  // zeros and negative zeros
      default:
        direction = unit * random.in_cube(3) - origin;  // towards the middle
    }
  }
  return {origin, glm::normalize(direction)};
}

Hit closest_of_all(const Scene& scene, const Ray& ray, bool cull) {
  Hit best, gap;
  for (std::uint32_t id = 0; id < scene.objects.size(); ++id) {
    const Object& object = scene.objects[id];
    if (!hits_bounds(object.bounds, ray)) continue;
    const ObjectRay local(scene.frames[object.frame], ray);
    LocalHit hit;
    const bool found = std::visit(
        [&](const auto& shape) {
          if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, MeshId>) {
            return nearest_face(scene.meshes[shape.index].geometry, local.ray, cull, hit);
          } else {
            return shape.intersect(local.ray, hit);
          }
        },
        object.shape);
    Hit& nearest = hit.is_gap ? gap : best;
    if (found && hit.t / local.scale < nearest.t) nearest = {hit.t / local.scale, id, hit};
  }
  return gap.t < best.t && !same_place(best.t, gap.t) ? gap : best;
}

}  // namespace trace::test
