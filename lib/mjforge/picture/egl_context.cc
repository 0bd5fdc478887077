// OpenGL context from EGL, which is loaded at run time.

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "mjforge/picture/gl_context.h"

namespace mjforge::picture {
namespace {

constexpr const char* kLibrary = "libEGL.so.1";

struct Egl {
  decltype(&::eglGetProcAddress) GetProcAddress = nullptr;
  decltype(&::eglGetDisplay) GetDisplay = nullptr;
  decltype(&::eglInitialize) Initialize = nullptr;
  decltype(&::eglTerminate) Terminate = nullptr;
  decltype(&::eglBindAPI) BindApi = nullptr;
  decltype(&::eglChooseConfig) ChooseConfig = nullptr;
  decltype(&::eglCreateContext) CreateContext = nullptr;
  decltype(&::eglDestroyContext) DestroyContext = nullptr;
  decltype(&::eglMakeCurrent) MakeCurrent = nullptr;

  bool FindAll(void* library) {
    return FindFunction(library, "eglGetProcAddress", GetProcAddress) &&
           FindFunction(library, "eglGetDisplay", GetDisplay) &&
           FindFunction(library, "eglInitialize", Initialize) &&
           FindFunction(library, "eglTerminate", Terminate) &&
           FindFunction(library, "eglBindAPI", BindApi) &&
           FindFunction(library, "eglChooseConfig", ChooseConfig) &&
           FindFunction(library, "eglCreateContext", CreateContext) &&
           FindFunction(library, "eglDestroyContext", DestroyContext) &&
           FindFunction(library, "eglMakeCurrent", MakeCurrent);
  }
};

class EglContext : public GlContext {
 public:
  explicit EglContext(const Egl& egl) : egl_(egl) {}
  ~EglContext() override {
    if (display_ == EGL_NO_DISPLAY) return;
    const LeakCheckPause pause;
    egl_.MakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) egl_.DestroyContext(display_, context_);
    egl_.Terminate(display_);
  }
  std::string_view name() const override { return "EGL"; }

  /// Makes a context current: on Mesa's surfaceless platform, or else on the first EGL device, or
  /// else on the default display. Returns false if none of these provides a context.
  bool Start() {
    const auto get_platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        egl_.GetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_platform_display != nullptr) {
      if (StartOn(
              get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)))
        return true;
      const auto query_devices =
          reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(egl_.GetProcAddress("eglQueryDevicesEXT"));
      EGLDeviceEXT device = nullptr;
      EGLint count = 0;
      if (query_devices != nullptr && query_devices(1, &device, &count) == EGL_TRUE && count > 0 &&
          StartOn(get_platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr))) {
        return true;
      }
    }
    return StartOn(egl_.GetDisplay(EGL_DEFAULT_DISPLAY));
  }

 private:
  bool StartOn(EGLDisplay display) {
    EGLint major = 0;
    EGLint minor = 0;
    if (display == EGL_NO_DISPLAY || egl_.Initialize(display, &major, &minor) != EGL_TRUE)
      return false;
    // Pairs of an attribute and its value.
    constexpr EGLint kAttributes[][2] = {{EGL_RED_SIZE, 8},
                                         {EGL_GREEN_SIZE, 8},
                                         {EGL_BLUE_SIZE, 8},
                                         {EGL_ALPHA_SIZE, 8},
                                         {EGL_DEPTH_SIZE, 24},
                                         {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT},
                                         {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT},
                                         {EGL_NONE, 0}};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (egl_.BindApi(EGL_OPENGL_API) == EGL_TRUE &&
        egl_.ChooseConfig(display, &kAttributes[0][0], &config, 1, &count) == EGL_TRUE &&
        count > 0) {
      context_ = egl_.CreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    }
    if (context_ == EGL_NO_CONTEXT ||
        egl_.MakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
      if (context_ != EGL_NO_CONTEXT) egl_.DestroyContext(display, context_);
      context_ = EGL_NO_CONTEXT;
      egl_.Terminate(display);
      return false;
    }
    display_ = display;
    return true;
  }

  Egl egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

// Never closes the library, because some drivers crash when they are unloaded.
std::unique_ptr<GlContext> OpenEgl(std::string& why_not) {
  void* library = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  Egl egl;
  if (library == nullptr || !egl.FindAll(library)) {
    why_not = fmt::format("EGL: cannot open {}", kLibrary);
    return nullptr;
  }
  auto context = std::make_unique<EglContext>(egl);
  if (!context->Start()) {
    why_not = "EGL: no driver provides an OpenGL context";
    return nullptr;
  }
  ExportSymbols(kLibrary);
  return context;
}

}  // namespace mjforge::picture
