#include "shading/secondary_direction.hpp"
#include "tools/benchmark/kernels/frame_rays.hpp"
#include "tools/benchmark/kernels/mesh_hit.hpp"

namespace trace::bench {
namespace {

void shadow(const SceneTree& tree, const MeshHit& hit, const LightSample& light, FrameCounts& counts) {
  ++counts.shadow;
  counts.occluded += tree.occluded(hit.leaving(light.towards), light.distance);
}

}  // namespace

FrameCounts single_frame(const Scene& scene, const SceneTree& tree, FrameSize size, Mode mode,
                         const Vec3& extra_light) {
  FrameCounts counts;
  const RayCaster caster(scene.camera);
  const PointLight extra{Rgb(1), extra_light};
  for_each_pixel(size, [&](int x, int y) {
    const Ray ray = caster.cast(double(x) / size.width, double(y) / size.height);
    const Hit found = tree.closest(ray, false);
    ++counts.primary;
    if (!found) return;
    ++counts.hits;
    counts.distances += found.t;
    if (mode == Mode::primary) return;
    const MeshHit hit(scene, ray, found);
    if (mode == Mode::one_shadow) {
      shadow(tree, hit, extra.sample(hit.point()), counts);
    } else if (mode == Mode::all_shadows) {
      for (const Light& light : scene.lights) {
        // The course's lights; scenes of dialects are not measured.
        LightSample sample{Vec3(0), 0, 0, false};
        if (const auto* point = std::get_if<PointLight>(&light)) sample = point->sample(hit.point());
        if (const auto* far = std::get_if<DirectionalLight>(&light)) sample = far->sample(hit.point());
        if (glm::dot(sample.towards, hit.normal()) > 0) shadow(tree, hit, sample, counts);
      }
    } else {
      ++counts.mirrored;
      const Hit next = tree.closest(hit.leaving(mirrored_direction(ray.direction, hit.normal())), false);
      if (next) counts.distances += next.t;
    }
  });
  return counts;
}

}  // namespace trace::bench
