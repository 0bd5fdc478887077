// Picking: finds the geom that a picture shows at a given pixel, by a ray from the camera.

#include "mjforge/picture/camera.h"
#include "mjforge/picture/picture.h"
#include "mjforge/picture/scene.h"
#include "mjforge/picture/subject.h"

namespace mjforge::picture {

std::string GeomAt(Subject& subject, const Options& options, double x, double y) {
  const mjModel& model = *subject.state().model;
  Scene scene(model);
  diag::Findings ignored;
  if (!scene.Fill(subject, Layer::kVisual, ignored)) return {};
  const Camera camera = scene.Frame(scene.shapes(), scene.floor_height(), options);
  const Eigen::Vector3d ray = camera.forward + (2 * x - 1) * camera.tan_x * camera.right +
                              (1 - 2 * y) * camera.tan_y * camera.up;
  constexpr std::array<mjtByte, mjNGROUP> kVisible = {1, 1, 1};  // geom groups 0 to 2
  int geom = -1;
  engine::CastRay(mj_ray, &model, subject.state().data.get(), camera.eye.data(), ray.data(),
                  kVisible.data(), engine::Flag{1}, -1, &geom);
  return geom < 0 ? std::string() : std::string(model.names + model.name_geomadr[geom]);
}

}  // namespace mjforge::picture
