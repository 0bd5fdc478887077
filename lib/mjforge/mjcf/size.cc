// Room for large objects, where MuJoCo 2.2's own sizes do not do. (3.x needs none
// and reads it all the same.)

#include <algorithm>

#include "mjforge/mjcf/sections.h"

namespace mjforge::mjcf {
namespace {

/// MuJoCo's defaults take 100 contacts; a geom flat on the floor makes up to four.
constexpr std::size_t kGeomsThatFit = 24;
/// They take 500 constraints, some of them contacts.
constexpr std::size_t kRowsThatFit = 300;
/// Pairs of bodies that might touch are listed on a stack that grows with the
/// square of the constraints, not of the bodies: 1,600 fit, 1,700 do not.
constexpr std::size_t kBodiesThatFit = 1'000;

std::size_t CollidingGeoms(const model::Object& object) {
  std::size_t geoms = 0;
  for (const model::Body& body : object.bodies) {
    for (const model::Part& part : body.parts) geoms += part.role != model::Role::kVisual;
  }
  return geoms;
}

/// The most constraints at a time, contacts aside.
std::size_t Rows(const model::Object& object) {
  std::size_t rows = 0;
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) {
      if (joint.range) rows += 2;
      const bool dry = std::ranges::find(joint.attributes, "frictionloss",
                                         &model::Attribute::name) != joint.attributes.end();
      if (dry) rows += joint.type == "free" ? 6 : 3;
    }
  }
  return rows + 6 * model::ElementsOf(object, "equality").size() +
         3 * model::ElementsOf(object, "tendon").size();
}

std::size_t Joints(const model::Object& object) {
  std::size_t joints = 0;
  for (const model::Body& body : object.bodies) joints += body.joints.size();
  return joints;
}

void WriteSize(double njmax, double nconmax, double nstack, ElementWriter& writer) {
  writer.Open("size");
  writer.Number("njmax", njmax);
  if (nconmax > 0) writer.Number("nconmax", nconmax);
  if (nstack > 0) writer.Number("nstack", nstack);
  writer.Close();
}

}  // namespace

void WriteSizes(const model::Object& object, bool scene, ElementWriter& writer) {
  if (!model::ElementsOf(object, "size").empty()) return;
  const std::size_t bodies = object.bodies.size();
  // What is seldom large is counted only where it may be.
  const std::size_t rows = bodies > 100 ? Rows(object) : 0;
  const std::size_t geoms = scene ? CollidingGeoms(object) : 0;
  if (geoms <= kGeomsThatFit && rows <= kRowsThatFit && bodies <= kBodiesThatFit) return;
  // Four contacts a geom, four pyramid edges a contact (condim 3).
  const auto contacts = static_cast<double>(std::max<std::size_t>(4 * geoms, scene ? 100 : 0));
  const double njmax = 4 * contacts + static_cast<double>(rows) + (scene ? 0 : 500);
  double nstack = 0;  // MuJoCo's own
  if (bodies > kBodiesThatFit) {
    // MuJoCo's rule, and the pairs.
    const double size = njmax + static_cast<double>(Joints(object));
    nstack = 5 * size * size + static_cast<double>(bodies * bodies);
  } else if (bodies == 1) {
    // In numbers, linear in the contacts for the six degrees of freedom of one body.
    nstack = 400 * contacts + 1e6;
  }
  WriteSize(njmax, contacts, nstack, writer);
}

}  // namespace mjforge::mjcf
