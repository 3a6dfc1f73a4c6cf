#include "tests/hard/embree_mesh.hpp"

#ifdef TRACE_EMBREE
#include <embree3/rtcore.h>
#endif

namespace trace::hard {
namespace {

Vec3 nearest_floats(const Vec3& v) {
  return Vec3(glm::vec3(v));
}

Mesh nearest_floats(Mesh mesh) {
  for (Vec3& p : mesh.points) p = nearest_floats(p);
  return mesh;
}

}  // namespace

Ray EmbreeMesh::rounded(const Ray& ray) {
  return {nearest_floats(ray.origin), nearest_floats(ray.direction)};
}

#ifdef TRACE_EMBREE

struct EmbreeMesh::Scene {
  RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  RTCScene scene = rtcNewScene(device);

  explicit Scene(const Mesh& mesh) {
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.points.size()));
    for (const Vec3& p : mesh.points) {
      for (int axis = 0; axis < 3; ++axis) *points++ = static_cast<float>(p[axis]);
    }
    auto* faces = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.faces.size()));
    for (const FaceCorners& face : mesh.faces) faces = std::copy(face.begin(), face.end(), faces);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
  }
  ~Scene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
};

EmbreeMesh::EmbreeMesh(const Mesh& mesh)
    : rounded_(nearest_floats(mesh)), scene_(std::make_shared<const Scene>(rounded_)) {}

bool EmbreeMesh::closest(const Ray& ray, FaceHit& hit) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(ray.origin.x);
  query.ray.org_y = static_cast<float>(ray.origin.y);
  query.ray.org_z = static_cast<float>(ray.origin.z);
  query.ray.dir_x = static_cast<float>(ray.direction.x);
  query.ray.dir_y = static_cast<float>(ray.direction.y);
  query.ray.dir_z = static_cast<float>(ray.direction.z);
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit = {query.hit.primID, query.ray.tfar};
  return true;
}

#else

struct EmbreeMesh::Scene {};

EmbreeMesh::EmbreeMesh(const Mesh& mesh) : rounded_(nearest_floats(mesh)) {}

bool EmbreeMesh::closest(const Ray&, FaceHit&) const {
  return false;
}

#endif

}  // namespace trace::hard
