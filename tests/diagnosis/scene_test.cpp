// What a scene lacks: shadows, reflections, highlights, an object.
#include <catch2/catch.hpp>

#include <iostream>
#include "tests/diagnosis/diagnosed.hpp"

namespace trace::test {

TEST_CASE("survey", "[.][survey]") {
  for (const char* dir : {"features", "showcase"})
    for (const auto& e :
         std::filesystem::directory_iterator(std::string(TRACE_SOURCE_DIR "/scenes/") + dir)) {
      if (e.path().extension() != ".ray") continue;
      const std::string name = std::string(dir) + "/" + e.path().stem().string();
      const Scene scene = our_scene(name);
      const Way right = right_way();
      const Raster reference = picture(scene, right);
      Way w = right;
      w.options.shading.shadows = false;
      std::cout << name << "\n  shadows " << diagnosed(reference, picture(scene, w)) << "\n";
      w = right;
      w.options.depth = 0;
      std::cout << "  depth0 " << diagnosed(reference, picture(scene, w)) << "\n";
      std::cout << "  specular "
                << diagnosed(
                       reference,
                       picture(changed_materials(scene, [](Material& m) { m.specular = Rgb(0); }), right))
                << "\n";
      std::cout << "  half ";
      w = right;
      w.shift_x = w.shift_y = .5;
      std::cout << diagnosed(reference, picture(scene, w)) << "\n";
      for (std::size_t i = 0; i < std::min<std::size_t>(scene.objects.size(), 8); ++i) {
        std::cout << "  obj " << i << " removed "
                  << diagnosed(reference, picture(without_object(scene, i), right)) << " | moved "
                  << diagnosed(reference, picture(moved_object(scene, i, Vec3(0.4, 0.3, 0)), right)) << "\n";
      }
    }
}

}  // namespace trace::test
