// OpenGL contexts without a display, from EGL or OSMesa.
//
// MuJoCo 2.2.2 looks up OpenGL's functions by eglGetProcAddress, or else by OSMesaGetProcAddress,
// and finds these two among the global symbols of the process (dlopen(NULL)). Therefore only the
// symbols of the library that provides the context are made global.

#pragma once

#include <dlfcn.h>

#include <memory>
#include <string>
#include <string_view>

namespace mjforge::picture {

/// An OpenGL context that is current on this thread while it exists.
class GlContext {
 public:
  GlContext() = default;
  virtual ~GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  virtual std::string_view name() const = 0;
};

/// Opens a context through EGL or OSMesa. Returns null, and sets `why_not`, if this fails.
std::unique_ptr<GlContext> OpenEgl(std::string& why_not);
std::unique_ptr<GlContext> OpenOsmesa(std::string& why_not);

/// Hides from AddressSanitizer's leak checker all allocations during the lifetime of this object,
/// because graphics drivers never free a few hundred bytes. Does nothing in builds without a leak
/// checker.
class LeakCheckPause {
 public:
  LeakCheckPause();
  // The destructor is not trivial in builds with a leak checker.
  ~LeakCheckPause();  // NOLINT(performance-trivially-destructible)
  LeakCheckPause(const LeakCheckPause&) = delete;
  LeakCheckPause& operator=(const LeakCheckPause&) = delete;
};

/// Opens the context that the environment variable MUJOCO_GL names or, if the variable is not set,
/// EGL or else OSMesa. Returns null, and sets `why_not`, if this fails or MUJOCO_GL turns rendering
/// off.
std::unique_ptr<GlContext> OpenGlContext(std::string& why_not);

/// Sets `function` to the address of a function in an open library; returns false if the library
/// has no such function.
template <typename Function>
bool FindFunction(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  return function != nullptr;
}
/// Makes the symbols of a library, which must be loaded already, global in the process.
void ExportSymbols(const char* library);

}  // namespace mjforge::picture
