// OpenGL objects that MuJoCo's renderer needs: buffers that all models share, and the meshes and
// textures of one model.

#pragma once

#include <mujoco/mujoco.h>

#include <memory>

namespace mjforge::picture {

struct FreeContext {
  void operator()(mjrContext* context) const;
};
/// OpenGL objects, which need a current GlContext while they exist.
using RenderContext = std::unique_ptr<mjrContext, FreeContext>;

/// Makes a framebuffer and a shadow map of the given sizes in pixels, and MuJoCo's font. Throws
/// std::exception.
RenderContext MakeBuffers(int width, int height, int shadow_size, mjtFontScale font);

/// Meshes and textures of one model, for drawing into shared buffers. `buffers` must outlive this
/// object.
class ModelContext {
 public:
  ModelContext(mjModel& model, const mjrContext& buffers);

  mjrContext& operator*() { return context_; }

 private:
  RenderContext own_;
  mjrContext context_;  // copy of own_ that draws into the shared buffers
};

}  // namespace mjforge::picture
