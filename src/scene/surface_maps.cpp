#include "scene/surface_maps.hpp"

#include <algorithm>

#include "geometry/unit_vector.hpp"
#include "scene/shape.hpp"

namespace trace {
namespace {

const Mesh* mesh_of(const Scene& scene, const Object& object) {
  const auto* id = std::get_if<MeshId>(&object.shape);
  return id ? &scene.meshes[id->index].geometry : nullptr;
}

double repeated_one(double coordinate) {
  if (coordinate >= 0 && coordinate <= 1) return coordinate;
  return coordinate - std::floor(coordinate);
}

// The axis that the normal is nearest to.
int main_axis(const Vec3& normal) {
  const Vec3 size = glm::abs(normal);
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

// Where the pictures that turn normals are on objects without texture coordinates: seen along the axis that
// the normal is nearest to, as on a box of unit size, and repeated.
Vec2 planar_coordinates(int axis, const Vec3& p) {
  const int low = axis == 0 ? 1 : 0, high = axis == 2 ? 1 : 2;
  return repeated(Vec2(0.5 + p[low], 0.5 + p[high]));
}

Tangents planar_tangents(int axis) {
  const int low = axis == 0 ? 1 : 0, high = axis == 2 ? 1 : 2;
  Tangents result{Vec3(0), Vec3(0)};
  result.along_u[low] = result.along_v[high] = 1;
  return result;
}

// box.hpp: u falls along the lower axis on the faces -x, -y and -z.
Tangents box_tangents(const Vec3& normal) {
  const int axis = main_axis(normal);
  Tangents result = planar_tangents(axis);
  if (normal[axis] < 0) result.along_u = -result.along_u;
  return result;
}

// Heights of a map and their differences.
class Heights {
 public:
  explicit Heights(const Texture& texture) : texture_(texture) {}

  Vec2 slope(const Vec2& uv) const {
    return {along(uv, 0, texture_.width()), along(uv, 1, texture_.height())};
  }

 private:
  double at(const Vec2& uv) const { return luminance(texture_.sample(uv)); }

  // At the edges over what there is.
  double along(const Vec2& uv, int axis, int texels) const {
    if (texels < 2) return 0;
    const double step = std::max(1.0 / (texels - 1), 1.0 / 256);
    Vec2 low = uv, high = uv;
    low[axis] = std::max(uv[axis] - step, 0.0);
    high[axis] = std::min(uv[axis] + step, 1.0);
    return (at(high) - at(low)) / (high[axis] - low[axis]);
  }

  const Texture& texture_;
};

// n at right angles to t; unit length.
Vec3 square_to(const Vec3& n, const Vec3& t) {
  return unit_vector(t - glm::dot(t, n) * n).direction;
}

Vec3 from_normal_map(const Texture& map, const Vec2& uv, const Vec3& n, const Tangents& along) {
  const Vec3 t = square_to(n, along.along_u);
  // So that it goes with v, whichever way round the picture lies on the surface.
  Vec3 b = glm::cross(n, t);
  if (glm::dot(b, along.along_v) < 0) b = -b;
  const Vec3 texel = 2.0 * map.sample(uv) - 1.0;
  return unit_vector(texel.x * t + texel.y * b + texel.z * n).direction;
}

Vec3 from_bump_map(const Texture& map, const Vec2& uv, const Vec3& n, const Tangents& along) {
  const Vec3 t = square_to(n, along.along_u), b = square_to(n, along.along_v);
  // grad u is at right angles to b and n, and its product with t is 1 (all times |P_u|); grad v likewise.
  const Vec3 across_b = glm::cross(b, n), across_t = glm::cross(n, t);
  const double area = glm::dot(across_b, t);  // of t and b, with a sign: also dot(across_t, b)
  const Vec2 slope = Heights(map).slope(uv);
  return unit_vector(n - bump_height * (slope.x * across_b + slope.y * across_t) / area).direction;
}

// As mapped_normal() says of `direction`.
Vec3 kept_valid(Vec3 turned, const Vec3& n, const Vec3& direction) {
  const double side = glm::dot(direction, n);
  constexpr int most_steps = 16;  // then it is n to 2^-16
  for (int i = 0; i < most_steps; ++i) {
    const Vec3 mirrored = direction - 2 * glm::dot(direction, turned) * turned;
    if (!is_finite(mirrored)) return n;
    if (glm::dot(mirrored, n) * side < 0 && glm::dot(turned, n) > 0) return turned;
    turned = unit_vector(turned + n).direction;
  }
  return n;
}

}  // namespace

Vec2 repeated(const Vec2& uv) {
  if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return Vec2(0);
  return {repeated_one(uv.x), repeated_one(uv.y)};
}

Vec2 texture_coordinates(const Scene& scene, const Object& object, const LocalHit& hit, const Vec3& p) {
  const Mesh* mesh = mesh_of(scene, object);
  if (!mesh) return texture_coordinates(object.shape, hit, p);
  return mesh->has_coordinates() ? repeated(mesh->coordinates_at(hit.part, hit.uv)) : Vec2(0);
}

NormalPlace place_of_normals(const Scene& scene, const Object& object, const LocalHit& hit, const Vec3& p) {
  const int axis = main_axis(hit.normal);
  if (const Mesh* mesh = mesh_of(scene, object)) {
    if (mesh->has_coordinates())
      return {texture_coordinates(scene, object, hit, p), mesh->tangents(hit.part)};
  } else if (std::holds_alternative<Box>(object.shape)) {
    return {hit.uv, box_tangents(hit.normal)};
  } else if (std::holds_alternative<Square>(object.shape)) {
    return {hit.uv, planar_tangents(2)};
  }
  return std::visit(
      [&](const auto& shape) -> NormalPlace {
        if constexpr (requires { shape.texture_coordinates(p, p); }) {
          const auto coordinates = [&](const Vec3& q) { return shape.texture_coordinates(q, hit.normal); };
          return {coordinates(p), tangents_by_differences(coordinates, p, hit.normal)};
        }
        return {planar_coordinates(axis, p), planar_tangents(axis)};
      },
      object.shape);
}

Vec3 mapped_normal(const Scene& scene, const Object& object, const LocalHit& given, const Vec3& p,
                   const Vec3& normal, const Vec3& direction) {
  const MappedMaterial& material = scene.materials[object.material];
  if (!is_finite(normal) || !is_finite(p)) return normal;
  LocalHit hit = given;
  const Mesh* mesh = mesh_of(scene, object);
  if (mesh) hit.normal = face_normal(mesh->triangle(hit.part));
  const auto [uv, local] = place_of_normals(scene, object, hit, p);
  if (!local) return normal;
  const Mat3 to_world(scene.frames[object.frame].to_world);
  const std::optional<Tangents> along = checked({to_world * local->along_u, to_world * local->along_v});
  if (!along) return normal;
  Vec3 turned = normal;
  const auto texture = [&](TextureId id) -> const Texture& {
    return scene.textures[static_cast<std::size_t>(id)];
  };
  if (material.normal >= 0) turned = from_normal_map(texture(material.normal), uv, turned, *along);
  if (material.bump >= 0) turned = from_bump_map(texture(material.bump), uv, turned, *along);
  if (turned == normal) return normal;
  return kept_valid(turned, normal, direction);
}

}  // namespace trace
