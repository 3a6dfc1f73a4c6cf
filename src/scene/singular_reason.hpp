// Why nothing inside a transform is drawn, in words.
#pragma once

#include <string>

#include "geometry/placement.hpp"
#include "parser/description.hpp"

namespace trace {

// `what` is a transform that makes of a place with an inverse `place`, which has none.
//   "nothing inside this scale is drawn: its factor for z is 0"
std::string singular_reason(const decltype(parser::Element::what)& what, const Placement& place);

}  // namespace trace
