// The formats other than PNG and BMP, by OpenImageIO, which is loaded when first needed. A program is linked
// to one of two libraries: trace_openimageio_here loads it itself, trace_openimageio_elsewhere leaves what
// needs it to trace_dynamic (start_over.hpp).
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.hpp"

namespace trace {

// Where to look for the module trace_openimageio.so, best first.
using ModulePlaces = std::vector<std::filesystem::path>;

// In the directory of the running program, and in ../lib/trace from there.
ModulePlaces openimageio_places();

// To be called before a run reads anything or shows anything: a program that would have to start over to
// write `output`, or could not start over once it has read the files `read` ("-": standard input), does so
// here.
void settle_openimageio(const std::filesystem::path& output, std::initializer_list<std::string_view> read);

// The same for a run that may come upon any format too late to start over: where such a program can start
// over at all, it does so here.
void settle_openimageio();

// The picture in a file of the format called `format` ("JPEG"; for messages). Throws ImageError, also if the
// module or OpenImageIO is not installed.
Image read_with_openimageio(const std::filesystem::path& file, std::string_view format,
                            const ModulePlaces& places = openimageio_places());

// The bytes of a file in the format that `extension` (".jpg") stands for. Throws ImageError as above.
std::vector<std::uint8_t> encode_with_openimageio(const Image& image, std::string_view format,
                                                  const std::string& extension,
                                                  const ModulePlaces& places = openimageio_places());

}  // namespace trace
