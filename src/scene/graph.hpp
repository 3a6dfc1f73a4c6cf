// The scene graph: objects at places, places under places.
//
// The description's elements become a list of the primitives in file order, each with the frame of its place
// and the material it inherits, and one frame for each place that has primitives. Walked without recursion.
#pragma once

#include <string>
#include <vector>

#include "geometry/frame.hpp"
#include "parser/description.hpp"

namespace trace {

// A `material =` in force at some place, as a chain: each links to the one it inherits from.
using MaterialScopeId = std::int32_t;
inline constexpr MaterialScopeId default_material = -1;

struct MaterialScope {
  const parser::Material* material;
  MaterialScopeId inherits;
};

struct GraphObject {
  const parser::Primitive* primitive;
  parser::Span span;
  parser::Span keyword;
  std::int64_t frame;         // index into SceneGraph::frames; -1 where the place has no inverse
  MaterialScopeId inherits;   // the default material at this point of the file
  std::size_t scopes_before;  // how many of SceneGraph::materials stand before it in the file
};

// A transform that leaves no inverse: what is inside is not drawn.
struct SingularTransform {
  parser::Span keyword;
  std::string reason;  // "nothing inside this scale is drawn: its factor for z is 0"
};

struct SceneGraph {
  std::vector<Frame> frames;
  std::vector<GraphObject> objects;
  std::vector<MaterialScope> materials;
  // Those with objects inside, in file order; of nested ones the outermost.
  std::vector<SingularTransform> singular;
};

// Refers into `description`, which must outlive it.
SceneGraph make_graph(const parser::Scene& description);

}  // namespace trace
