#include "tests/hard/closed_meshes.hpp"

#include <numbers>

namespace trace::hard {
namespace {

using std::numbers::pi;

void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.faces.push_back({a, b, c});
  mesh.faces.push_back({a, c, d});
}

// Between two poles: the rings at these angles from +z, each with points at these angles around it.
Mesh around_z(int rings, const std::vector<double>& meridians) {
  Mesh mesh;
  const auto count = static_cast<std::uint32_t>(meridians.size());
  const auto last = static_cast<std::uint32_t>(rings) - 1;
  for (int ring = 1; ring <= rings; ++ring) {
    const double polar = pi * ring / (rings + 1);
    for (const double turn : meridians) {
      mesh.points.push_back(
          {std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)});
    }
  }
  const auto top = static_cast<std::uint32_t>(mesh.points.size()), bottom = top + 1;
  mesh.points.push_back({0, 0, 1});
  mesh.points.push_back({0, 0, -1});
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.faces.push_back({top, i, next});
    for (std::uint32_t ring = 0; ring < last; ++ring) {
      const std::uint32_t upper = ring * count, lower = upper + count;
      add_quad(mesh, upper + i, lower + i, lower + next, upper + next);
    }
    mesh.faces.push_back({bottom, last * count + next, last * count + i});
  }
  return mesh;
}

}  // namespace

Mesh sphere_mesh(int rings, int sectors) {
  std::vector<double> meridians;
  for (int i = 0; i < sectors; ++i) meridians.push_back(2 * pi * i / sectors);
  return around_z(rings, meridians);
}

Mesh sliver_sphere_mesh(int rings, int sectors, double apart) {
  std::vector<double> meridians;
  for (int i = 0; i < sectors; ++i) {
    meridians.push_back(2 * pi * i / sectors);
    meridians.push_back(2 * pi * i / sectors + apart);
  }
  return around_z(rings, meridians);
}

Mesh torus_mesh(int sectors, int sides) {
  Mesh mesh;
  for (int i = 0; i < sectors; ++i) {
    for (int j = 0; j < sides; ++j) {
      const double turn = 2 * pi * i / sectors, around = 2 * pi * j / sides;
      const double radius = 1 + 0.5 * std::cos(around);
      mesh.points.push_back({radius * std::cos(turn), radius * std::sin(turn), 0.5 * std::sin(around)});
    }
  }
  const auto point = [&](int i, int j) {
    return static_cast<std::uint32_t>((i % sectors) * sides + j % sides);
  };
  for (int i = 0; i < sectors; ++i) {
    for (int j = 0; j < sides; ++j) {
      add_quad(mesh, point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1));
    }
  }
  return mesh;
}

Mesh double_cone_mesh(int sectors) {
  return sphere_mesh(1, sectors);
}

Mesh icosahedron_mesh() {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Mesh mesh;
  mesh.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  return mesh;
}

Mesh placed(Mesh mesh, const Vec3& scale, const Vec3& offset) {
  for (Vec3& p : mesh.points) p = p * scale + offset;
  return mesh;
}

}  // namespace trace::hard
