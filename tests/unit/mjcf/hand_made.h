// Objects built without the assembler, for tests of rooms that take objects.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>

#include "mjforge/model/model.h"

namespace mjforge::hand_made {

inline diag::SourceMark Line(std::uint32_t line) { return {1, line, 3}; }

inline model::Attribute Numbers(std::string_view name, spec::Applies applies,
                                std::initializer_list<double> numbers) {
  return {name, applies, sample::Numbers(numbers.begin(), numbers.end()), {}};
}

inline model::Attribute Word(std::string_view name, spec::Applies applies, std::string text) {
  return {name, applies, {}, std::move(text)};
}

/// Returns a part with a density of 500 kg/m^3.
inline model::Part Solid(std::string name, model::GeomType type, const Eigen::Vector3d& size,
                         const model::Pose& X_BG, std::uint32_t line) {
  model::Part part;
  part.name = std::move(name);
  part.shape = {type, size, nullptr};
  part.X_BG = X_BG;
  part.density = 500;
  part.mass = 500 * model::Volume(part.shape);
  part.mark = Line(line);
  return part;
}

/// Computes mass properties and bounds from the parts.
inline void Weigh(model::Object& object) {
  object.bounds.aabb = {};
  for (model::Body& body : object.bodies) {
    body.mass_properties = {};
    for (const model::Part& part : body.parts) {
      object.bounds.aabb.Add(model::BoundsOf(part.shape, part.X_BG));
      if (part.mass <= 0) continue;
      const model::MassProperties one = model::MassOf(part.shape, 1);
      const double scale = part.mass / one.mass;
      const model::MassProperties in_body = model::InFrame(part.X_BG, model::Scaled(one, scale));
      body.mass_properties =
          body.mass_properties.mass > 0 ? model::Combine(body.mass_properties, in_body) : in_body;
    }
  }
  object.mass_properties = object.bodies.front().mass_properties;
}

/// Returns an object with one body on a free joint, without parts.
inline model::Object Empty(std::string name) {
  model::Object object;
  object.name = name;
  model::Body& body = object.bodies.emplace_back();
  body.name = name + "_root";
  body.mark = Line(1);
  model::Joint& joint = body.joints.emplace_back();
  joint.name = name + "_joint0";
  joint.mark = Line(2);
  return object;
}

/// Returns a cylinder handle with a rotated box as its head, and a site at its foot.
inline model::Object Mallet() {
  model::Object object = Empty("mallet");
  model::Body& body = object.bodies.front();
  body.parts.push_back(Solid("mallet_handle", model::GeomType::kCylinder, {0.01, 0.1, 0}, {}, 11));
  body.parts.back().attributes = {Numbers("friction", spec::Applies::kCollision, {0.9, 0.01}),
                                  Numbers("rgba", spec::Applies::kVisual, {0.6, 0.4, 0.2, 1})};
  body.parts.push_back(Solid("mallet_head", model::GeomType::kBox, {0.04, 0.02, 0.025},
                             {{0, 0, 0.125}, model::FromEuler({0.3, -0.2, 0.5})}, 12));
  model::Site& site = body.sites.emplace_back();
  site.name = "mallet_foot";
  site.X_BS.p = {0, 0, -0.1};
  site.mark = Line(20);
  Weigh(object);
  return object;
}

/// Returns a wedge, a single prism, which needs an inertial element.
inline model::Object Wedge() {
  model::Object object = Empty("wedge");
  const std::vector<Eigen::Vector2d> polygon = {{0, 0}, {0.03, 0}, {0, 0.05}};
  auto mesh = std::make_unique<model::MeshAsset>();
  mesh->name = "wedge_body";
  mesh->mesh = *solid::MakeConvexPrism(polygon, 0.04);
  mesh->is_hull = true;
  mesh->mark = Line(31);
  object.meshes.push_back(std::move(mesh));
  model::Part part;
  part.name = "wedge_body";
  part.shape = {model::GeomType::kMesh, Eigen::Vector3d::Zero(), &object.meshes[0]->mesh};
  part.mesh = 0;
  part.X_BG = {{0.01, 0.02, 0.03}, model::FromEuler({0.1, 0.7, -0.4})};
  part.density = 800;
  part.mass = 800 * model::Volume(part.shape);
  part.mark = Line(31);
  object.bodies.front().parts.push_back(std::move(part));
  object.bodies.front().explicit_inertial = true;
  Weigh(object);
  return object;
}

}  // namespace mjforge::hand_made
