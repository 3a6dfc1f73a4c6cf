/* The interface of the run-time module trace_openimageio.so.
 *
 * The module is the only part that links OpenImageIO (some 260 shared objects, a sixth of a second), so that
 * programs which see PNG and BMP only never load it. The interface is C: no exception and no C++ type crosses
 * it.
 *
 * The functions return 1, or 0 with the reason in `error` (`error_size` bytes, always ended by a zero). */
#pragma once

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Room for 3 * width * height bytes, or null: the picture is refused, and `error` stays empty. */
typedef unsigned char* (*TraceAllocate)(void* context, int width, int height);

/* The file `path` as 8-bit RGB, rows from top to bottom, into what `allocate(context, ...)` gives: gray
 * replicated, alpha dropped, other types scaled to 0..255. */
typedef int (*TraceReadPicture)(const char* path, TraceAllocate allocate, void* context, char* error,
                                size_t error_size);
#define TRACE_READ_PICTURE "trace_openimageio_read_1"

/* Room for width * height * channels samples, or null: the picture is refused, and `error` stays empty.
 * `integer_bits` is 8 or 16 where the file holds unsigned integers of that size, otherwise 0. */
typedef float* (*TraceAllocateSamples)(void* context, int width, int height, int channels, int integer_bits);

/* All channels of the first subimage of the file `path`, interleaved, rows from top to bottom, into what
 * `allocate(context, ...)` gives: integers scaled so that the largest is 1, floating-point values as they
 * are. Deep and volume pictures are refused. */
typedef int (*TraceReadSamples)(const char* path, TraceAllocateSamples allocate, void* context, char* error,
                                size_t error_size);
#define TRACE_READ_SAMPLES "trace_openimageio_read_samples_1"

/* Writes 8-bit RGB to `path` in the format that `extension` (".jpg") stands for. */
typedef int (*TraceWritePicture)(const char* path, const char* extension, int width, int height,
                                 const unsigned char* rgb, char* error, size_t error_size);
#define TRACE_WRITE_PICTURE "trace_openimageio_write_1"

#ifdef __cplusplus
}
#endif
