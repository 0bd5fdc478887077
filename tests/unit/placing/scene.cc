// Objects made of bodies with given shapes.

#include "scene.h"

namespace mjforge::placing {

using model::GeomType;
using model::Pose;
using model::Shape;

Pose At(double x, double y, double z, double yaw) {
  return {{x, y, z}, model::FromAxisAngle(Eigen::Vector3d::UnitZ(), yaw)};
}

Shape ShapeOf(GeomType type, double x, double y, double z) { return {type, {x, y, z}, nullptr}; }

int Scene::Add(const Shape& shape, const Pose& X_PB, int parent) {
  model::Body& body = object.bodies.emplace_back();
  body.parent = parent;
  body.X_PB = X_PB;
  AddPart(shape, {});
  return static_cast<int>(object.bodies.size()) - 1;
}

void Scene::AddPart(const Shape& shape, const Pose& X_BG, model::Role role) {
  model::Body& body = object.bodies.back();
  model::Part& part = body.parts.emplace_back();
  part.role = role;
  part.shape = shape;
  part.X_BG = X_BG;
  if (role == model::Role::kVisual) return;
  body.mass_properties =
      model::Combine(body.mass_properties, model::InFrame(X_BG, model::MassOf(shape, 1000)));
}

int Scene::AddBin(double half_inside, double height, double thickness) {
  const double half = half_inside + thickness;
  const int bin = Add(ShapeOf(GeomType::kBox, half, half, thickness / 2));
  object.bodies.back().parts.back().X_BG = At(0, 0, -thickness / 2);
  for (const double sign : {-1.0, 1.0}) {
    const double off = sign * (half_inside + thickness / 2);
    AddPart(ShapeOf(GeomType::kBox, thickness / 2, half, height / 2), At(off, 0, height / 2));
    AddPart(ShapeOf(GeomType::kBox, half, thickness / 2, height / 2), At(0, off, height / 2));
  }
  return bin;
}

model::Region BoxRegion(double half_x, double half_y, double z) {
  model::Region region;
  region.name = "surface";
  region.half_size = {half_x, half_y};
  region.X_BR = At(0, 0, z);
  return region;
}

}  // namespace mjforge::placing
