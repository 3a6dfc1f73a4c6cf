#include <fmt/format.h>

#include <array>
#include <cmath>
#include <new>
#include <string>
#include <utility>

#include "image/openimageio_loader.hpp"
#include "image/openimageio_module.h"
#include "image/raster_files.hpp"
#include "image/size_limits.hpp"

namespace trace {
namespace {

// Where the module's samples go, and why there is no room for them.
struct RasterOrRefusal {
  Raster raster;
  std::string refusal;
};

SampleType sample_type(int bits) {
  return bits == 8 ? SampleType::uint8 : bits == 16 ? SampleType::uint16 : SampleType::real;
}

float* allocate(void* context, int width, int height, int channels, int integer_bits) noexcept {
  auto& destination = *static_cast<RasterOrRefusal*>(context);
  try {
    check_samples(width, height, channels);
    destination.raster = {width, height, channels, sample_type(integer_bits), {}};
    destination.raster.samples.resize(std::size_t(width) * std::size_t(height) * std::size_t(channels));
    return destination.raster.samples.data();
  } catch (const ImageError& error) {
    destination.refusal = error.what();
  } catch (const std::bad_alloc&) {
    destination.refusal = "out of memory";
  }
  return nullptr;
}

// OpenImageIO multiplies by a reciprocal, which is not always the number nearest to n / 255.
void settle_integers(Raster& raster) {
  if (raster.type == SampleType::real) return;
  const float most = raster.type == SampleType::uint8 ? 255 : 65535;
  for (float& sample : raster.samples) sample = std::round(sample * most) / most;
}

}  // namespace

Raster read_raster_with_openimageio(const std::filesystem::path& file, std::string_view format,
                                    const ModulePlaces& places) {
  const SharedObject module = load_openimageio(fmt::format("reading {}", format), places);
  const auto read = openimageio_function<TraceReadSamples>(module, TRACE_READ_SAMPLES);
  RasterOrRefusal destination;
  std::array<char, 512> reason{};
  if (!read(file.c_str(), allocate, &destination, reason.data(), reason.size()))
    throw ImageError(!destination.refusal.empty()
                         ? destination.refusal
                         : fmt::format("the {} cannot be read: {}", format, reason.data()));
  settle_integers(destination.raster);
  return std::move(destination.raster);
}

}  // namespace trace
