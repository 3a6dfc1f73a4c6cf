#include "tests/metamorphic/retold.hpp"

#include <stdexcept>

#include "loading/scene_loader.hpp"
#include "rendering/pixel.hpp"
#include "rendering/render.hpp"

namespace trace::test {

Image picture(const SceneText& scene, const Retelling& retelling, int width) {
  FileImages images;
  const LoadedScene loaded =
      load_scene(parser::Source::from_text(scene.name, text_of(scene, retelling)), width, images);
  if (!loaded.scene) throw std::runtime_error(loaded.messages);
  const SceneTree tree(*loaded.scene);
  RenderOptions options;
  options.width = width;
  options.depth = 4;
  Progress progress;
  return render(*loaded.scene, tree, options, progress).image;
}

Off compare(const Image& plain, const Image& retold, bool mirrored) {
  Off result;
  for (int row = 0; row < plain.height; ++row) {
    for (int column = mirrored ? 1 : 0; column < plain.width; ++column) {
      const std::uint8_t* a = pixel(plain, column, row);
      const std::uint8_t* b = pixel(retold, mirrored ? plain.width - column : column, row);
      ++result.pixels;
      for (int channel = 0; channel < 3; ++channel) {
        if (std::abs(a[channel] - b[channel]) <= 1) continue;
        ++result.off;
        break;
      }
    }
  }
  return result;
}

}  // namespace trace::test
