// OpenGL objects that MuJoCo's renderer needs: buffers that all models share, and the meshes and
// textures of one model.

#pragma once

#include <mujoco/mujoco.h>

#include <array>

namespace mjforge::picture {

/// Framebuffer and shadow map of the given sizes in pixels. Needs a current GlContext while it
/// exists.
class Buffers {
 public:
  Buffers(int width, int height, int shadow_size);
  ~Buffers();
  Buffers(const Buffers&) = delete;
  Buffers& operator=(const Buffers&) = delete;

  bool HasSize(int width, int height, int shadow_size) const {
    return size_ == std::array{width, height, shadow_size};
  }
  const mjrContext& operator*() const { return context_; }

 private:
  std::array<int, 3> size_;
  mjrContext context_;
};

/// Meshes and textures of one model, for drawing into shared buffers. `buffers` must outlive this
/// object.
class ModelContext {
 public:
  ModelContext(mjModel& model, const Buffers& buffers);
  ~ModelContext();
  ModelContext(const ModelContext&) = delete;
  ModelContext& operator=(const ModelContext&) = delete;

  mjrContext& operator*() { return context_; }

 private:
  mjrContext own_;
  mjrContext context_;  // copy of own_ that draws into the shared buffers
};

}  // namespace mjforge::picture
