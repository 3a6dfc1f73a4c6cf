// The surfaces that a packet of rays has hit: shading/surface.hpp for packets, lane by lane the same bits.
#if defined(TRACE_SHADING_PACKET_SURFACES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_SHADING_PACKET_SURFACES_INL_HPP
#undef TRACE_SHADING_PACKET_SURFACES_INL_HPP
#else
#define TRACE_SHADING_PACKET_SURFACES_INL_HPP
#endif

#include "acceleration/packet/scene-inl.hpp"
#include "scene/material_maps.hpp"
#include "scene/shape.hpp"
#include "scene/surface_maps.hpp"
#include "shading/options.hpp"
#include "shading/packet/counts-inl.hpp"
#include "shading/surface.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

// Of Material what shading asks for; `index` and `shininess` as the luminance of their triples.
struct Materials {
  Vectors emissive, ambient, diffuse, specular, reflective, transmissive;
  Numbers index, shininess;

  Materials() = default;
  HWY_INLINE explicit Materials(const Material& m)
      : emissive(m.emissive),
        ambient(m.ambient),
        diffuse(m.diffuse),
        specular(m.specular),
        reflective(m.reflective),
        transmissive(m.transmissive),
        index(luminance(m.index)),
        shininess(luminance(m.shininess)) {}
};

HWY_INLINE Materials select(const Mask& m, const Materials& yes, const Materials& no) {
  Materials result;
  result.emissive = select(m, yes.emissive, no.emissive);
  result.ambient = select(m, yes.ambient, no.ambient);
  result.diffuse = select(m, yes.diffuse, no.diffuse);
  result.specular = select(m, yes.specular, no.specular);
  result.reflective = select(m, yes.reflective, no.reflective);
  result.transmissive = select(m, yes.transmissive, no.transmissive);
  result.index = select(m, yes.index, no.index);
  result.shininess = select(m, yes.shininess, no.shininess);
  return result;
}

// Materials that differ from lane to lane.
struct MaterialLanes {
  VectorLanes emissive, ambient, diffuse, specular, reflective, transmissive;
  Lanes index, shininess;

  HWY_INLINE void set(std::size_t i, const Material& m) {
    emissive.set(i, m.emissive);
    ambient.set(i, m.ambient);
    diffuse.set(i, m.diffuse);
    specular.set(i, m.specular);
    reflective.set(i, m.reflective);
    transmissive.set(i, m.transmissive);
    index.at[i] = luminance(m.index);
    shininess.at[i] = luminance(m.shininess);
  }
  HWY_INLINE Materials materials() const {
    Materials m;
    m.emissive = emissive.vectors();
    m.ambient = ambient.vectors();
    m.diffuse = diffuse.vectors();
    m.specular = specular.vectors();
    m.reflective = reflective.vectors();
    m.transmissive = transmissive.vectors();
    m.index = index.numbers();
    m.shininess = shininess.numbers();
    return m;
  }
};

// Surface::leaving
HWY_INLINE Rays leaving_rays(const Vectors& point, const Vectors& facing, const Numbers& height,
                             const Numbers& point_error, const Vectors& direction) {
  const Numbers cosine = abs(dot(facing, direction));
  return {point, direction, point_error, where(cosine > least_cosine, 4.0 * height / cosine)};
}

struct Surfaces {
  Vectors point, normal, facing;
  Numbers height, point_error;
  Materials material;

  HWY_INLINE Rays leaving(const Vectors& direction) const {
    return leaving_rays(point, facing, height, point_error, direction);
  }
};

// What the points of a mesh have (`of_points`), for the three corners of each lane's face.
struct AtCorners {
  Vectors a, b, c;
};

HWY_INLINE AtCorners at_corners(const Mesh& mesh, const std::vector<Vec3>& of_points, const Lanes& part,
                                unsigned some) {
  VectorLanes a, b, c;
  for (const std::size_t i : each_lane(some)) {
    const FaceCorners& face = mesh.faces[static_cast<std::size_t>(part.at[i])];
    a.set(i, of_points[face[0]]);
    b.set(i, of_points[face[1]]);
    c.set(i, of_points[face[2]]);
  }
  return {a.vectors(), b.vectors(), c.vectors()};
}

// A corner and two edges of a face each.
struct Faces {
  Vectors a, ab, ac;
};

HWY_INLINE Faces faces_of(const Mesh& mesh, const Lanes& part, unsigned some) {
  const AtCorners points = at_corners(mesh, mesh.points, part, some);
  return {points.a, points.b - points.a, points.c - points.a};
}

// Mesh::smooth_normal
HWY_INLINE Vectors smooth_normals(const Mesh& mesh, const Lanes& part, const LocalHits& hits, unsigned some) {
  const AtCorners normals = at_corners(mesh, mesh.normals, part, some);
  return normalized((1.0 - hits.u - hits.v) * normals.a + hits.u * normals.b + hits.v * normals.c);
}

// Mesh::distance, from what was computed of the face.
HWY_INLINE Numbers distance_of_face(const Faces& face, const Vectors& normal, const Vectors& p) {
  const Vectors from_a = p - face.a;
  const Numbers error = gamma(16) * 2 * largest(face.ab) * largest(face.ac) * sum_of_sizes(from_a);
  return (abs(dot(from_a, normal)) + error) / sqrt(dot(normal, normal));
}

// Hits one by one, and their points in the space of the object.
struct LocalHitLanes {
  VectorLanes normal, p;
  Lanes u, v, part;

