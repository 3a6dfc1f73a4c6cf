// What can be told only once the whole mesh is read, for its lists may come in any order.
#pragma once

#include "parser/description.hpp"
#include "parser/diagnostic.hpp"

namespace trace::parser {

// Reports, at its place, the first corner that is no point of the mesh, and lists of normals and of materials
// that are not as long as the list of points. `keyword` is the mesh's first word.
void check_mesh(const Source& source, const Mesh& mesh, Span keyword, Diagnostics& diagnostics);

}  // namespace trace::parser
