// Creation and deletion of the shared OpenGL buffers, and of the meshes and textures of a model.

#include "mjforge/picture/model_context.h"

#include <stdexcept>

#include "mjforge/engine/engine.h"
#include "mjforge/picture/gl_context.h"
#include "mjforge/picture/picture.h"

namespace mjforge::picture {
namespace {

RenderContext MakeContext(const mjModel& model, mjtFontScale font) {
  RenderContext context(new mjrContext);
  mjr_defaultContext(context.get());
  const LeakCheckPause pause;
  mjr_makeContext(&model, context.get(), font);
  return context;
}

}  // namespace

void FreeContext::operator()(mjrContext* context) const {
  mjr_freeContext(context);
  delete context;
}

RenderContext MakeBuffers(int width, int height, int shadow_size, mjtFontScale font) {
  const engine::Model model = engine::Engine().LoadText("<mujoco/>").model;
  if (!model) throw std::runtime_error("MuJoCo refuses an empty model");
  model->vis.global.offwidth = width;
  model->vis.global.offheight = height;
  model->vis.quality.offsamples = 0;
  model->vis.quality.shadowsize = shadow_size;
  return MakeContext(*model, font);
}

// Makes the model's own buffers as small as possible, because MuJoCo requires them although
// pictures use the shared buffers.
ModelContext::ModelContext(mjModel& model, const mjrContext& buffers) {
  model.vis.global.offwidth = model.vis.global.offheight = kMinSize;
  model.vis.quality.offsamples = 0;
  model.vis.quality.shadowsize = 0;
  model.vis.quality.numslices = 48;
  model.vis.quality.numstacks = 24;
  own_ = MakeContext(model, mjFONTSCALE_50);
  context_ = *own_;
  context_.offFBO = buffers.offFBO;
  context_.offWidth = buffers.offWidth;
  context_.offHeight = buffers.offHeight;
  context_.shadowFBO = buffers.shadowFBO;
  context_.shadowTex = buffers.shadowTex;
  context_.shadowSize = buffers.shadowSize;
  mjr_setBuffer(mjFB_OFFSCREEN, &context_);
}

}  // namespace mjforge::picture
