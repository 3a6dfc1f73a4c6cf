#include <fmt/format.h>

#include "image/png.hpp"
#include "rendering/render.hpp"
#include "tools/benchmark/kernels/mesh_scene.hpp"
#include "tools/benchmark/kernels/repeated.hpp"
#include "tools/benchmark/kernels/stages.hpp"

namespace trace::bench {

void measure_png(const PngArguments& arguments) {
  for (const int width : arguments.widths) {
    const Scene scene = read_scene(arguments.scene, width);
    const SceneTree tree(scene);
    RenderOptions options;
    options.width = width;
    Progress progress;
    const Image image = render(scene, tree, options, progress).image;
    const Times encoding = repeated(arguments.repetitions, [&] { return encode_png(image); });
    fmt::print("png width={} height={} bytes={} what=encode {}\n", image.width, image.height,
               encode_png(image).size(), encoding.text());
    const Times writing = repeated(arguments.repetitions, [&] {
      write_image(arguments.output, image);
      return 0;
    });
    fmt::print("png width={} height={} what=write {}\n", image.width, image.height, writing.text());
  }
}

}  // namespace trace::bench
