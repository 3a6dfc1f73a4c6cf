#include "tools/trace/render/statistics.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

namespace trace {

void Statistics::lap(Stage stage) {
  const Clock::time_point now = Clock::now();
  milliseconds_[static_cast<std::size_t>(stage)] =
      std::chrono::duration<double, std::milli>(now - last_).count();
  last_ = now;
}

std::string Statistics::report(const Scene& scene, const LoadTimes& load, const Rendered& rendered) const {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto ms = [&](Stage stage) { return milliseconds_[static_cast<std::size_t>(stage)]; };
  const RayCounts& rays = rendered.rays;
  return fmt::format(
      "scene    {} objects, {} triangles, {} lights, {} textures\n"
      "picture  {} x {}\n"
      "rays     {} primary, {} reflected, {} refracted, {} shadow\n"
      "time     {:.1f} ms start, {:.1f} ms load ({:.1f} read, {:.1f} parse, {:.1f} scene), {:.1f} ms build, "
      "{:.1f} ms render, {:.1f} ms write\n"
      "memory   {:.1f} MB at most\n",
      scene.objects.size(), scene.triangle_count(), scene.lights.size(), scene.textures.size(),
      rendered.image.width, rendered.image.height, rays.primary, rays.reflected, rays.refracted, rays.shadow,
      ms(Stage::start), ms(Stage::load), load.read, load.parse, load.build, ms(Stage::build),
      ms(Stage::render), ms(Stage::write), static_cast<double>(usage.ru_maxrss) / 1024.0);
}

}  // namespace trace
