#include "image/openimageio_loader.hpp"

#include <fmt/format.h>

#include "image/program_places.hpp"

namespace trace {
namespace {

constexpr const char* module_name = "trace_openimageio.so";
constexpr const char* package_name = TRACE_OPENIMAGEIO_PACKAGE;

}  // namespace

ModulePlaces openimageio_places() {
  return places_beside_program(module_name);
}

SharedObject load_openimageio(std::string_view task, const ModulePlaces& places) {
  for (const std::filesystem::path& place : places) {
    std::error_code ignored;
    if (!std::filesystem::exists(place, ignored)) continue;
    if (SharedObject module = load_shared_object(place.c_str())) return module;
    const std::string reason = dlerror();
    if (reason.find("cannot open shared object file") != std::string::npos)
      throw ImageError(fmt::format("{} needs OpenImageIO: install the package {}", task, package_name));
    throw ImageError(fmt::format("{} needs OpenImageIO, which cannot be loaded: {}", task, reason));
  }
  throw ImageError(fmt::format("{} needs OpenImageIO: install the package {}, and {} beside the program",
                               task, package_name, module_name));
}

void fail_for_other_version() {
  throw ImageError(fmt::format("{} is of another version than the program", module_name));
}

}  // namespace trace

#ifdef __SANITIZE_ADDRESS__
// With OpenImageIO's 261 libraries and their threads in the process, LeakSanitizer itself crashes at the end
// now and then ("Tracer caught signal 11"). It asks here whether to look for leaks: only where the module was
// not loaded.
extern "C" int __lsan_is_turned_off() {
  for (const std::filesystem::path& place : trace::openimageio_places()) {
    if (trace::SharedObject(dlopen(place.c_str(), RTLD_LAZY | RTLD_NOLOAD))) return 1;
  }
  return 0;
}
#endif
