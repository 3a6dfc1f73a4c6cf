#include "image/openimageio_module.h"

#include <OpenImageIO/imageio.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <string>

namespace {

struct Reason {
  char* text;
  size_t size;

  // A single line: some formats append the lines of several plugins.
  int operator()(const std::string& reason) const {
    std::snprintf(text, size, "%s", reason.substr(0, reason.find('\n')).c_str());
    return 0;
  }
};

// Gray values in the first third become RGB in place, from the end so that none is overwritten too early.
void spread_gray(unsigned char* pixels, size_t count) {
  for (size_t i = count; i-- > 0;) pixels[3 * i] = pixels[3 * i + 1] = pixels[3 * i + 2] = pixels[i];
}

std::unique_ptr<OIIO::ImageInput> open_input(const char* path) {
  OIIO::ImageSpec wish;
  wish["oiio:UnassociatedAlpha"] = 1;  // the colours as they are, not multiplied by alpha
  return OIIO::ImageInput::open(path, &wish);
}

int read_picture(const char* path, TraceAllocate allocate, void* context, const Reason& fail) {
  const std::unique_ptr<OIIO::ImageInput> input = open_input(path);
  if (!input) return fail(OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.deep || spec.depth > 1 || spec.nchannels < 1) return fail("neither a gray nor a colour picture");

  unsigned char* pixels = allocate(context, spec.width, spec.height);
  if (!pixels) return fail("");
  const size_t count = size_t(spec.width) * size_t(spec.height);
  const bool gray = spec.nchannels < 3;
  if (!input->read_image(0, 0, 0, gray ? 1 : 3, OIIO::TypeUInt8, pixels)) return fail(input->geterror());
  if (gray) spread_gray(pixels, count);
  return 1;
}

// 8 or 16 where every channel is an unsigned integer of that size.
int integer_bits(const OIIO::ImageSpec& spec) {
  for (const OIIO::TypeDesc& type : spec.channelformats)
    if (type != spec.format) return 0;
  return spec.format == OIIO::TypeUInt8 ? 8 : spec.format == OIIO::TypeUInt16 ? 16 : 0;
}

int read_samples(const char* path, TraceAllocateSamples allocate, void* context, const Reason& fail) {
  const std::unique_ptr<OIIO::ImageInput> input = open_input(path);
  if (!input) return fail(OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.deep || spec.depth > 1 || spec.nchannels < 1) return fail("neither a gray nor a colour picture");
  float* samples = allocate(context, spec.width, spec.height, spec.nchannels, integer_bits(spec));
  if (!samples) return fail("");
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, samples)) return fail(input->geterror());
  return 1;
}

int write_picture(const char* path, const std::string& extension, int width, int height,
                  const unsigned char* rgb, const Reason& fail) {
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("picture" + extension);
  if (!output) {
    OIIO::geterror();  // forgets it
    return fail("cannot write pictures of type '" + extension + "'");
  }
  const OIIO::ImageSpec spec(width, height, 3, OIIO::TypeUInt8);
  if (!output->open(path, spec) || !output->write_image(OIIO::TypeUInt8, rgb) || !output->close())
    return fail(output->geterror());
  return 1;
}

}  // namespace

extern "C" int trace_openimageio_read_1(const char* path, TraceAllocate allocate, void* context, char* error,
                                        size_t error_size) {
  const Reason fail{error, error_size};
  try {
    return read_picture(path, allocate, context, fail);
  } catch (const std::exception& problem) {
    return fail(problem.what());
  } catch (...) {
    return fail("unknown error");
  }
}

extern "C" int trace_openimageio_read_samples_1(const char* path, TraceAllocateSamples allocate,
                                                void* context, char* error, size_t error_size) {
  const Reason fail{error, error_size};
  try {
    return read_samples(path, allocate, context, fail);
  } catch (const std::exception& problem) {
    return fail(problem.what());
  } catch (...) {
    return fail("unknown error");
  }
}

extern "C" int trace_openimageio_write_1(const char* path, const char* extension, int width, int height,
                                         const unsigned char* rgb, char* error, size_t error_size) {
  const Reason fail{error, error_size};
  try {
    return write_picture(path, extension, width, height, rgb, fail);
  } catch (const std::exception& problem) {
    return fail(problem.what());
  } catch (...) {
    return fail("unknown error");
  }
}
