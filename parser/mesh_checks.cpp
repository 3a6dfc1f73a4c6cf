#include "parser/mesh_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "parser/list_reader.hpp"

namespace trace::parser {

namespace {

std::string count_of(std::size_t count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

void check_corners(const Source& source, const Mesh& mesh, Diagnostics& diagnostics) {
  const std::size_t points = mesh.points.size() / 3;
  std::uint32_t largest = 0;  // without a way out, this takes many at a time
  for (const std::uint32_t corner : mesh.corners) largest = std::max(largest, corner);
  if (mesh.corners.empty() || largest < points) return;
  const auto wrong = [points](std::uint32_t corner) { return corner >= points; };
  const auto first = std::find_if(mesh.corners.begin(), mesh.corners.end(), wrong);

  const auto number = static_cast<std::uint64_t>(first - mesh.corners.begin());
  const auto list = std::find_if(mesh.face_lists.begin(), mesh.face_lists.end(),
                                 [number](const ListSpan& l) { return number < l.first + l.count; });
  const Span span = number_span(source, list->span, number - list->first);
  const std::string_view written = source.text().substr(span.begin, span.end - span.begin);
  const std::string has = points == 0   ? "the mesh has no points"
                          : points == 1 ? "the mesh has 1 point (0)"
                                        : fmt::format("the mesh has {} points (0 to {})", points, points - 1);
  Diagnostic& error = diagnostics.error(span, fmt::format("face index {} is out of range: {}", written, has));
  const auto more = std::count_if(first + 1, mesh.corners.end(), wrong);
  if (more > 0) {
    error.notes.push_back({span, fmt::format("{} more {} out of range in this mesh", more,
                                             more == 1 ? "index is" : "indices are")});
  }
}

void check_count(std::size_t count, std::size_t points, Span span, std::string_view one,
                 std::string_view many, Diagnostics& diagnostics) {
  if (count == 0 || count == points) return;
  diagnostics.error(span, fmt::format("the mesh has {} but {}: give one for each point or none",
                                      count_of(count, one, many), count_of(points, "point", "points")));
}

}  // namespace

void check_mesh(const Source& source, const Mesh& mesh, Span keyword, Diagnostics& diagnostics) {
  check_corners(source, mesh, diagnostics);
  const std::size_t points = mesh.points.size() / 3;
  const Span normals = mesh.normal_lists.empty() ? keyword : mesh.normal_lists.back().span;
  check_count(mesh.normals.size() / 3, points, {normals.begin, normals.begin + 1}, "normal", "normals",
              diagnostics);
  const Span pairs = mesh.coordinate_lists.empty() ? keyword : mesh.coordinate_lists.back().span;
  check_count(mesh.texture_coordinates.size() / 2, points, {pairs.begin, pairs.begin + 1},
              "texture coordinate", "texture coordinates", diagnostics);
  const Span materials = mesh.material_lists.empty() ? keyword : mesh.material_lists.back().list.span;
  check_count(mesh.vertex_materials.count(), points, {materials.begin, materials.begin + 1}, "material",
              "materials", diagnostics);
}

}  // namespace trace::parser
