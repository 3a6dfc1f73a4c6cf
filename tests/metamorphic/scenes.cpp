#include "tests/metamorphic/scenes.hpp"

namespace trace::test {
namespace {

// Eye and lights of all: from in front, above the floor y = 0.
SceneText stage(const std::string& name) {
  SceneText scene;
  scene.name = name;
  scene.eye = {0.37, 2.13, 7.41};
  scene.view = {-0.0517, -0.2131, -0.9757};
  scene.up = {-0.0113, 0.9770, -0.2128};
  scene.fov = 41;
  scene.ambient = Rgb(0.2, 0.22, 0.25);
  scene.points = {{{2.31, 4.87, 3.19}, {0.9, 0.85, 0.7}, 0.25, 0.05, 0.01}};
  scene.directions = {{{-0.41, -1.0, -0.53}, {0.45, 0.5, 0.6}}};
  return scene;
}

std::string matte(double r, double g, double b) {
  const std::string c = triple({r, g, b});
  return "{ ambient = " + c + "; diffuse = " + c + "; }";
}

std::string glass(double index) {
  return "{ specular = (0.4, 0.4, 0.4); shininess = 20; reflective = (0.1, 0.1, 0.1); transmissive = (1, 1, "
         "1); index = " +
         number(index) + "; }";
}

std::string mirror(double r, double g, double b) {
  return "{ diffuse = (0.1, 0.1, 0.1); reflective = " + triple({r, g, b}) + "; }";
}

std::string solid(const std::string& shape, const std::string& material) {
  return shape + " { material = " + material + " }";
}

std::string at(double x, double y, double z, const std::string& element) {
  return "translate(" + number(x) + ", " + number(y) + ", " + number(z) + ", " + element + ")";
}

std::string sized(double x, double y, double z, const std::string& element) {
  return "scale(" + number(x) + ", " + number(y) + ", " + number(z) + ", " + element + ")";
}

std::string turned(double x, double y, double z, double angle, const std::string& element) {
  return "rotate(" + number(x) + ", " + number(y) + ", " + number(z) + ", " + number(angle) + ", " + element +
         ")";
}

std::string floor_of(double size, const std::string& material) {
  return turned(1, 0, 0, -1.5707963267948966, sized(size, size, 1, solid("square", material)));
}

// Rings of `across` points between two poles; triangles at the poles, quads cut in two elsewhere.
MeshText ball(const Vec3& centre, double radius, std::size_t rings, std::size_t across,
              const std::string& material) {
  MeshText mesh{{centre + Vec3(0, radius, 0)}, {}, true, material};
  const double pi = std::acos(-1.0);
  for (std::size_t ring = 1; ring <= rings; ++ring) {
    const double polar = pi * static_cast<double>(ring) / static_cast<double>(rings + 1);
    for (std::size_t k = 0; k < across; ++k) {
      const double around = 2 * pi * (static_cast<double>(k) + 0.3) / static_cast<double>(across);
      mesh.points.push_back(centre + radius * Vec3(std::sin(polar) * std::cos(around), std::cos(polar),
                                                   std::sin(polar) * std::sin(around)));
    }
  }
  mesh.points.push_back(centre - Vec3(0, radius, 0));
  const auto on_ring = [&](std::size_t ring, std::size_t k) { return 1 + (ring - 1) * across + k % across; };
  for (std::size_t k = 0; k < across; ++k) {
    mesh.faces.push_back({0, on_ring(1, k + 1), on_ring(1, k)});
    for (std::size_t ring = 1; ring < rings; ++ring) {
      mesh.faces.push_back({on_ring(ring, k), on_ring(ring, k + 1), on_ring(ring + 1, k + 1)});
      mesh.faces.push_back({on_ring(ring, k), on_ring(ring + 1, k + 1), on_ring(ring + 1, k)});
    }
    mesh.faces.push_back({on_ring(rings, k), on_ring(rings, k + 1), mesh.points.size() - 1});
  }
  return mesh;
}

// Walls, a gable roof; pentagons and quads, corners counter-clockwise from outside.
MeshText house(const std::string& material) {
  return {{{-2.1, 0.03, -0.9},
           {-0.7, 0.03, -0.7},
           {-0.7, 1.1, -0.7},
           {-1.4, 1.7, -0.8},
           {-2.1, 1.1, -0.9},
           {-2.3, 0.03, -2.3},
           {-0.9, 0.03, -2.1},
           {-0.9, 1.1, -2.1},
           {-1.6, 1.7, -2.2},
           {-2.3, 1.1, -2.3}},
          {{0, 1, 2, 3, 4}, {9, 8, 7, 6, 5}, {1, 6, 7, 2}, {5, 0, 4, 9}, {2, 7, 8, 3}, {9, 4, 3, 8}},
          false,
          material};
}

}  // namespace

SceneText shadows_scene() {
  SceneText scene = stage("shadows");
  scene.elements = {floor_of(30, matte(0.7, 0.7, 0.65)),
                    at(-1.13, 0.71, 0.21, sized(0.7, 0.7, 0.7, solid("sphere", matte(0.8, 0.4, 0.3)))),
                    at(0.93, 0.53, -0.37, turned(0, 1, 0, 0.7, solid("box", matte(0.3, 0.6, 0.8)))),
                    at(0.21, 0.27, 1.61, sized(0.25, 0.25, 0.25, solid("sphere", matte(0.9, 0.8, 0.3)))),
                    at(-0.31, 1.9, -1.7, turned(1, 1, 0, 0.9, solid("box", matte(0.5, 0.8, 0.4))))};
  return scene;
}

SceneText glass_scene() {
  SceneText scene = stage("glass");
  scene.elements = {floor_of(30, matte(0.6, 0.7, 0.65)),
                    at(-0.83, 0.91, 0.61, sized(0.9, 0.9, 0.9, solid("sphere", glass(1.5)))),
                    at(1.21, 0.73, -0.17, turned(0, 1, 0.1, 0.5, solid("box", glass(1.3)))),
                    at(-1.31, 0.61, -2.13, sized(0.6, 0.6, 0.6, solid("sphere", matte(0.9, 0.3, 0.2)))),
                    at(0.77, 0.61, -2.41, sized(0.6, 1.2, 0.6, solid("box", matte(0.2, 0.4, 0.9))))};
  return scene;
}

SceneText mirrors_scene() {
  SceneText scene = stage("mirrors");
  scene.elements = {floor_of(30, matte(0.6, 0.6, 0.7)),
                    at(-1.03, 0.93, 0.31, sized(0.9, 0.9, 0.9, solid("sphere", mirror(0.8, 0.7, 0.6)))),
                    at(1.01, 0.81, 0.11, sized(0.8, 0.8, 0.8, solid("sphere", mirror(0.6, 0.8, 0.8)))),
                    at(0.13, 1.61, -2.3, sized(5, 3, 1, solid("square", mirror(0.7, 0.7, 0.7)))),
                    at(0.07, 0.33, 1.53, sized(0.3, 0.3, 0.3, solid("sphere", matte(0.9, 0.5, 0.2))))};
  return scene;
}

SceneText meshes_scene() {
  SceneText scene = stage("meshes");
  scene.elements = {floor_of(30, matte(0.7, 0.65, 0.6))};
  scene.meshes = {ball({0.71, 0.97, 0.19}, 0.9, 6, 11, matte(0.4, 0.7, 0.9)), house(matte(0.8, 0.6, 0.4))};
  return scene;
}

SceneText round_scene() {
  SceneText scene = stage("cylinders and cones");
  const std::string open =
      "cone { capped = false; bottom_radius = 0.9; top_radius = 0.3; height = 1.3; material = " +
      matte(0.8, 0.7, 0.3) + " }";
  const std::string pointed = "cone { height = 1.6; material = " + matte(0.4, 0.8, 0.5) + " }";
  scene.elements = {floor_of(30, matte(0.65, 0.65, 0.7)),
                    at(-1.53, 0.05, -0.21,
                       turned(1, 0, 0, -1.3, sized(0.6, 0.6, 1.4, solid("cylinder", matte(0.8, 0.4, 0.4))))),
                    at(0.31, 0.03, -0.83, turned(1, 0.05, 0, -1.57, pointed)),
                    at(1.61, 0.61, 0.83, turned(1, 1, 0, 0.8, sized(0.7, 0.7, 0.7, open))),
                    at(-0.23, 0.41, 1.71,
                       turned(0, 1, 0, 1.1, sized(0.3, 0.3, 0.9, solid("cylinder", mirror(0.6, 0.6, 0.6)))))};
  return scene;
}

SceneText box_scene() {
  SceneText scene = stage("box");
  scene.eye = {0.03, 1.01, 3.97};
  scene.view = {0, -0.0131, -0.9999};
  scene.up = {0, 0.9999, -0.0131};
  scene.points = {{{0.11, 1.83, 0.13}, {0.9, 0.9, 0.8}, 0.3, 0, 0.2}};
  scene.directions.clear();
  const double quarter = 1.5707963267948966;
  const auto wall = [&](const std::string& material) { return sized(2, 2, 1, solid("square", material)); };
  scene.elements = {
      at(0, 0, 0, turned(1, 0, 0, -quarter, wall(matte(0.7, 0.7, 0.7)))),
      at(0, 2, 0, turned(1, 0, 0, quarter, wall(matte(0.7, 0.7, 0.7)))),
      at(0, 1, -1, wall(matte(0.7, 0.7, 0.7))),
      at(-1, 1, 0, turned(0, 1, 0, quarter, wall(matte(0.8, 0.2, 0.2)))),
      at(1, 1, 0, turned(0, 1, 0, -quarter, wall(matte(0.2, 0.8, 0.2)))),
      at(-0.35, 0.6, -0.3, turned(0, 1, 0, 0.3, sized(0.6, 1.2, 0.6, solid("box", matte(0.7, 0.7, 0.7))))),
      at(0.4, 0.3, 0.3, turned(0, 1, 0, -0.3, sized(0.6, 0.6, 0.6, solid("box", mirror(0.6, 0.6, 0.6)))))};
  scene.meshes = {ball({0.4, 0.85, 0.3}, 0.25, 6, 11, matte(0.8, 0.7, 0.3))};
  return scene;
}

std::vector<SceneText> scenes_to_retell() {
  return {shadows_scene(), glass_scene(), mirrors_scene(), meshes_scene(), round_scene()};
}

}  // namespace trace::test
