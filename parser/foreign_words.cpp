#include "parser/foreign_words.hpp"

#include <algorithm>
#include <array>

namespace trace::parser {

namespace {

struct ForeignWord {
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
constexpr std::array foreign_words{
    ForeignWord{"CSG", solids},
    ForeignWord{"albedo", paths},
    ForeignWord{"csg", solids},
    ForeignWord{"emission", paths},
    ForeignWord{"emitter", particles},
    ForeignWord{"enable_motion_blur", motion},
    ForeignWord{"fluid", fluids},
    ForeignWord{"intersection", solids},
    ForeignWord{"light", paths},
    ForeignWord{"metaball", blobs},
    ForeignWord{"metaballs", blobs},
    ForeignWord{"metallic", paths},
    ForeignWord{"meteorite", particles},
    ForeignWord{"moving_sphere", motion},
    ForeignWord{"obj_mesh", json},
    ForeignWord{"particle", particles},
    ForeignWord{"particle_emitter", particles},
    ForeignWord{"particles", particles},
    ForeignWord{"portal", json},
    ForeignWord{"roughness", paths},
    ForeignWord{"sphere_light", paths},
    ForeignWord{"subtract", solids},
    ForeignWord{"subtraction", solids},
    ForeignWord{"time0", motion},
    ForeignWord{"time1", motion},
    ForeignWord{"translucency", paths},
    ForeignWord{"type", paths},
    ForeignWord{"union", solids},
};
static_assert(std::is_sorted(foreign_words.begin(), foreign_words.end(),
                             [](const ForeignWord& a, const ForeignWord& b) { return a.word < b.word; }));

}  // namespace

std::string_view foreign_word(std::string_view word) {
  const auto found =
      std::lower_bound(foreign_words.begin(), foreign_words.end(), word,
                       [](const ForeignWord& entry, std::string_view w) { return entry.word < w; });
  return found == foreign_words.end() || found->word != word ? std::string_view() : found->what;
}

}  // namespace trace::parser
