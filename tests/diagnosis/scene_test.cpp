// What a scene lacks: shadows, reflections, highlights, an object.
#include <catch2/catch.hpp>

#include "tests/diagnosis/diagnosed.hpp"

namespace trace::test {
namespace {

struct Change {
  const char* scene;
  const char* part;
  const char* instead;
  const char* text;
};

void check(const Change& change) {
  INFO(change.scene << ": " << change.part);
  CHECK(diagnosed(our_solution(change.scene),
                  picture(our_scene_with(change.scene, change.part, change.instead), right_way())) ==
        change.text);
}

}  // namespace

TEST_CASE("shadows that are switched off are missing") {
  for (const char* scene : {"features/sphere", "features/box", "features/cone", "features/camera_aspect",
                            "features/trimesh_polygons", "showcase/chess", "showcase/island"}) {
    Way way = right_way();
    way.options.shading.shadows = false;
    INFO(scene);
    CHECK(diagnosed(our_picture(scene), picture(our_scene(scene), way)) ==
          "shadows-missing: shadows are missing");
  }
}

TEST_CASE("a scene of mirrors at depth 0 lacks reflected light") {
  for (const char* scene :
       {"features/reflection", "features/reflection_depth", "showcase/hall_of_mirrors", "showcase/island"}) {
    Way way = right_way();
    way.options.depth = 0;
    INFO(scene);
    CHECK(diagnosed(our_picture(scene), picture(our_scene(scene), way)) ==
          "reflection-missing: reflected or refracted light is missing");
  }
}

TEST_CASE("highlights that are missing are told from reflections") {
  for (const char* scene :
       {"features/camera_tele", "features/material_inheritance", "features/antialias_off"}) {
    INFO(scene);
    CHECK(diagnosed(our_solution(scene),
                    picture(changed_materials(our_scene(scene), [](Material& m) { m.specular = Rgb(0); }),
                            right_way())) == "specular-missing: highlights are missing");
  }
}

TEST_CASE("an object that is taken out of the scene's text is missing, and the box says where") {
  check({"features/sphere", "translate(-1, 0.3, 2, scale(0.3, sphere {",
         "translate(-1, 0.3, 2000, scale(0, sphere {",
         "object-missing: an object is missing at (69, 121) to (101, 144)"});
  check({"features/sphere", "translate(0.9, 0.22, 2.3, scale(0.22,", "translate(0.9, 0.22, 2.3, scale(0,",
         "object-missing: an object is missing at (150, 130) to (172, 148)"});
  check({"features/box", "translate(-1.3, 0.25, 1.6, rotate(0, 1, 0, 0.9, scale(0.5,",
         "translate(-1.3, 0.25, 1.6, rotate(0, 1, 0, 0.9, scale(0,",
         "object-missing: an object is missing at (43, 118) to (69, 145)"});
  check({"features/cylinder", "translate(-0.9, 0.25, 1.6, rotate(0, 1, 0, 1.2, scale(0.25,",
         "translate(-0.9, 0.25, 1.6, rotate(0, 1, 0, 1.2, scale(0,",
         "object-missing: an object is missing at (78, 129) to (164, 162)"});
}

TEST_CASE("an object at another place is displaced, and the box holds both places") {
  check({"features/sphere", "translate(0, 1, 0, sphere {", "translate(0.3, 1.2, 0, sphere {",
         "object-displaced: an object is displaced within (82, 56) to (168, 125)"});
  check({"features/sphere", "translate(-1, 0.3, 2,", "translate(-1.6, 0.3, 2,",
         "object-displaced: an object is displaced within (45, 121) to (101, 144)"});
  check({"features/box", "translate(-1.3, 0.25, 1.6,", "translate(-1, 0.25, 1.9,",
         "object-displaced: an object is displaced within (43, 118) to (73, 152)"});
}

}  // namespace trace::test
