// Light that reaches the surfaces of a packet: shading/local_shading.hpp and shadow.hpp for packets.
//
// `odd` collects the lanes in which anything happens that plain finite numbers do not say: their pixels are
// left to the scalar code as a whole, and what is computed for them from then on does not count.
#if defined(TRACE_SHADING_PACKET_LOCAL_SHADING_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_SHADING_PACKET_LOCAL_SHADING_INL_HPP
#undef TRACE_SHADING_PACKET_LOCAL_SHADING_INL_HPP
#else
#define TRACE_SHADING_PACKET_LOCAL_SHADING_INL_HPP
#endif

#include "shading/options.hpp"
#include "shading/packet/surfaces-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

// How many rays each lane's tree has.
struct LaneCounts {
  Numbers reflected, refracted, shadow;
};

// What all of a picture's packets are traced with.
struct PacketScene {
  const Scene& scene;
  const SceneTree& tree;
  const ShadingOptions& options;
  int depth;  // of the ray trees
};

// base to the power of exponent, as the library has it.
HWY_INLINE Numbers power(const Numbers& base, const Numbers& exponent, const Mask& some) {
  Lanes b(base);
  const Lanes e(exponent);
  for (const std::size_t i : each_lane(some)) {
    b.at[i] = std::pow(b.at[i], e.at[i]);
  }
  return b.numbers();
}

// shading/transmittance.hpp, where it is finite.
HWY_MAYBE_UNUSED static HWY_NOINLINE Vectors transmittances(const Vectors& kt, const Numbers& length,
                                                            const Mask& some, Mask& odd) {
  Vectors result;
  result.x = power(kt.x, length, without(some, kt.x == 1.0));
  // Equal channels have equal powers.
  const Mask y = some & !(kt.y == kt.x), z = some & !(kt.z == kt.x);
  result.y = any(y) ? select(y, power(kt.y, length, y), result.x) : result.x;
  result.z = any(z) ? select(z, power(kt.z, length, z), result.x) : result.x;
  odd |= without(some, all_finite(result));
  return result;
}

// shadow_attenuation() of shadow.hpp.
HWY_MAYBE_UNUSED static HWY_NOINLINE Vectors shadow_attenuations(const PacketScene& world, Rays rays,
                                                                 Numbers distance, Mask active,
                                                                 LaneCounts& counts, Mask& odd) {
  Vectors left(1.0, 1.0, 1.0);
  if (!world.options.shadows) return left;
  counts.shadow += where(active, 1.0);
  if (!world.scene.has_transmissive_objects) {
    const Mask dark = occluded(world.scene, world.tree, rays, active, distance);
    const Numbers light = select(dark, 0.0, 1.0);
    return {light, light, light};
  }
  for (;;) {
    Hits hits;
    closest(world.scene, world.tree, rays, active, false, hits);
    active = without(active, !(hits.t < distance));
    if (none(active)) return left;
    Surfaces surface;
    Mask unusual = no_lanes();
    surfaces_of(world.scene, rays, hits, active, world.options.smooth_shading, surface, unusual);
    odd |= unusual;
    active = without(active, unusual);
    const Mask opaque = active & is_zero(surface.material.transmissive);
    left = select(opaque, Vectors(0.0, 0.0, 0.0), left);
    active = without(active, opaque);
    const Mask leaves = active & (dot(surface.normal, rays.direction) > 0.0);
    if (any(leaves)) {
      const Vectors dimmed = left * transmittances(surface.material.transmissive, hits.t, leaves, odd);
      left = select(leaves, dimmed, left);
      odd |= without(leaves, all_finite(dimmed));
    }
    active = without(active, odd | ((surface.point.x == rays.origin.x) & (surface.point.y == rays.origin.y) &
                                    (surface.point.z == rays.origin.z)));
    if (none(active)) return left;
    rays = surface.leaving(rays.direction);
    distance -= hits.t;
    counts.shadow += where(active, 1.0);
  }
}

// LightSample; lanes that the light does not reach, or of which plain numbers do not tell, are taken out.
struct LightSamples {
  Vectors towards;
  Numbers distance;
  Numbers attenuation;
};

HWY_INLINE LightSamples sample_of(const DirectionalLight& light, const Vectors&, Mask& reached, Mask&) {
  const LightSample one = light.sample(Vec3(0));
  if (!one.reaches) reached = no_lanes();
  return {one.towards, one.distance, one.attenuation};
}

