#include "scene/obj_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

// The library is a single header; compiled here alone, with numbers in double.
#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

namespace trace {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Calls see(line) for each. Throws ObjError for one that is too long: the library holds a line in memory
// several times over.
template <class See>
void for_each_line(const std::string& text, const See& see) {
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    if (end > ObjFile::longest_line) {
      throw ObjError(fmt::format("a line is longer than {} bytes", ObjFile::longest_line));
    }
    see(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

// The library reads an index into an int and does not look at what is beyond.
void check_indices(std::string_view line) {
  line = trimmed(line);
  if (line.size() < 2 || line[0] != 'f' || blanks.find(line[1]) == std::string_view::npos) return;
  int digits = 0;
  for (const char c : line) {
    digits = c >= '0' && c <= '9' ? digits + 1 : 0;
    if (digits > 9) throw ObjError("a face has an index of more than nine digits");
  }
}

std::string text_of(const std::filesystem::path& path, ImageSource& images) {
  try {
    return images.bytes(path, ObjFile::most_bytes);
  } catch (const ImageError& e) {
    throw ObjError(e.what());
  }
}

// The words that each material of a file sets, which the library does not tell.
using WordsOfMaterials = std::map<std::string, std::set<std::string, std::less<>>>;

WordsOfMaterials words_of_materials(const std::string& text) {
  WordsOfMaterials result;
  std::set<std::string, std::less<>>* words = nullptr;
  for_each_line(text, [&](std::string_view line) {
    line = trimmed(line);
    const std::size_t end = std::min(line.find_first_of(blanks), line.size());
    const std::string_view word = line.substr(0, end);
    if (word == "newmtl") {
      // The library keeps the first of those with the same name.
      const auto [entry, is_new] = result.try_emplace(std::string(trimmed(line.substr(end))));
      words = is_new ? &entry->second : nullptr;
    } else if (words && !word.empty() && word[0] != '#' && words->size() < 100) {
      words->emplace(word);
    }
  });
  return result;
}

ObjMaterial material_of(const tinyobj::material_t& m, const std::set<std::string, std::less<>>& words) {
  const auto given = [&](std::string_view word) { return words.count(word) > 0; };
  const auto color = [&](std::string_view word, const tinyobj::real_t* c) -> std::optional<Rgb> {
    const Rgb value(c[0], c[1], c[2]);
    if (!given(word) || !is_finite(value)) return std::nullopt;
    return value;
  };
  const auto number = [&](std::string_view word, double value) -> std::optional<double> {
    if (!given(word) || !std::isfinite(value)) return std::nullopt;
    return value;
  };
  ObjMaterial result;
  result.name = trimmed(m.name);
  result.ambient = color("Ka", m.ambient);
  result.diffuse = color("Kd", m.diffuse);
  result.specular = color("Ks", m.specular);
  result.emissive = color("Ke", m.emission);
  result.filter = color(given("Tf") ? "Tf" : "Kt", m.transmittance);
  result.shininess = number("Ns", m.shininess);
  result.index = number("Ni", m.ior);
  result.opacity = number(given("d") ? "d" : "Tr", m.dissolve);
  result.ambient_map = m.ambient_texname;
  result.diffuse_map = m.diffuse_texname;
  result.specular_map = m.specular_texname;
  result.emissive_map = m.emissive_texname;
  result.shininess_map = m.specular_highlight_texname;
  result.bump_map = m.bump_texname;
  result.normal_map = m.normal_texname;
  return result;
}

class MaterialFiles : public tinyobj::MaterialReader {
 public:
  MaterialFiles(std::filesystem::path folder, ImageSource& images, ObjFile& result)
      : folder_(std::move(folder)), images_(images), result_(result) {}

  bool operator()(const std::string& file, std::vector<tinyobj::material_t>*, std::map<std::string, int>*,
                  std::string*, std::string*) override {
    try {
      const std::string text = text_of(folder_ / file, images_);
      const WordsOfMaterials words = words_of_materials(text);
      std::istringstream stream(text);
      std::map<std::string, int> ids;
      std::vector<tinyobj::material_t> materials;
      std::string warnings, errors;
      tinyobj::LoadMtl(&ids, &materials, &stream, &warnings, &errors);
      for (const tinyobj::material_t& m : materials) {
        const auto found = words.find(std::string(trimmed(m.name)));
        if (found == words.end()) continue;  // the library's own, of a file without any
        if (ids_.try_emplace(found->first, static_cast<std::int32_t>(result_.materials.size())).second)
          result_.materials.push_back(material_of(m, found->second));
      }
      return true;
    } catch (const ObjError& e) {
      if (said_.insert(file).second) {
        result_.warnings.push_back(fmt::format("its material file '{}' cannot be read: {}", file, e.what()));
      }
      return false;
    }
  }

  // By name; -1 for one that no file holds.
  std::int32_t id(const std::string& name) const {
    const auto found = ids_.find(name);
    return found == ids_.end() ? -1 : found->second;
  }

 private:
  std::filesystem::path folder_;
  ImageSource& images_;
  ObjFile& result_;
  std::map<std::string, std::int32_t> ids_;
  std::set<std::string> said_;
};

// Takes what the library reads. Of faces the material is the index into `used`, until all files are read.
struct Reading {
  ObjFile result;
  std::vector<std::string> used;
  std::map<std::string, std::int32_t> use_ids;
  std::int32_t material = -1;
  std::size_t small_faces = 0;

  static Reading& of(void* data) { return *static_cast<Reading*>(data); }

  template <class Vector>
  static void add(std::vector<Vector>& list, const Vector& value, const char* what) {
    if (!std::isfinite(glm::dot(value, Vector(0)))) {
      throw ObjError(fmt::format("{} {} is not of finite numbers", what, list.size() + 1));
    }
    if (list.size() >= ObjCorner::none - 1) throw ObjError(fmt::format("there are too many {}s", what));
    list.push_back(value);
  }

  // The index that is meant by one as it is written.
  std::uint32_t index(int written, std::size_t count, const char* what) const {
    const std::int64_t meant =
        written > 0 ? written - std::int64_t{1} : static_cast<std::int64_t>(count) + written;
    if (written == 0 || meant < 0 || meant >= static_cast<std::int64_t>(count)) {
      throw ObjError(fmt::format("face {} has a corner with {} {}, but before it there are {}",
                                 result.faces.size() + 1, what, written, count));
    }
    return static_cast<std::uint32_t>(meant);
  }

  void face(const tinyobj::index_t* indices, int count) {
    if (count < 3) {
      ++small_faces;
      return;
    }
    const std::size_t first = result.corners.size();
    for (int i = 0; i < count; ++i) {
      ObjCorner corner;
      corner.point = index(indices[i].vertex_index, result.points.size(), "point");
      if (indices[i].texcoord_index != 0)
        corner.coordinates = index(indices[i].texcoord_index, result.coordinates.size(), "texture place");
      if (indices[i].normal_index != 0)
        corner.normal = index(indices[i].normal_index, result.normals.size(), "normal");
      result.corners.push_back(corner);
    }
    result.faces.push_back({first, static_cast<std::uint32_t>(count), material});
  }

  void use(std::string name) {
    const auto [entry, is_new] = use_ids.try_emplace(name, static_cast<std::int32_t>(used.size()));
    if (is_new) used.push_back(std::move(name));
    material = entry->second;
  }

  // From `used` to the materials that were read.
  void resolve(const MaterialFiles& files) {
    std::vector<std::int32_t> ids;
    std::size_t unknown = 0;
    for (const std::string& name : used) {
      ids.push_back(files.id(name));
      if (ids.back() < 0 && ++unknown == 1 && !result.materials.empty()) {
        result.warnings.push_back(fmt::format("its material '{}' is in none of its material files", name));
      }
    }
    for (ObjFile::Face& f : result.faces) {
      if (f.material >= 0) f.material = ids[static_cast<std::size_t>(f.material)];
    }
  }
};

tinyobj::callback_t callbacks() {
  tinyobj::callback_t result;
  result.vertex_cb = [](void* data, double x, double y, double z, double) {
    Reading::add(Reading::of(data).result.points, Vec3(x, y, z), "point");
  };
  result.normal_cb = [](void* data, double x, double y, double z) {
    Reading::add(Reading::of(data).result.normals, Vec3(x, y, z), "normal");
  };
  result.texcoord_cb = [](void* data, double x, double y, double) {
    Reading::add(Reading::of(data).result.coordinates, Vec2(x, y), "texture place");
  };
  result.index_cb = [](void* data, tinyobj::index_t* indices, int count) {
    Reading::of(data).face(indices, count);
  };
  result.usemtl_cb = [](void* data, const char* name, int) {
    Reading::of(data).use(std::string(trimmed(name)));
  };
  return result;
}

}  // namespace

ObjFile read_obj(const std::filesystem::path& path, ImageSource& images) {
  std::string text = text_of(path, images);
  for_each_line(text, check_indices);
  Reading reading;
  MaterialFiles files(path.parent_path(), images, reading.result);
  std::istringstream stream(std::move(text));
  std::string warnings, errors;
  tinyobj::LoadObjWithCallback(stream, callbacks(), &reading, &files, &warnings, &errors);
  reading.resolve(files);
  if (reading.small_faces > 0) {
    reading.result.warnings.push_back(
        fmt::format("{} of its faces have fewer than three corners and are left out", reading.small_faces));
  }
  return std::move(reading.result);
}

}  // namespace trace
