// Creation and deletion of the shared OpenGL buffers, and of the meshes and textures of a model.

#include "mjforge/picture/model_context.h"

#include <stdexcept>

#include "mjforge/engine/engine.h"
#include "mjforge/picture/gl_context.h"
#include "mjforge/picture/picture.h"

namespace mjforge::picture {

Buffers::Buffers(int width, int height, int shadow_size) : size_{width, height, shadow_size} {
  const engine::Model model = engine::Engine().LoadText("<mujoco/>").model;
  if (!model) throw std::runtime_error("MuJoCo refuses an empty model");
  model->vis.global.offwidth = width;
  model->vis.global.offheight = height;
  model->vis.quality.offsamples = 0;
  model->vis.quality.shadowsize = shadow_size;
  mjr_defaultContext(&context_);
  const LeakCheckPause pause;
  mjr_makeContext(model.get(), &context_, mjFONTSCALE_50);
}

Buffers::~Buffers() { mjr_freeContext(&context_); }

// Makes the model's own buffers as small as possible, because MuJoCo requires them although
// pictures use the shared buffers.
ModelContext::ModelContext(mjModel& model, const Buffers& buffers) {
  model.vis.global.offwidth = model.vis.global.offheight = kMinSize;
  model.vis.quality.offsamples = 0;
  model.vis.quality.shadowsize = 0;
  model.vis.quality.numslices = 48;
  model.vis.quality.numstacks = 24;
  mjr_defaultContext(&own_);
  const LeakCheckPause pause;
  mjr_makeContext(&model, &own_, mjFONTSCALE_50);
  context_ = own_;
  context_.offFBO = (*buffers).offFBO;
  context_.offWidth = (*buffers).offWidth;
  context_.offHeight = (*buffers).offHeight;
  context_.shadowFBO = (*buffers).shadowFBO;
  context_.shadowTex = (*buffers).shadowTex;
  context_.shadowSize = (*buffers).shadowSize;
  mjr_setBuffer(mjFB_OFFSCREEN, &context_);
}

ModelContext::~ModelContext() { mjr_freeContext(&own_); }

}  // namespace mjforge::picture
