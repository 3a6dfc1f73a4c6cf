// Scenes as text that can be told in other words: elsewhere, larger, turned, mirrored, in another order.
#pragma once

#include <string>
#include <vector>

#include "geometry/vector.hpp"

namespace trace::test {

struct PointLightText {
  Vec3 position;
  Rgb color;
  double constant, linear, quadratic;  // of distances in the scene as it is described
};

struct DirectionalLightText {
  Vec3 direction;
  Rgb color;
};

struct MeshText {
  std::vector<Vec3> points;
  std::vector<std::vector<std::size_t>> faces;  // polygons
  bool smooth;                                  // with generated normals
  std::string material;                         // "{ ... }"
};

struct SceneText {
  std::string name;
  Vec3 eye, view, up;
  double fov;
  Rgb ambient;
  std::vector<PointLightText> points;
  std::vector<DirectionalLightText> directions;
  std::vector<std::string> elements;  // primitives within transforms
  std::vector<MeshText> meshes;
};

// The same scene in other words.
struct Retelling {
  std::string name;
  Mat4 place{1};          // of everything in it
  std::string opening;    // the text of `place`, before an element: "translate(1,2,3,"; ")" comes after
  double scale = 1;       // how much longer distances are
  bool mirrored = false;  // the picture comes out with left and right exchanged
  bool grouped = false;   // elements in nested groups
  bool reversed = false;  // elements in the opposite order
  bool baked = false;     // meshes have `place` in their points, not around them; not where it is mirrored
  // Corners of faces turned by one, points in the opposite order, and of meshes that are not smooth (whose
  // normals depend on how polygons are cut) polygons cut into triangles from their last corner.
  bool refaced = false;
};

// A number as the language reads it, back to the very double.
std::string number(double value);
// "(x, y, z)".
std::string triple(const Vec3& v);

std::string text_of(const SceneText& scene, const Retelling& retelling);

Retelling moved_by(const Vec3& offset, bool baked);
Retelling scaled_by(double factor, bool baked);
Retelling turned_by(double angle, const Vec3& axis);
Retelling mirrored_along(int axis);

}  // namespace trace::test
