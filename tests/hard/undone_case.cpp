// Row 9: transforms and their undo.
#include <stdexcept>

#include "loading/scene_loader.hpp"
#include "tests/hard/batches.hpp"
#include "tests/hard/space_cases.hpp"
#include "tests/metamorphic/scene_text.hpp"

namespace trace::hard {
namespace {

constexpr int nested = 12;

std::string opening(const std::string& keyword, const Vec3& v) {
  const std::string values = test::triple(v);
  return keyword + values.substr(0, values.size() - 1) + ", ";
}

// Twelve transforms, then what undoes them from the last to the first, around a sphere.
std::string scene_text(Random& random) {
  std::vector<std::string> there, back;
  for (int i = 0; i < nested; ++i) {
    const Vec3 v = random.in_cube(2);
    switch (i % 3) {
      case 0:
        there.push_back(opening("translate", v));
        back.push_back(opening("translate", -v));
        break;
      case 1: {
        const double angle = random.between(-3, 3);
        there.push_back(opening("rotate", v) + test::number(angle) + ", ");
        back.push_back(opening("rotate", v) + test::number(-angle) + ", ");
        break;
      }
      default: {
        const Vec3 s = Vec3(0.7) + 0.3 * glm::abs(v);
        there.push_back(opening("scale", s));
        back.push_back(opening("scale", 1.0 / s));
      }
    }
  }
  std::string text = "SBT-raytracer 1.0\n";
  for (const std::string& t : there) text += t;
  for (auto t = back.rbegin(); t != back.rend(); ++t) text += *t;
  text += "sphere { }";
  return text.append(2 * nested, ')') + "\n";
}

std::vector<Row> run(std::uint64_t rays) {
  return in_batches(
      rays, 900, {Row(ours, "12 nested and their undo")},
      [](Random& random, std::uint64_t count, std::vector<Row>& out) {
        FileImages images;
        const LoadedScene loaded =
            load_scene(parser::Source::from_text("nested", scene_text(random)), 16, images);
        if (!loaded.scene || loaded.scene->objects.size() != 1) throw std::runtime_error(loaded.messages);
        const Frame& frame = loaded.scene->frames[loaded.scene->objects[0].frame];
        Digest digest;
        for (std::uint64_t i = 0; i < count; ++i) {
          const Ray ray{random.in_cube(1), glm::normalize(random.in_cube(1) + Vec3(0, 0, 1.5))};
          const ObjectRay object(frame, ray);
          const double difference = std::max(
              {glm::length(object.ray.origin - ray.origin), glm::length(object.ray.direction - ray.direction),
               std::abs(object.scale - 1), glm::length(frame.world_normal(ray.direction) - ray.direction)});
          digest.add(difference);
          ++out[0].rays;
          out[0].note_error(difference);
          if (!(difference <= 1e-12)) ++out[0].wrong;
        }
        out[0].digest = digest.value();
      },
      16);
}

}  // namespace

HardCase undone_case() {
  return {9,
          "12 nested transforms and their undo leave rays and normals as they were, within 1e-12",
          "Each of 24 matrices rounds, and so does an inverse that is computed from their product. The error "
          "is that of a ray's origin, direction and length, and of a normal.",
          1'600,
          160'000,
          run};
}

}  // namespace trace::hard
