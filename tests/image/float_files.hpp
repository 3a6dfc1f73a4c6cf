// Floating-point picture files made byte by byte, with whatever numbers a test needs.
#pragma once

#include <string>
#include <vector>

#include "picture_files.hpp"

namespace trace::test {

// An uncompressed OpenEXR file of 32-bit floats. `samples` are interleaved in the order of `channels`, which
// must be in alphabetical order ("B", "G", "R"), rows from the top.
Bytes exr_file(int width, int height, const std::vector<std::string>& channels,
               const std::vector<float>& samples);

}  // namespace trace::test
