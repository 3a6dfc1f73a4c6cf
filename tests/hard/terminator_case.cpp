// Row 13: the shadow terminator.
#include "tests/hard/batches.hpp"
#include "tests/hard/light_cases.hpp"
#include "tests/metamorphic/scenes.hpp"
#include "tests/support/scene_trace.hpp"

namespace trace::hard {
namespace {

Mesh smooth_ball() {
  const test::MeshText text = test::meshes_scene().meshes.at(0);
  Mesh mesh;
  mesh.points = text.points;
  for (const std::vector<std::size_t>& face : text.faces) {
    const std::uint32_t corners[] = {static_cast<std::uint32_t>(face.at(0)),
                                     static_cast<std::uint32_t>(face.at(1)),
                                     static_cast<std::uint32_t>(face.at(2))};
    add_polygon(mesh, corners, 3);
  }
  generate_normals(mesh);
  return mesh;
}

// A closed convex mesh: light comes to a face where it comes to the plane of the face, whatever the
// interpolated normal says.
void shoot(const Mesh& mesh, const Scene& scene, const SceneTree& tree, const Vec3& to_light, Random& random,
           Row& plain, Row& corrected, Digest& digest) {
  const std::uint32_t face = random.below(static_cast<std::uint32_t>(mesh.faces.size()));
  const double u = random.between(0.02, 0.49), v = random.between(0.02, 0.49);
  const Triangle triangle = mesh.triangle(face);
  const Vec3 flat = face_normal(triangle), smooth = mesh.smooth_normal(face, {u, v});
  const Vec3 point = triangle.a + u * triangle.ab + v * triangle.ac;
  const Vec3 way = glm::normalize(flat + random.in_cube(0.3));
  const double cosine = glm::dot(smooth, to_light);
  if (std::abs(glm::dot(flat, to_light)) < 1e-6 || glm::dot(smooth, way) < 1e-6) return;
  RayCounts counts;
  const ShadingOptions usual;
  const TracedScene world(scene, tree, usual);
  const Rgb seen = WhittedTracer(world, counts).trace({point + 3.0 * way, -way}, 0).value;
  digest.add(seen.x);
  const double lit = std::max(0.0, cosine);
  ++plain.rays;
  ++corrected.rays;
  // Cosine and weights round by some 2^-53 of a point three away.
  if (!(std::abs(seen.x - (glm::dot(flat, to_light) > 0 ? lit : 0)) <= 1e-12)) ++plain.wrong;
  if (!(std::abs(seen.x - lit) <= 1e-12)) ++corrected.wrong;
}

std::vector<Row> run(std::uint64_t rays) {
  const Mesh mesh = smooth_ball();
  Scene scene;
  test::add(scene, mesh, Mat4(1), test::diffuse(Rgb(1)));
  const Vec3 to_light = glm::normalize(Vec3(0.3, 0.8, 0.6));
  scene.lights = {test::directional(-to_light)};
  const SceneTree tree(scene);
  return in_batches(rays, 130, {Row(ours, "smooth ball of 132 faces"), Row("corrected", "the same")},
                    [&](Random& random, std::uint64_t count, std::vector<Row>& out) {
                      Digest digest;
                      for (std::uint64_t i = 0; i < count; ++i)
                        shoot(mesh, scene, tree, to_light, random, out[0], out[1], digest);
                      out[0].digest = digest.value();
                    });
}

}  // namespace

HardCase terminator_case() {
  return {
      13,
      "a smooth mesh of few faces keeps the course's shadow terminator",
      "Faces turned from the light are black although their interpolated normals are not. The course's "
      "pictures show it, so it is kept; \"corrected\" counts the places where a correction would be seen.",
      4'000,
      400'000,
      run};
}

}  // namespace trace::hard
