#include "scene/cube_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace trace {
namespace {

constexpr std::array<std::pair<const char*, char>, 6> face_names{
    {{"pos", 'x'}, {"neg", 'x'}, {"pos", 'y'}, {"neg", 'y'}, {"pos", 'z'}, {"neg", 'z'}}};

// The first face, in that order, whose sign is in the name with its axis somewhere behind it.
std::optional<std::size_t> face_of(const std::string& name) {
  if (name.find(".bmp") == std::string::npos && name.find(".png") == std::string::npos) return std::nullopt;
  for (std::size_t face = 0; face < face_names.size(); ++face) {
    const std::size_t sign = name.find(face_names[face].first);
    if (sign != std::string::npos && name.find(face_names[face].second, sign) != std::string::npos)
      return face;
  }
  return std::nullopt;
}

}  // namespace

template <class T>
glm::vec<3, T, glm::defaultp> CubeMap::lookup_in(const glm::vec<3, T, glm::defaultp>& d) const {
  using Uv = glm::vec<2, T, glm::defaultp>;
  const T a = std::abs(d.x), b = std::abs(d.y), c = std::abs(d.z);
  const bool is_some_way =
      std::isfinite(d.x) && std::isfinite(d.y) && std::isfinite(d.z) && !(d.x == 0 && d.y == 0 && d.z == 0);
  if (!is_some_way) return faces_[d.z < 0 ? 4 : 5].sample_in(Uv(0));
  std::size_t face;
  T u, v;
  if (a > b && a > c) {
    face = d.x > 0 ? 0 : 1;
    u = (d.x > 0 ? d.z : -d.z) / a;
    v = d.y / a;
  } else if (b > c) {
    face = d.y > 0 ? 2 : 3;
    u = d.x / b;
    v = (d.y > 0 ? d.z : -d.z) / b;
  } else {
    face = d.z < 0 ? 4 : 5;
    u = (d.z < 0 ? d.x : -d.x) / c;
    v = d.y / c;
  }
  return faces_[face].sample_in(Uv((u + 1) / 2, (v + 1) / 2));
}

template glm::vec<3, float, glm::defaultp> CubeMap::lookup_in(const glm::vec<3, float, glm::defaultp>&) const;
template glm::vec<3, long double, glm::defaultp> CubeMap::lookup_in(
    const glm::vec<3, long double, glm::defaultp>&) const;

template Rgb CubeMap::lookup_in(const Vec3&) const;

Rgb CubeMap::lookup(const Vec3& d) const {
  return lookup_in<double>(d);
}

std::optional<CubeMap> read_cube_map(const std::string& one_face, ImageSource& images, std::string& problem) {
  const std::size_t slash = one_face.rfind('/');
  const std::filesystem::path folder =
      slash == std::string::npos ? one_face : one_face.substr(0, std::max<std::size_t>(slash, 1));
  std::array<std::filesystem::path, 6> files;
  std::error_code error;
  // In the order of their names, so that a message does not depend on the file system.
  const std::vector<std::filesystem::path> found = images.list(folder, error);
  if (error) {
    problem = fmt::format("cannot read the folder '{}': {}", folder.string(), error.message());
    return std::nullopt;
  }
  for (const auto& path : found) {
    const auto face = face_of(path.filename().string());
    if (!face) continue;
    if (!files[*face].empty()) {
      problem = fmt::format("'{}' and '{}' are both the {}{} face", files[*face].string(), path.string(),
                            face_names[*face].first, face_names[*face].second);
      return std::nullopt;
    }
    files[*face] = path;
  }
  std::vector<Texture> faces;
  for (std::size_t face = 0; face < files.size(); ++face) {
    if (files[face].empty()) {
      problem = fmt::format("the folder '{}' has no {}{} face", folder.string(), face_names[face].first,
                            face_names[face].second);
      return std::nullopt;
    }
    try {
      faces.emplace_back(images.read(files[face]));
    } catch (const ImageError& e) {
      problem = fmt::format("cannot read '{}': {}", files[face].string(), e.what());
      return std::nullopt;
    }
  }
  return CubeMap(std::move(faces));
}

}  // namespace trace
