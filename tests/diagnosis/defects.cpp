#include "tests/diagnosis/defects.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <stdexcept>

#include "loading/scene_loader.hpp"
#include "parser/parse.hpp"
#include "rendering/frame_renderer.hpp"
#include "rendering/pixel.hpp"
#include "scene/build.hpp"
#include "tests/support/scene_random.hpp"

namespace trace::test {
namespace {

std::uint8_t wrapped(double c) {
  return static_cast<std::uint8_t>(static_cast<std::int64_t>(255 * c) & 255);
}

Vec3 extent(const Bounds& bounds) {
  return bounds.max - bounds.min;
}

}  // namespace

Scene scene_of(const std::string& file) {
  FileImages images;
  LoadedScene loaded = load_scene(file, 256, images);
  if (!loaded.scene) throw std::runtime_error(loaded.messages);
  return std::move(*loaded.scene);
}

Scene scene_of_text(const std::string& text) {
  const auto source = parser::Source::from_text("test.ray", text);
  FileImages images;
  LoadedScene loaded = load_scene(source, 256, images);
  if (!loaded.scene) throw std::runtime_error(loaded.messages);
  return std::move(*loaded.scene);
}

Raster picture(const Scene& scene, const Way& way) {
  const SceneTree tree(scene);
  Progress progress;
  if (way.shift_x == 0 && way.shift_y == 0 && !way.tone && !way.wrap)
    return to_raster(render(scene, tree, way.options, progress).image);
  const int width = way.options.width, height = static_cast<int>(picture_height(scene, width));
  Image image{width, height, std::vector<std::uint8_t>(3UL * static_cast<std::size_t>(width * height))};
  FrameRenderer frame(scene, tree, way.options, height, 2, progress);
  frame.for_each_tile(32, [&](const FrameRenderer::Sampler& sampler, int x0, int y0, int x1, int y1) {
    for (int j = y0; j < y1; ++j)
      for (int i = x0; i < x1; ++i) {
        Rgb color = sampler.at((i + way.shift_x) / width, (j + way.shift_y) / height).value;
        if (way.tone) color = {way.tone(color.x), way.tone(color.y), way.tone(color.z)};
        if (!way.wrap) {
          set_pixel(image, i, j, color);
        } else {
          for (int c = 0; c < 3; ++c) pixel(image, i, j)[c] = wrapped(color[c]);
        }
      }
  });
  return to_raster(image);
}

Raster flipped(const Raster& picture, bool left_right, bool upside_down) {
  Raster result = picture;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const float* from =
          picture.pixel(left_right ? picture.width - 1 - x : x, upside_down ? picture.height - 1 - y : y);
      std::copy(from, from + 3, const_cast<float*>(result.pixel(x, y)));
    }
  return result;
}

Raster channels_swapped(const Raster& picture) {
  Raster result = picture;
  for (std::size_t i = 0; i < result.samples.size(); i += 3)
    std::swap(result.samples[i], result.samples[i + 2]);
  return result;
}

Raster toned(const Raster& picture, const Tone& tone) {
  Raster result = picture;
  for (float& sample : result.samples) sample = static_cast<float>(to_byte(clamped(tone(sample)))) / 255.0F;
  return result;
}

Raster noisy(const Raster& picture, int levels, std::uint32_t seed) {
  Random random(seed);
  Raster result = picture;
  for (float& sample : result.samples) {
    const double moved = sample + random.between(-levels, levels) / 255;
    sample = static_cast<float>(to_byte(clamped(moved))) / 255.0F;
  }
  return result;
}

Scene lights_scaled(Scene scene, double factor) {
  scene.ambient *= factor;
  for (Light& light : scene.lights) std::visit([&](auto& l) { l.color *= factor; }, light);
  return scene;
}

Scene without_light(Scene scene, std::size_t light) {
  scene.lights.erase(scene.lights.begin() + static_cast<std::ptrdiff_t>(light));
  return scene;
}

Scene ambient_scaled(Scene scene, double factor) {
  scene.ambient *= factor;
  return scene;
}

Scene without_object(Scene scene, std::size_t object) {
  scene.objects.erase(scene.objects.begin() + static_cast<std::ptrdiff_t>(object));
  return scene;
}

Scene moved_object(Scene scene, std::size_t object, const Vec3& by) {
  Object& moved = scene.objects[object];
  const Vec3 step = by * extent(moved.bounds);
  scene.frames.push_back(Frame(glm::translate(Mat4(1), step) * scene.frames[moved.frame].to_world));
  moved.frame = static_cast<std::uint32_t>(scene.frames.size() - 1);
  moved.bounds.min += step;
  moved.bounds.max += step;
  return scene;
}

Scene recolored_object(Scene scene, std::size_t object) {
  MappedMaterial material = scene.materials[scene.objects[object].material];
  for (Rgb* color : {&material.values.ambient, &material.values.diffuse})
    *color = Rgb(1 - color->y, color->x, 1 - color->z);
  material.diffuse = material.ambient = no_texture;
  scene.materials.push_back(material);
  scene.objects[object].material = static_cast<std::uint32_t>(scene.materials.size() - 1);
  return scene;
}

Scene changed_materials(Scene scene, const std::function<void(Material&)>& change) {
  for (MappedMaterial& material : scene.materials) change(material.values);
  for (SceneMesh& mesh : scene.meshes)
    for (Material& material : mesh.materials) change(material);
  return scene;
}

}  // namespace trace::test
