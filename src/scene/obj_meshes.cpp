#include "scene/obj_meshes.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <unordered_map>

namespace trace {
namespace {

struct CornerKey {
  std::uint32_t point, coordinates, normal;
  bool operator==(const CornerKey&) const = default;
};

struct CornerHash {
  std::size_t operator()(const CornerKey& key) const {
    // Fibonacci hashing, three times over.
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;
    std::uint64_t h = key.point * golden;
    h = (h ^ (h >> 29) ^ key.coordinates) * golden;
    h = (h ^ (h >> 29) ^ key.normal) * golden;
    return static_cast<std::size_t>(h ^ (h >> 32));
  }
};

// The points of one part, as its mesh numbers them.
class PartBuilder {
 public:
  PartBuilder(const ObjFile& file, bool has_normals, bool has_coordinates)
      : file_(file), has_normals_(has_normals), has_coordinates_(has_coordinates) {}

  void add(const ObjFile::Face& face) {
    polygon_.clear();
    for (std::uint32_t i = 0; i < face.size; ++i)
      polygon_.push_back(index_of(file_.corners[face.first_corner + i]));
    add_polygon(mesh_, polygon_.data(), face.size);
  }

  Mesh take(bool generate) {
    if (generate && !has_normals_) generate_shared_normals();
    return std::move(mesh_);
  }

 private:
  std::uint32_t index_of(const ObjCorner& corner) {
    const CornerKey key{corner.point, has_coordinates_ ? corner.coordinates : 0,
                        has_normals_ ? corner.normal : 0};
    const auto [entry, is_new] = indices_.try_emplace(key, static_cast<std::uint32_t>(mesh_.points.size()));
    if (is_new) {
      mesh_.points.push_back(file_.points[corner.point]);
      if (has_normals_) mesh_.normals.push_back(file_.normals[corner.normal]);
      if (has_coordinates_) mesh_.coordinates.push_back(file_.coordinates[corner.coordinates]);
      points_of_file_.push_back(corner.point);
    }
    return entry->second;
  }

  void generate_shared_normals() {
    std::unordered_map<std::uint32_t, std::pair<Vec3, double>> sums;
    for (std::uint32_t f = 0; f < mesh_.faces.size(); ++f) {
      const Vec3 normal = face_normal(mesh_.triangle(f));
      if (!is_finite(normal)) continue;
      for (const std::uint32_t corner : mesh_.faces[f]) {
        auto& [sum, count] = sums.try_emplace(points_of_file_[corner], Vec3(0), 0.0).first->second;
        sum += normal;
        ++count;
      }
    }
    for (const std::uint32_t point : points_of_file_) {
      const auto found = sums.find(point);
      mesh_.normals.push_back(found == sums.end() ? Vec3(0) : found->second.first / found->second.second);
    }
  }

  const ObjFile& file_;
  bool has_normals_, has_coordinates_;
  Mesh mesh_;
  std::vector<std::uint32_t> points_of_file_;  // of each point of the mesh
  std::unordered_map<CornerKey, std::uint32_t, CornerHash> indices_;
  std::vector<std::uint32_t> polygon_;
};

}  // namespace

std::vector<ObjPart> parts_of(const ObjFile& file, bool generate) {
  struct What {
    bool normals = true, coordinates = true;
  };
  std::map<std::int32_t, What> what;
  std::vector<std::int32_t> order;
  for (const ObjFile::Face& face : file.faces) {
    const auto [entry, is_new] = what.try_emplace(face.material);
    if (is_new) order.push_back(face.material);
    for (std::uint32_t i = 0; i < face.size; ++i) {
      const ObjCorner& corner = file.corners[face.first_corner + i];
      entry->second.normals &= corner.normal != ObjCorner::none;
      entry->second.coordinates &= corner.coordinates != ObjCorner::none;
    }
  }
  std::map<std::int32_t, PartBuilder> builders;
  for (const auto& [material, has] : what) builders.try_emplace(material, file, has.normals, has.coordinates);
  for (const ObjFile::Face& face : file.faces) builders.at(face.material).add(face);
  std::vector<ObjPart> parts;
  for (const std::int32_t material : order) parts.push_back({builders.at(material).take(generate), material});
  return parts;
}

MappedMaterial material_of(const ObjMaterial& said, const MappedMaterial& inherited,
                           const std::filesystem::path& folder, TextureCache& textures,
                           std::vector<std::string>& warnings) {
  MappedMaterial result = inherited;
  const auto color = [](const std::optional<Rgb>& given, Rgb& value, TextureId* map) {
    if (!given) return;
    value = *given;
    if (map) *map = no_texture;
  };
  const auto number = [&](const std::optional<double>& given, Rgb& value, TextureId& map) {
    if (given) color(Rgb(*given), value, &map);
  };
  color(said.ambient, result.values.ambient, &result.ambient);
  color(said.diffuse, result.values.diffuse, &result.diffuse);
  color(said.specular, result.values.specular, &result.specular);
  color(said.emissive, result.values.emissive, &result.emissive);
  number(said.shininess, result.values.shininess, result.shininess);
  number(said.index, result.values.index, result.index);
  if (said.opacity) result.values.transmissive = (1 - *said.opacity) * said.filter.value_or(Rgb(1));

  const auto picture = [&](const std::string& file, TextureId& map) {
    if (file.empty()) return;
    std::string problem;
    const TextureId id = textures.open((folder / file).generic_string(), problem);
    if (id != no_texture) {
      map = id;
    } else {
      warnings.push_back(
          fmt::format("the picture '{}' of its material '{}' cannot be read: {}", file, said.name, problem));
    }
  };
  picture(said.ambient_map, result.ambient);
  picture(said.diffuse_map, result.diffuse);
  picture(said.specular_map, result.specular);
  picture(said.emissive_map, result.emissive);
  picture(said.shininess_map, result.shininess);
  picture(said.bump_map, result.bump);
  picture(said.normal_map, result.normal);
  return result;
}

}  // namespace trace
