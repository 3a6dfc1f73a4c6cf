// How much memory a description takes.
#pragma once

#include <cstddef>

#include "parser/description.hpp"

namespace trace {

// Of its lists and those of its meshes, by their lengths: without what materials and names hold in turn.
std::size_t bytes_of(const parser::Scene& description);

}  // namespace trace
