// OpenGL context from OSMesa, Mesa's software renderer, which is loaded at run time.

#include <array>

#include "mjforge/picture/gl_context.h"

namespace mjforge::picture {
namespace {

// Declarations of GL/osmesa.h and GL/gl.h, repeated because these headers need another package.
constexpr unsigned kRgba = 0x1908;          // GL_RGBA
constexpr unsigned kUnsignedByte = 0x1401;  // GL_UNSIGNED_BYTE
using CreateContext = void* (*)(unsigned format, int depth_bits, int stencil_bits, int accum_bits,
                                void* shared);
using DestroyContext = void (*)(void* context);
using MakeCurrent = unsigned char (*)(void* context, void* buffer, unsigned type, int width,
                                      int height);

class OsmesaContext : public GlContext {
 public:
  OsmesaContext(void* context, DestroyContext destroy) : context_(context), destroy_(destroy) {}
  ~OsmesaContext() override {
    const LeakCheckPause pause;
    destroy_(context_);
  }
  std::string_view name() const override { return "OSMesa"; }

  bool Start(MakeCurrent make_current) {
    return make_current(context_, buffer_.data(), kUnsignedByte, kSide, kSide) != 0;
  }

 private:
  static constexpr int kSide = 16;  // size of the default framebuffer, which is not used

  void* context_;
  DestroyContext destroy_;
  std::array<unsigned char, kSide* kSide* 4> buffer_ = {};
};

}  // namespace

std::unique_ptr<GlContext> OpenOsmesa(std::string& why_not) {
  void* library = nullptr;
  const char* found = nullptr;
  for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
    found = name;
    library = ::dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (library != nullptr) break;
  }
  CreateContext create = nullptr;
  DestroyContext destroy = nullptr;
  MakeCurrent make_current = nullptr;
  if (library == nullptr || !FindFunction(library, "OSMesaCreateContextExt", create) ||
      !FindFunction(library, "OSMesaDestroyContext", destroy) ||
      !FindFunction(library, "OSMesaMakeCurrent", make_current)) {
    why_not = "OSMesa: cannot open libOSMesa.so.8";
    return nullptr;
  }
  void* raw = create(kRgba, 24, 8, 0, nullptr);
  std::unique_ptr<OsmesaContext> context;
  if (raw != nullptr) context = std::make_unique<OsmesaContext>(raw, destroy);
  if (!context || !context->Start(make_current)) {
    why_not = "OSMesa: it provides no OpenGL context";
    return nullptr;
  }
  ExportSymbols(found);
  return context;
}

}  // namespace mjforge::picture