HWY_INLINE LightSamples sample_of(const PointLight& light, const Vectors& point, Mask& reached, Mask& odd) {
  const Vectors to_light = Vectors(light.position) - point;
  const Numbers square = dot(to_light, to_light);
  const Mask regular =
      (square >= std::numeric_limits<double>::min()) & (square <= std::numeric_limits<double>::max());
  odd |= without(reached, regular);
  reached &= regular;
  const Numbers s = sqrt(square);
  const Numbers f = Numbers(light.constant) + double{light.linear} * s + double{light.quadratic} * s * s;
  return {(1.0 / s) * to_light, s, select(f > 1.0, 1.0 / f, 1.0)};
}

// highlight_direction() of local_shading.cpp.
HWY_INLINE Vectors highlight_directions(const Vectors& normal, const Vectors& towards, const Numbers& cosine,
                                        const Mask& from_behind) {
  const Vectors in_front = (2.0 * select(cosine > 0.0, cosine, 0.0)) * normal - towards;
  const Mask behind = from_behind & (cosine < 0.0);
  if (none(behind)) return in_front;
  return select(behind, normalized((2.0 * -cosine) * normal - towards), in_front);
}

// The highlight's share. A power is finite below an exponent of a million, for the base is at most 1 and a
// few roundings; a surface without a specular colour then shows 0 times it, which is 0.
HWY_INLINE Numbers highlights(const Numbers& cosine, const Materials& material, const Mask& some) {
  const Numbers base = select(cosine > 0.0, cosine, 0.0);
  const Mask moderate = (material.shininess >= 0.0) & (material.shininess <= 1e6);
  const Mask asked = without(some, moderate & is_zero(material.specular));
  // 0 to the power of a positive number.
  const Mask dark = (base == 0.0) & (material.shininess > 0.0);
  return where(asked, power(base, material.shininess, without(asked, dark)));
}

template <class Light>
HWY_INLINE void add_light(const PacketScene& world, const Light& light, const Surfaces& surface,
                          const Vectors& normal, const Vectors& to_viewer, const Mask& lit, bool may_skip,
                          Vectors& color, LaneCounts& counts, Mask& odd) {
  Mask reached = without(lit, odd);
  const LightSamples sample = sample_of(light, surface.point, reached, odd);
  if (none(reached)) return;
  const Materials& material = surface.material;
  const Mask transmits = !is_zero(material.transmissive);
  const Numbers cosine = dot(normal, sample.towards);
  const Numbers diffuse = select(transmits, abs(cosine), select(cosine > 0.0, cosine, 0.0));
  const Mask from_behind = world.options.backface_specular ? transmits : no_lanes();
  const Vectors highlight = highlight_directions(normal, sample.towards, cosine, from_behind);
  const Numbers specular = highlights(dot(highlight, to_viewer), material, reached);
  const Vectors share = diffuse * material.diffuse + specular * material.specular;
  if (may_skip) reached = without(reached, is_zero(share));
  if (none(reached)) return;
  const Vectors shadow =
      shadow_attenuations(world, surface.leaving(sample.towards), sample.distance, reached, counts, odd);
  const Vectors received = ((sample.attenuation * Vectors(light.color)) * shadow) * share;
  const Vectors sum = color + received;
  odd |= without(reached, all_finite(sum));
  color = select(reached, sum, color);
}

// shade_locally()
HWY_MAYBE_UNUSED static HWY_NOINLINE Vectors shade_locally(const PacketScene& world, const Surfaces& surface,
                                                           const Vectors& toward_surface, const Mask& hit,
                                                           LaneCounts& counts, Mask& odd) {
  const Materials& material = surface.material;
  Vectors color = material.emissive + material.ambient * Vectors(world.scene.ambient);
  odd |= without(hit, all_finite(color) & all_finite(0.0 * surface.point + surface.normal));
  const Mask transmits = !is_zero(material.transmissive);
  const Mask back = dot(surface.normal, toward_surface) > 0.0;
  const Vectors normal = select(back, -surface.normal, surface.normal);
  Mask lit = without(hit, odd | without(back, transmits));
  odd |= without(lit, material.shininess >= 0.0);
  const bool may_skip = !world.scene.shadow_may_be_undefined;
  if (may_skip) lit = without(lit, is_zero(material.diffuse) & is_zero(material.specular));
  const Vectors to_viewer = -toward_surface;
  for (const Light& light : world.scene.lights) {
    if (none(without(lit, odd))) break;
    if (const auto* point = std::get_if<PointLight>(&light)) {
      add_light(world, *point, surface, normal, to_viewer, lit, may_skip, color, counts, odd);
    } else {
      add_light(world, std::get<DirectionalLight>(light), surface, normal, to_viewer, lit, may_skip, color,
                counts, odd);
    }
  }
  return color;
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
