// OpenEXR files written by hand, so that tests can put any number into a picture.
#pragma once

#include <filesystem>
#include <vector>

namespace trace::test {

// Uncompressed 32-bit RGB, scan line by scan line (openexr.com, "OpenEXR File Layout"). `samples` are
// interleaved, rows from top to bottom.
void write_exr(const std::filesystem::path& file, int width, int height, const std::vector<float>& samples);

}  // namespace trace::test
