// Primitives of the dialects from what the file says of them. Each adds an error to `diagnostics`, and gives
// nothing, where its attributes describe no surface.
#pragma once

#include <optional>

#include "geometry/plane.hpp"
#include "geometry/quadric.hpp"
#include "geometry/torus.hpp"
#include "parser/description.hpp"
#include "parser/diagnostic.hpp"

namespace trace {

// Through the origin, facing +z, where nothing is said.
std::optional<Plane> make_plane(const parser::Plane& said, parser::Diagnostics& diagnostics);

// Of radius 1 with a tube of radius 0.2 where nothing is said.
std::optional<Torus> make_torus(const parser::Torus& said, parser::Diagnostics& diagnostics);

//   quadric                A to J as given, in this order; x^2 - y^2 + z^2 = 1 where none are
//   paraboloid             y = x^2 / A^2 + z^2 / B^2, lower_bound <= y <= upper_bound; 1, 1, 0, 1
//   hyperboloid            x^2 + y^2 - z^2 = 1; with type_x other than 0, y^2 + z^2 - x^2 = 1
//   hyperbolic             x^2 - y^2 - z^2 = 1, of two sheets
//   hyperbolic_paraboloid  z = x^2 - y^2
std::optional<Quadric> make_quadric(const parser::Quadric& said, parser::Diagnostics& diagnostics);

}  // namespace trace
