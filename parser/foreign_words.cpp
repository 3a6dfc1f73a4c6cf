#include "parser/foreign_words.hpp"

#include <algorithm>
#include <array>

namespace trace::parser {

namespace {

struct Entry {
  std::string_view word, what;
};

constexpr std::string_view blobs = "is an extension of some HKUST projects (implicit surfaces)";
constexpr std::string_view particles = "is an extension of some HKUST projects (particle systems)";
constexpr std::string_view fluids = "is an extension of an HKUST project (fluids)";
constexpr std::string_view solids = "is an extension of some HKUST projects (constructive solid geometry)";
constexpr std::string_view paths =
    "is an extension of some projects that trace paths (materials and emitters)";
constexpr std::string_view motion = "is an extension of an HKUST project (motion blur)";
constexpr std::string_view json = "belongs to the JSON scenes of newer UT Austin projects";

// In alphabetical order: it is searched by halving.
constexpr std::array words{
    Entry{"CSG", solids},
    Entry{"albedo", paths},
    Entry{"csg", solids},
    Entry{"emission", paths},
    Entry{"emitter", particles},
    Entry{"enable_motion_blur", motion},
    Entry{"fluid", fluids},
    Entry{"intersection", solids},
    Entry{"light", paths},
    Entry{"metaball", blobs},
    Entry{"metaballs", blobs},
    Entry{"metallic", paths},
    Entry{"meteorite", particles},
    Entry{"moving_sphere", motion},
    Entry{"obj_mesh", json},
    Entry{"particle", particles},
    Entry{"particle_emitter", particles},
    Entry{"particles", particles},
    Entry{"portal", json},
    Entry{"roughness", paths},
    Entry{"sphere_light", paths},
    Entry{"subtract", solids},
    Entry{"subtraction", solids},
    Entry{"time0", motion},
    Entry{"time1", motion},
    Entry{"translucency", paths},
    Entry{"type", paths},
    Entry{"union", solids},
};
static_assert(std::is_sorted(words.begin(), words.end(),
                             [](const Entry& a, const Entry& b) { return a.word < b.word; }));

}  // namespace

std::string_view foreign_word(std::string_view word) {
  const auto found = std::lower_bound(words.begin(), words.end(), word,
                                      [](const Entry& entry, std::string_view w) { return entry.word < w; });
  return found == words.end() || found->word != word ? std::string_view() : found->what;
}

}  // namespace trace::parser
