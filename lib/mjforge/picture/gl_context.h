#pragma once

// OpenGL without a display. MuJoCo finds its functions by eglGetProcAddress, else
// OSMesaGetProcAddress, among the symbols that the whole process sees (2.2.2,
// dlopen(NULL)); so the library that works, and no other, becomes visible.

#include <dlfcn.h>

#include <memory>
#include <string>
#include <string_view>

namespace mjforge::picture {

/// Current on this thread from its opening to its end.
class GlContext {
 public:
  GlContext() = default;
  virtual ~GlContext() = default;
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  virtual std::string_view name() const = 0;
};

/// Nothing, and why, if it does not work.
std::unique_ptr<GlContext> OpenEgl(std::string& why_not);
std::unique_ptr<GlContext> OpenOsmesa(std::string& why_not);

/// While it lives, a leak checker does not count what is allocated: drivers keep a few hundred
/// bytes forever. Has no effect without a leak checker.
class DriversOwn {
 public:
  DriversOwn();
  // Not trivial where there is a leak checker.
  ~DriversOwn();  // NOLINT(performance-trivially-destructible)
  DriversOwn(const DriversOwn&) = delete;
  DriversOwn& operator=(const DriversOwn&) = delete;
};

/// The one that MUJOCO_GL names, else the first that works. Nothing, and why, if none works.
std::unique_ptr<GlContext> OpenGlContext(std::string& why_not);

/// Sets the address of a function in a library that is open; false if it has none.
template <typename Function>
bool Find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  return function != nullptr;
}
/// Makes the symbols of a library that is open visible to the whole process.
void MakeVisible(const char* library);

}  // namespace mjforge::picture
