// The entries of a mesh's  materials = ( { ... }, { ... }, ... )  in one piece, as far as they are plain.
//
// Some meshes have a material for each of thousands of points, most of them written like one before. A
// block that holds nothing but good numbers for parameters is read here straight from the text; the first one
// that is anything else (a name, a map, a slip) is left to the grammar, which reads it from its '{' on. What
// is accepted and what is reported is the same either way.
#pragma once

#include <cstdint>

#include "parser/description.hpp"
#include "parser/source.hpp"

namespace trace::parser {

// Reads on from the '{' at `begin` and appends the plain blocks that have a ',' behind them. Returns the
// place behind the last such ','; `begin` where there is none.
std::uint32_t read_plain_materials(const Source& source, std::uint32_t begin, VertexMaterials& materials);

}  // namespace trace::parser
