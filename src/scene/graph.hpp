// The scene graph: objects at places, places under places.
//
// The description's elements become nodes with a composed matrix, and a list of the primitives in file order,
// each with its node and the material it inherits. Walked without recursion.
#pragma once

#include <optional>
#include <vector>

#include "geometry/vector.hpp"
#include "parser/description.hpp"

namespace trace {

// A `material =` in force at some place, as a chain: each links to the one it inherits from.
using MaterialScopeId = std::int32_t;
inline constexpr MaterialScopeId default_material = -1;

struct MaterialScope {
  const parser::Material* material;
  MaterialScopeId inherits;
};

struct GraphNode {
  Mat4 to_world{1};
};

struct GraphObject {
  const parser::Primitive* primitive;
  parser::Span span;
  std::uint32_t node;
  MaterialScopeId inherits;   // the default material at this point of the file
  std::size_t scopes_before;  // how many of SceneGraph::materials stand before it in the file
};

struct SceneGraph {
  std::vector<GraphNode> nodes;
  std::vector<GraphObject> objects;
  std::vector<MaterialScope> materials;
};

// Refers into `description`, which must outlive it.
SceneGraph make_graph(const parser::Scene& description);

}  // namespace trace