  HWY_INLINE LocalHitLanes(const LocalHits& hits, const Vectors& points)
      : normal(hits.normal), p(points), u(hits.u), v(hits.v), part(hits.part) {}
  HWY_INLINE LocalHit operator[](std::size_t i) const {
    LocalHit hit;
    hit.normal = normal[i];
    hit.uv = Vec2(u.at[i], v.at[i]);
    if (part.at[i] >= 0) hit.part = static_cast<std::uint32_t>(part.at[i]);  // of meshes
    return hit;
  }
};

// The surfaces of the lanes `some`, which all hit `object` at `result.point`, along `direction`; but for the
// point what is filled in for other lanes does not count. `unusual` gets those whose surface only the scalar
// code can tell.
HWY_MAYBE_UNUSED static HWY_NOINLINE void fill(const Scene& scene, const ShadingOptions& options,
                                               const Object& object, const Vectors& direction,
                                               const LocalHits& local, const Mask& some, Surfaces& result,
                                               Mask& unusual, const LaneCounts& counts) {
  const Frame& frame = scene.frames[object.frame];
  const MappedMaterial& material = scene.materials[object.material];
  const Vectors p = point_times(frame.to_object, result.point);
  const unsigned bits = bits_of(some);
  Vectors normal = local.normal, facing = normal;
  Numbers distance_to_surface;
  bool differs = false;
  if (const auto* id = std::get_if<MeshId>(&object.shape)) {
    const SceneMesh& mesh = scene.meshes[id->index];
    const Lanes part(local.part);
    const Faces face = faces_of(mesh.geometry, part, bits);
    const Vectors across = cross(face.ab, face.ac);
    normal = facing = normalized(across);
    distance_to_surface = distance_of_face(face, across, p);
    if (options.smooth_shading && mesh.geometry.smooth()) {
      normal = smooth_normals(mesh.geometry, part, local, bits);
      differs = true;
    }
    if (mesh.materials.empty()) {
      result.material = Materials(material.values);
    } else {
      MaterialLanes own;
      const Lanes u(local.u), v(local.v);
      for (const std::size_t i : each_lane(bits)) {
        own.set(i, mesh.material_at(static_cast<std::uint32_t>(part.at[i]), Vec2(u.at[i], v.at[i])));
      }
      result.material = own.materials();
    }
  } else {
    distance_to_surface =
        with_primitive(object.shape, [&](const auto& shape) HWY_ATTR { return distance(shape, p, normal); });
    if (std::holds_alternative<Cone>(object.shape)) {
      const Mask on_side = !((normal.x == 0.0) & (normal.y == 0.0));
      facing.z = select(on_side, 0.5 * normal.z, normal.z);
      differs = true;
    }
    if (!material.has_maps()) result.material = Materials(material.values);
  }
  if (evaluates_maps(scene, object, options.model_everything)) {
    MaterialLanes own;
    const LocalHitLanes hits(local, p);
    for (const std::size_t i : each_lane(bits)) {
      const Vec2 uv = texture_coordinates(scene, object, hits[i], hits.p[i]);
      own.set(i, at_point(material, scene.textures, uv, hits.p[i]));
    }
    result.material = own.materials();
    note(counts, &LaneWork::maps, some);
  }
  Mask odd = no_lanes();
  result.normal = world_normals(frame, normal, odd);
  // Where both are the same, so are the results.
  result.facing = differs ? world_normals(frame, facing, odd) : result.normal;
  if (material.turns_normals()) {
    const LocalHitLanes hits(local, p);
    const VectorLanes directions(direction);
    VectorLanes turned(result.normal);
    for (const std::size_t i : each_lane(bits)) {
      turned.set(i, mapped_normal(scene, object, hits[i], hits.p[i], turned[i], directions[i]));
    }
    result.normal = turned.vectors();
  }
  result.height =
      frame.to_world_stretch * (distance_to_surface + bound_at(frame.error_bound(), largest(result.point)));
  unusual |= material.has_extras() ? some : some & odd;
}

// The surfaces of the lanes `hit`; `unusual` gets those that only the scalar code can tell.
HWY_MAYBE_UNUSED static HWY_NOINLINE void surfaces_of(const Scene& scene, const ShadingOptions& options,
                                                      const Rays& rays, const Hits& hits, const Mask& hit,
                                                      Surfaces& result, Mask& unusual,
                                                      const LaneCounts& counts) {
  result.point = rays.at(hits.t);
  const Lanes objects(hits.object);
  unsigned left = bits_of(hit);
  const auto next_object = [&]() HWY_ATTR { return static_cast<std::size_t>(objects.at[first_lane(left)]); };
  // Mostly all of a packet hit the same object.
  for (bool first = true; left != 0; first = false) {
    const std::size_t id = next_object();
    const Mask same = hit & (hits.object == Numbers(static_cast<double>(id)));
    left &= ~bits_of(same);
    if (first) {
      fill(scene, options, scene.objects[id], rays.direction, hits.local, same, result, unusual, counts);
      continue;
    }
    Surfaces other;
    other.point = result.point;
    fill(scene, options, scene.objects[id], rays.direction, hits.local, same, other, unusual, counts);
    result.normal = select(same, other.normal, result.normal);
    result.facing = select(same, other.facing, result.facing);
    result.height = select(same, other.height, result.height);
    result.material = select(same, other.material, result.material);
  }
  result.point_error =
      result.height / greater_of(abs(dot(result.facing, rays.direction)), Numbers(least_cosine));
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
