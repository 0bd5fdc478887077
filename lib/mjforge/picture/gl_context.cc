// Choice between EGL and OSMesa: the library that the environment variable MUJOCO_GL names, or else
// the first that works.

#include "mjforge/picture/gl_context.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "mjforge/diag/diag.h"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>

// Names the library whose leaks are not reported: Mesa's threads allocate memory while they draw,
// and may still run when the program ends.
const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }
#endif

namespace mjforge::picture {
namespace {

constexpr std::array<std::string_view, 3> kWords = {"egl", "osmesa", "disable"};

}  // namespace

#ifdef __SANITIZE_ADDRESS__
LeakCheckPause::LeakCheckPause() { __lsan_disable(); }
LeakCheckPause::~LeakCheckPause() { __lsan_enable(); }
#else
LeakCheckPause::LeakCheckPause() = default;
LeakCheckPause::~LeakCheckPause() = default;
#endif

void ExportSymbols(const char* library) { ::dlopen(library, RTLD_NOW | RTLD_GLOBAL | RTLD_NOLOAD); }

std::unique_ptr<GlContext> OpenGlContext(std::string& why_not) {
  const LeakCheckPause pause;
  const char* variable = std::getenv("MUJOCO_GL");
  const std::string_view word = variable == nullptr ? "" : variable;
  if (word == "egl") return OpenEgl(why_not);
  if (word == "osmesa") return OpenOsmesa(why_not);
  // Values of MUJOCO_GL by which MuJoCo's Python bindings turn rendering off.
  constexpr std::array<std::string_view, 5> kNone = {"disable", "disabled", "off", "false", "0"};
  if (std::ranges::find(kNone, word) != kNone.end()) {
    why_not = fmt::format("MUJOCO_GL={} turns drawing off", word);
    return nullptr;
  }
  if (!word.empty()) {
    const std::string meant = diag::DidYouMean(word, kWords);
    why_not = fmt::format("MUJOCO_GL is '{}', not egl, osmesa or disable{}{}", word,
                          meant.empty() ? "" : "; ", meant);
    return nullptr;
  }
  std::string no_egl;
  if (auto context = OpenEgl(no_egl)) return context;
  std::string no_osmesa;
  if (auto context = OpenOsmesa(no_osmesa)) return context;
  why_not = fmt::format("{}; {}", no_egl, no_osmesa);
  return nullptr;
}

}  // namespace mjforge::picture
