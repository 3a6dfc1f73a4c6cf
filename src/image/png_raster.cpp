#include <cstring>

#include "image/png_decoder.hpp"
#include "image/raster_files.hpp"
#include "image/raster_samples.hpp"
#include "image/size_limits.hpp"

namespace trace {
namespace {

void samples_of_uint16(const std::vector<std::uint8_t>& stored, std::vector<float>& samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) {
    std::uint16_t value = 0;
    std::memcpy(&value, &stored[2 * i], 2);
    samples[i] = float(value) / 65535;
  }
}

}  // namespace

Raster read_png_raster(InputFile& file) {
  PngDecoder decoder(file);
  decoder.read_header();
  decoder.ask_for_all();
  check_samples(decoder.width(), decoder.height(), decoder.channels());
  std::vector<std::uint8_t> stored(decoder.row_bytes() * std::size_t(decoder.height()));
  decoder.read_pixels(stored.data());

  Raster raster;
  raster.width = int(decoder.width());
  raster.height = int(decoder.height());
  raster.channels = decoder.channels();
  if (decoder.bits() == 8) {
    raster.samples = samples_of_bytes(stored);
  } else {
    raster.type = SampleType::uint16;
    raster.samples.resize(stored.size() / 2);
    samples_of_uint16(stored, raster.samples);
  }
  return raster;
}

}  // namespace trace
