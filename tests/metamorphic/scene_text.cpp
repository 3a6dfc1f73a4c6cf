#include "tests/metamorphic/scene_text.hpp"

#include <algorithm>
#include <charconv>
#include <glm/gtc/matrix_transform.hpp>

namespace trace::test {
namespace {

Vec3 point(const Retelling& r, const Vec3& p) {
  return Vec3(r.place * Vec4(p, 1));
}

// Without the scale: directions of the camera and of lights keep their length.
Vec3 direction(const Retelling& r, const Vec3& d) {
  return Vec3(r.place * Vec4(d, 0)) / r.scale;
}

std::string camera_text(const SceneText& scene, const Retelling& r) {
  return "camera { position = " + triple(point(r, scene.eye)) +
         "; viewdir = " + triple(direction(r, scene.view)) + "; updir = " + triple(direction(r, scene.up)) +
         "; fov = " + number(scene.fov) + "; aspectratio = 1; }\n";
}

// Attenuation is 1 / (a + b s + c s^2): with distances k times as long, b / k and c / k^2.
std::string lights_text(const SceneText& scene, const Retelling& r) {
  std::string text = "ambient_light { color = " + triple(scene.ambient) + "; }\n";
  for (const PointLightText& light : scene.points) {
    text += "point_light { position = " + triple(point(r, light.position)) +
            "; color = " + triple(light.color) + "; constant_attenuation_coeff = " + number(light.constant) +
            "; linear_attenuation_coeff = " + number(light.linear / r.scale) +
            "; quadratic_attenuation_coeff = " + number(light.quadratic / r.scale / r.scale) + "; }\n";
  }
  for (const DirectionalLightText& light : scene.directions) {
    text += "directional_light { direction = " + triple(direction(r, light.direction)) +
            "; color = " + triple(light.color) + "; }\n";
  }
  return text;
}

MeshText refaced(MeshText mesh) {
  std::reverse(mesh.points.begin(), mesh.points.end());
  std::vector<std::vector<std::size_t>> faces;
  for (std::vector<std::size_t>& face : mesh.faces) {
    for (std::size_t& corner : face) corner = mesh.points.size() - 1 - corner;
    std::rotate(face.begin(), face.begin() + (mesh.smooth && face.size() > 3 ? 0 : 1), face.end());
    if (mesh.smooth) {
      faces.push_back(face);
      continue;
    }
    for (std::size_t k = 2; k < face.size(); ++k) faces.push_back({face[k], face[0], face[k - 1]});
  }
  mesh.faces = std::move(faces);
  return mesh;
}

std::string mesh_text(const MeshText& given, const Retelling& r) {
  const MeshText mesh = r.refaced ? refaced(given) : given;
  std::string text = "trimesh { material = " + mesh.material + "; points = (";
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    text += (i > 0 ? ", " : "") + triple(r.baked ? point(r, mesh.points[i]) : mesh.points[i]);
  text += "); faces = (";
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    text += i > 0 ? ", (" : "(";
    for (std::size_t k = 0; k < mesh.faces[i].size(); ++k)
      text += (k > 0 ? "," : "") + std::to_string(mesh.faces[i][k]);
    text += ")";
  }
  return text + "); " + (mesh.smooth ? "gennormals; " : "") + "}";
}

std::string placed(const std::string& element, const Retelling& r) {
  return r.opening.empty() ? element : r.opening + element + ")";
}

}  // namespace

std::string number(double value) {
  char buffer[40];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  std::string text(buffer, result.ptr);
  text.erase(std::remove(text.begin(), text.end(), '+'), text.end());  // the language reads 1e7, not 1e+7
  return text;
}

std::string triple(const Vec3& v) {
  return "(" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ")";
}

std::string text_of(const SceneText& scene, const Retelling& r) {
  std::vector<std::string> elements;
  for (const std::string& element : scene.elements) elements.push_back(placed(element, r));
  for (const MeshText& mesh : scene.meshes)
    elements.push_back(r.baked ? mesh_text(mesh, r) : placed(mesh_text(mesh, r), r));
  if (r.reversed) std::reverse(elements.begin(), elements.end());
  std::string text = "SBT-raytracer 1.0\n" + camera_text(scene, r) + lights_text(scene, r);
  for (const std::string& element : elements)
    text += (r.grouped ? "{ translate(0, 0, 0, { scale(1, { " + element + " }) }) }" : element) + "\n";
  return text;
}

Retelling moved_by(const Vec3& offset, bool baked) {
  Retelling r;
  r.place = glm::translate(Mat4(1), offset);
  const std::string where = triple(offset);
  r.opening = "translate" + where.substr(0, where.size() - 1) + ", ";
  r.baked = baked;
  return r;
}

Retelling scaled_by(double factor, bool baked) {
  Retelling r;
  r.place = glm::scale(Mat4(1), Vec3(factor));
  r.opening = "scale(" + number(factor) + ", ";
  r.scale = factor;
  r.baked = baked;
  return r;
}

Retelling turned_by(double angle, const Vec3& axis) {
  Retelling r;
  r.place = glm::rotate(Mat4(1), angle, axis);
  const std::string about = triple(axis);
  r.opening = "rotate" + about.substr(0, about.size() - 1) + ", " + number(angle) + ", ";
  return r;
}

Retelling mirrored_along(int axis) {
  Retelling r;
  Vec3 factors(1);
  factors[axis] = -1;
  r.place = glm::scale(Mat4(1), factors);
  const std::string by = triple(factors);
  r.opening = "scale" + by.substr(0, by.size() - 1) + ", ";
  r.mirrored = true;
  return r;
}

}  // namespace trace::test
