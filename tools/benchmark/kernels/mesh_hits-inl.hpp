// mesh_hit.hpp for packets.
#if defined(TRACE_BENCHMARK_MESH_HITS_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef TRACE_BENCHMARK_MESH_HITS_INL_HPP
#undef TRACE_BENCHMARK_MESH_HITS_INL_HPP
#else
#define TRACE_BENCHMARK_MESH_HITS_INL_HPP
#endif

#include "shading/packet/surfaces-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace trace::HWY_NAMESPACE {

struct MeshHits {
  Vectors point, normal;  // the normal of unit length, towards where the ray came from
  Numbers height, point_error;

  HWY_INLINE Rays leaving(const Vectors& direction) const {
    return leaving_rays(point, normal, height, point_error, direction);
  }
};

// Of the lanes `hit`, which it loses where numbers are so large or small that packets cannot carry them.
HWY_INLINE MeshHits mesh_hits_of(const Scene& scene, const Rays& rays, const Hits& hits, Mask& hit) {
  MeshHits result;
  result.point = rays.at(hits.t);
  result.normal = {0.0, 0.0, 1.0};
  result.height = 0.0;
  const Lanes objects(hits.object), part(hits.local.part);
  Mask odd = no_lanes();
  for (unsigned left = bits_of(hit); left != 0;) {
    const std::size_t first = first_lane(left);
    const Mask same = hit & (hits.object == Numbers(objects.at[first]));
    left &= ~bits_of(same);
    const Object& object = scene.objects[static_cast<std::size_t>(objects.at[first])];
    const Frame& frame = scene.frames[object.frame];
    const Mesh& mesh = scene.meshes[std::get<MeshId>(object.shape).index].geometry;
    const Faces face = faces_of(mesh, part, bits_of(same));
    const Vectors across = cross(face.ab, face.ac);
    const Numbers distance = distance_of_face(face, across, point_times(frame.to_object, result.point));
    const Numbers height =
        frame.to_world_stretch * (distance + bound_at(frame.error_bound(), largest(result.point)));
    Mask unusual = no_lanes();
    result.normal = select(same, world_normals(frame, normalized(across), unusual), result.normal);
    result.height = select(same, height, result.height);
    odd |= same & unusual;
  }
  hit = without(hit, odd);
  const Numbers cosine = dot(result.normal, rays.direction);
  result.normal = select(cosine > 0.0, -result.normal, result.normal);
  result.point_error = result.height / greater_of(abs(cosine), Numbers(least_cosine));
  return result;
}

}  // namespace trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
