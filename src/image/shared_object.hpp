// A shared object loaded at run time.
#pragma once

#include <dlfcn.h>

#include <memory>

namespace trace {

struct CloseSharedObject {
  void operator()(void* handle) const { dlclose(handle); }
};
using SharedObject = std::unique_ptr<void, CloseSharedObject>;

// Null if it cannot be loaded; dlerror() tells why. It stays in memory until the program ends: libraries with
// threads of their own do not survive being unloaded, and loading it again costs next to nothing.
inline SharedObject load_shared_object(const char* path) {
  return SharedObject(dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE));
}

// The function called `name`, or null.
template <typename Function>
Function find_function(const SharedObject& object, const char* name) {
  return reinterpret_cast<Function>(dlsym(object.get(), name));
}

}  // namespace trace
