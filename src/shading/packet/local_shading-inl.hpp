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

#include "shading/packet/surfaces-inl.hpp"
#include "shading/traced_scene.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

// What all of a picture's packets are traced with.
struct PacketScene {
  const TracedScene& traced;
  int depth;  // of the ray trees
  const Scene& scene = traced.scene();
  const SceneTree& tree = traced.tree();
  const ShadingOptions& options = traced.options();
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

// What each passage out of a transmissive surface leaves, by ShadingOptions::transmissive_shadows.
HWY_INLINE Vectors shadow_factors(const PacketScene& world, const Surfaces& surface, const Numbers& way,
                                  const Mask& some, Mask& odd) {
  switch (world.options.transmissive_shadows) {
    case TransmissiveShadows::distance:
      break;
    case TransmissiveShadows::surface:
      return surface.material.transmissive;
    case TransmissiveShadows::none:
      return {1.0, 1.0, 1.0};
  }
  return transmittances(surface.material.transmissive, way, some, odd);
}

// shadow_attenuation() of shadow.hpp.
HWY_MAYBE_UNUSED static HWY_NOINLINE Vectors shadow_attenuations(const PacketScene& world, Rays rays,
                                                                 Numbers distance, Mask active,
                                                                 LaneCounts& counts, Mask& odd) {
  Vectors left(1.0, 1.0, 1.0);
  if (!world.options.shadows) return left;
  counts.shadow += where(active, 1.0);
  if (!world.scene.has_transmissive_objects && !world.options.model_everything) {
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
    surfaces_of(world.scene, world.options, rays, hits, active, surface, unusual, counts);
    odd |= unusual;
    active = without(active, unusual);
    const Mask opaque = active & is_zero(surface.material.transmissive);
    left = select(opaque, Vectors(0.0, 0.0, 0.0), left);
    active = without(active, opaque);
    const Mask leaves = active & (dot(surface.normal, rays.direction) > 0.0);
    if (any(leaves)) {
      const Vectors dimmed = left * shadow_factors(world, surface, hits.t, leaves, odd);
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

// Lane by lane: what limits a beam has many branches.
HWY_INLINE LightSamples sample_of(const SpotLight& light, const Vectors& point, Mask& reached, Mask&) {
  const VectorLanes points(point);
  VectorLanes towards(Vectors(0.0, 0.0, 1.0));
  Lanes distance(1.0), attenuation(0.0);
  unsigned lit = 0;
  for (const std::size_t i : each_lane(reached)) {
    const LightSample one = light.sample(points[i]);
    if (!one.reaches) continue;
    lit |= 1u << i;
    towards.set(i, one.towards);
    distance.at[i] = one.distance;
    attenuation.at[i] = one.attenuation;
  }
  reached &= mask_of(lit);
  return {towards.vectors(), distance.numbers(), attenuation.numbers()};
}

// highlight_direction() of local_shading.cpp.
HWY_INLINE Vectors highlight_directions(const Vectors& normal, const Vectors& towards, const Numbers& cosine,
                                        const Mask& from_behind) {
  const Vectors in_front = (2.0 * select(cosine > 0.0, cosine, 0.0)) * normal - towards;
  const Mask behind = from_behind & (cosine < 0.0);
  if (none(behind)) return in_front;
  return select(behind, normalized((2.0 * -cosine) * normal - towards), in_front);
}

// The highlight's share, with needs_highlight() of local_shading.hpp; `always`: whether it does or not.
HWY_INLINE Numbers highlights(const Numbers& cosine, const Materials& material, const Mask& some, bool always,
                              const LaneCounts& counts) {
  const Numbers base = select(cosine > 0.0, cosine, 0.0);
  const Mask moderate = (material.shininess >= 0.0) & (material.shininess <= 1e6);
  Mask asked = without(some, moderate & is_zero(material.specular));
  if (always) asked = some;
  note(counts, &LaneWork::highlights, asked);
  // 0 to the power of a positive number.
  const Mask dark = (base == 0.0) & (material.shininess > 0.0);
  return where(asked, power(base, material.shininess, without(asked, dark)));
}

// Which surfaces a light is added to. The unlit ones show nothing of any light: they are here only where
// everything is modelled.
struct Lit {
  Mask lit, unlit;
};

template <class Light>
HWY_INLINE void add_light(const PacketScene& world, const Light& light, const Surfaces& surface,
                          const Vectors& normal, const Vectors& to_viewer, const Lit& which, bool may_skip,
                          Vectors& color, LaneCounts& counts, Mask& odd) {
  const bool everything = world.options.model_everything;
  const Mask asked = without(everything ? which.lit | which.unlit : which.lit, odd);
  Mask reached = asked;
  const LightSamples sample = sample_of(light, surface.point, reached, odd);
  note(counts, &LaneWork::out_of_reach, without(asked, reached));
  if (none(reached)) return;
  const Materials& material = surface.material;
  const Mask transmits = !is_zero(material.transmissive);
  const Numbers cosine = dot(normal, sample.towards);
  const Numbers diffuse = select(transmits, abs(cosine), select(cosine > 0.0, cosine, 0.0));
  const Mask from_behind = world.options.backface_specular ? transmits : no_lanes();
  const Vectors highlight = highlight_directions(normal, sample.towards, cosine, from_behind);
  const Numbers specular = highlights(dot(highlight, to_viewer), material, reached, everything, counts);
  const Vectors share = diffuse * material.diffuse + specular * material.specular;
  Mask adds = reached;
  if (may_skip) adds = without(reached, is_zero(share));
  if (everything) {
    adds = without(adds, which.unlit);
  } else {
    note(counts, &LaneWork::behind, without(reached, adds));
    reached = adds;
  }
  if (none(reached)) return;
  const Vectors shadow =
      shadow_attenuations(world, surface.leaving(sample.towards), sample.distance, reached, counts, odd);
  const Vectors received = ((sample.attenuation * Vectors(light.color)) * shadow) * share;
  const Vectors sum = color + received;
  odd |= without(adds, all_finite(sum));
  color = select(adds, sum, color);
}

// shade_locally()
HWY_MAYBE_UNUSED static HWY_NOINLINE Vectors shade_locally(const PacketScene& world, const Surfaces& surface,
                                                           const Vectors& toward_surface, const Mask& hit,
                                                           LaneCounts& counts, Mask& odd) {
  const Materials& material = surface.material;
  const std::vector<PlainLight>& lights = world.traced.lights();
  Vectors color = material.emissive + material.ambient * Vectors(world.scene.ambient);
  odd |= without(hit, all_finite(color) & all_finite(0.0 * surface.point + surface.normal));
  const Mask transmits = !is_zero(material.transmissive);
  const Mask back = dot(surface.normal, toward_surface) > 0.0;
  const Vectors normal = select(back, -surface.normal, surface.normal);
  const Mask unlit_back = without(back, transmits);
  Lit which;
  which.lit = without(hit, odd | unlit_back);
  odd |= without(which.lit, material.shininess >= 0.0);
  const bool may_skip = !world.scene.shadow_may_be_undefined;
  Mask dull = no_lanes();
  if (may_skip) {
    dull = which.lit & is_zero(material.diffuse) & is_zero(material.specular);
    which.lit = without(which.lit, dull);
  }
  which.unlit = dull | (hit & unlit_back);
  if (HWY_UNLIKELY(counts.work)) {
    note(counts, &LaneWork::culled, hit, world.traced.culled_lights());
    if (!world.options.model_everything) {
      note(counts, &LaneWork::from_back, hit & unlit_back, lights.size());
      note(counts, &LaneWork::reflects_nothing, dull, lights.size());
    }
  }
  const Mask asked = world.options.model_everything ? hit : which.lit;
  const Vectors to_viewer = -toward_surface;
  for (const PlainLight& light : lights) {
    if (none(without(asked, odd))) break;
    if (const auto* point = std::get_if<PointLight>(&light)) {
      add_light(world, *point, surface, normal, to_viewer, which, may_skip, color, counts, odd);
    } else if (const auto* spot = std::get_if<SpotLight>(&light)) {
      add_light(world, *spot, surface, normal, to_viewer, which, may_skip, color, counts, odd);
    } else {
      add_light(world, std::get<DirectionalLight>(light), surface, normal, to_viewer, which, may_skip, color,
                counts, odd);
    }
  }
  return color;
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
