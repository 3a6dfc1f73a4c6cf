// The lists of meshes: points = ((x,y,z),...), normals = (...), texture_uv = ((u,v),...),
// faces = ((i,j,k,...),...). A ',' may stand behind the last entry.
//
// They are nearly all of the bytes of a large scene, so they are read in one piece, straight from the text,
// instead of token by token: a number of up to 19 digits is put together as an integer and scaled by an exact
// power of ten (correctly rounded while both are exact: W. D. Clinger, "How to read floating point numbers
// accurately", 1990); all others go through read_number. What is accepted and what is reported is the same
// either way.
#pragma once

#include <cstdint>
#include <vector>

#include "parser/description.hpp"
#include "parser/diagnostic.hpp"

namespace trace::parser {

// What should have stood where the reading stopped.
enum class ListNeed {
  nothing,         // the list was read to its end
  first_entry,     // '(' of the first entry, or ')'
  entry,           // '(' of an entry after ','
  number,          // a number
  comma,           // ',' between the numbers of a point, normal or pair
  close,           // ')' after the last of them
  comma_or_close,  // ',' or ')' in a face
  comma_or_end     // ',' or ')' after an entry
};

struct ListStop {
  ListNeed need = ListNeed::nothing;
  std::uint32_t offset = 0;   // behind the list's ')', or of the text that is wrong
  bool inside_entry = false;  // whether an entry was open there
};

// Read on from `begin`, behind the list's '(', and append to `numbers` or `corners`. Malformed numbers and
// wrong indices are reported and the reading goes on; anything else stops it, and the caller reports it. A
// text of less than 4 GiB holds less than 2^31 numbers, so their count needs no check.
// Entries of `count` numbers, two or three, or as many as each has where it is 0.
ListStop read_tuples(std::size_t count, const Source& source, std::uint32_t begin,
                     std::vector<double>& numbers, Diagnostics& diagnostics);
// Indices are whole numbers from 0 on; one too large for 32 bits becomes 2^32 - 1. `sizes` gets the corners
// of each face once one is not a triangle, as in Mesh::face_sizes.
ListStop read_faces(const Source& source, std::uint32_t begin, std::vector<std::uint32_t>& corners,
                    std::vector<std::uint32_t>& sizes, Diagnostics& diagnostics);

// The place of the k-th number (from 0) of a list that was read without error; `list` is from '(' to ')'.
Span number_span(const Source& source, Span list, std::uint64_t k);

}  // namespace trace::parser
