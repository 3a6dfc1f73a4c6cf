#include <bit>

#include "tests/hard/aimed_rays.hpp"
#include "tests/hard/batches.hpp"
#include "tests/hard/closed_meshes.hpp"
#include "tests/hard/hierarchy_cases.hpp"

namespace trace::hard {
namespace {

// Objects that lie in one place, and others around them that change how the hierarchy is built.
struct Pile {
  Scene scene;
  std::uint32_t first;  // of the objects in one place, in the file
};

using Add = void (*)(Scene&, const Mat4&);

void add_filler(Scene& scene, Random& random) {
  const double side = random.below(2) == 0 ? 20 : -20;
  const Vec3 away = random.in_cube(1) + Vec3(0, 0, side);
  test::add(scene, Sphere{}, glm::translate(Mat4(1), away), Material{});
}

// `copies` of one object at `place`, each by the function at its turn, fillers between them.
Pile pile_up(Random& random, std::initializer_list<Add> copies, const Mat4& place) {
  Pile pile;
  for (std::uint32_t i = random.below(6); i > 0; --i) add_filler(pile.scene, random);
  pile.first = static_cast<std::uint32_t>(pile.scene.objects.size());
  for (const Add add : copies) {
    add(pile.scene, place);
    for (std::uint32_t i = random.below(6); i > 0; --i) add_filler(pile.scene, random);
  }
  return pile;
}

void square(Scene& scene, const Mat4& place) {
  test::add(scene, Square{}, place, Material{});
}
void box(Scene& scene, const Mat4& place) {
  test::add(scene, Box{}, place, Material{});
}
void mesh(Scene& scene, const Mat4& place) {
  // Each face twice: of equal ones the first in the file counts.
  Mesh twice = icosahedron_mesh();
  const std::vector<FaceCorners> faces = twice.faces;
  twice.faces.insert(twice.faces.end(), faces.begin(), faces.end());
  test::add(scene, twice, place, Material{});
}
void plane(Scene& scene, const Mat4& place) {
  test::add(scene, Square{}, place * test::scaled(4), Material{});
}
void box_on_plane(Scene& scene, const Mat4& place) {
  test::add(scene, Box{}, place * test::moved(0, 0, 0.5), Material{});
}

// The answers of hierarchies built around the same objects: the first in the file in each, at the same t.
void compare(Row& row, Digest& digest, Random& random, std::initializer_list<Add> copies, const Mat4& place,
             const Ray& ray) {
  std::uint64_t t = 0;
  for (int build = 0; build < 3; ++build) {
    const Pile pile = pile_up(random, copies, place);
    const Hit hit = SceneTree(pile.scene).closest(ray, false);
    ++row.rays;
    if (!hit) {
      ++row.misses;
    } else if (hit.object != pile.first || hit.local.part >= 20 ||
               (build > 0 && t != std::bit_cast<std::uint64_t>(hit.t))) {
      ++row.wrong;
    }
    t = std::bit_cast<std::uint64_t>(hit.t);
    digest.add_hit(hit ? hit.object - pile.first : ~0u, hit.t);
  }
}

std::vector<Row> run(std::uint64_t rays) {
  const std::vector<Row> names{
      Row(ours, "two squares"), Row(ours, "three boxes"), Row(ours, "two meshes, each face twice"),
      Row(ours, "box on a plane, seen along z"), Row(ours, "plane under a box, seen along z")};
  return in_batches(
      rays / 15, 11, names,
      [](Random& random, std::uint64_t in_batch, std::vector<Row>& rows) {
        std::vector<Digest> digests(rows.size());
        for (std::uint64_t i = 0; i < in_batch; ++i) {
          // Towards a point well within the object, from far enough away to be outside of it.
          const Vec3 at = random.on_grid(8, 0.25);
          const Mat4 turn = random_turn(random);
          const Mat4 turned = glm::translate(Mat4(1), at) * turn * test::scaled(random.between(0.5, 1.5));
          const Vec3 target =
              Vec3(turned * Vec4{0.2 * random.between(-1, 1), 0.2 * random.between(-1, 1), 0, 1});
          Vec3 sideways = unit_vector(random) * Vec3(1, 1, 0.5);
          sideways = glm::normalize(sideways + Vec3(1e-3, 0, 0));
          const Ray any{target - 4.0 * sideways, sideways};
          compare(rows[0], digests[0], random, {square, square}, turned, any);
          compare(rows[1], digests[1], random, {box, box, box}, turned, any);
          compare(rows[2], digests[2], random, {mesh, mesh}, turned, any);
          // From below, through the plane in which the bottom of the box lies; every number is exact.
          const Ray up{at + Vec3(0.125, -0.25, -2), {0, 0, 1}};
          compare(rows[3], digests[3], random, {box_on_plane, plane}, glm::translate(Mat4(1), at), up);
          compare(rows[4], digests[4], random, {plane, box_on_plane}, glm::translate(Mat4(1), at), up);
        }
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i].digest = digests[i].value();
      },
      64);
}

}  // namespace

HardCase coincident_case() {
  return {11,
          "of surfaces in one place the first in the file is seen, however the hierarchy is built",
          "Copies of an object, faces given twice and a box that rests on a plane have hits at the very same "
          "t, and the "
          "order in which a hierarchy comes to them depends on what else is in the scene. Hits are ordered "
          "by t and then "
          "by the place in the file.",
          6'000,
          3'000'000,
          run};
}

}  // namespace trace::hard
