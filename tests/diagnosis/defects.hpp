// Pictures with one defect each, made by rendering the scene that way.
#pragma once

#include <functional>
#include <string>

#include "image/raster.hpp"
#include "rendering/render.hpp"

namespace trace::test {

// A colour of the renderer to one of the picture, before it is cut to bytes.
using Tone = std::function<double(double)>;

// How to render; what is not said is right.
struct Way {
  RenderOptions options;
  double shift_x = 0, shift_y = 0;  // of the samples, in pixels to the right and up
  Tone tone;
  bool wrap = false;  // bytes wrap around instead of being limited
};

// A scene file of the project or of the corpus. Throws where it has errors.
Scene scene_of(const std::string& file);

// The text of a scene in place of its file; textures are looked for in the current folder.
Scene scene_of_text(const std::string& text);

Raster picture(const Scene& scene, const Way& way);

// Pixels of the finished picture.
Raster flipped(const Raster& picture, bool left_right, bool upside_down);
Raster channels_swapped(const Raster& picture);
Raster toned(const Raster& picture, const Tone& tone);  // in bytes, truncated
Raster noisy(const Raster& picture, int levels, std::uint32_t seed);

// Changed scenes.
Scene lights_scaled(Scene scene, double factor);  // ambient light as well
Scene without_light(Scene scene, std::size_t light);
Scene ambient_scaled(Scene scene, double factor);
Scene without_object(Scene scene, std::size_t object);
Scene moved_object(Scene scene, std::size_t object, const Vec3& by);
Scene recolored_object(Scene scene, std::size_t object);
Scene changed_materials(Scene scene, const std::function<void(Material&)>& change);

}  // namespace trace::test
