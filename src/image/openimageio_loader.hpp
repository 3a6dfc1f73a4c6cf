// Loading of the module trace_openimageio.so and of its functions.
#pragma once

#include <string_view>

#include "image/openimageio.hpp"
#include "image/shared_object.hpp"

namespace trace {

// From the first of the places that has it. Throws ImageError "reading JPEG needs OpenImageIO: ..." for the
// task "reading JPEG".
SharedObject load_openimageio(std::string_view task, const ModulePlaces& places);

[[noreturn]] void fail_for_other_version();

// Throws ImageError where the module has no such function.
template <typename Function>
Function openimageio_function(const SharedObject& module, const char* name) {
  if (const auto function = find_function<Function>(module, name)) return function;
  fail_for_other_version();
}

}  // namespace trace
