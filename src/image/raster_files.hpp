// The readers of raster.hpp, by format.
#pragma once

#include <filesystem>
#include <string_view>

#include "image/input_file.hpp"
#include "image/openimageio.hpp"
#include "image/raster.hpp"

namespace trace {

// By libpng: 8 or 16 bits, as stored; fewer than 8 bits and palettes expanded to 8, a tRNS chunk to an alpha
// channel. Throws ImageError.
Raster read_png_raster(InputFile& file);

// The first subimage by OpenImageIO. 8-bit and 16-bit unsigned integers are told apart, every other type is
// `real`. Colours stay unassociated with alpha where the format stores them so. Deep and volume pictures are
// refused. Throws ImageError.
Raster read_raster_with_openimageio(const std::filesystem::path& file, std::string_view format,
                                    const ModulePlaces& places = openimageio_places());

}  // namespace trace
