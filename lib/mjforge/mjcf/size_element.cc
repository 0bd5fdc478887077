// The <size> element of large objects, for which the default sizes of MuJoCo 2.2 are too small.
// (MuJoCo 3 allocates dynamically, but accepts the element.)

#include <algorithm>

#include "mjforge/mjcf/sections.h"

namespace mjforge::mjcf {
namespace {

// The default nconmax is 100 contacts; a geom flat on the floor makes at most four.
constexpr std::size_t kGeomsThatFit = 24;
// The default njmax is 500 constraints, including contacts.
constexpr std::size_t kRowsThatFit = 300;
// MuJoCo lists pairs of bodies that might touch on a stack whose default size grows with the square
// of the constraints, not of the bodies: 1,600 bodies fit, 1,700 do not.
constexpr std::size_t kBodiesThatFit = 1'000;

std::size_t CountCollidingGeoms(const model::Object& object) {
  std::size_t geoms = 0;
  for (const model::Body& body : object.bodies) {
    for (const model::Part& part : body.parts) geoms += part.role != model::Role::kVisual;
  }
  return geoms;
}

// Returns the maximum number of constraints without contacts.
std::size_t CountConstraints(const model::Object& object) {
  std::size_t rows = 0;
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) {
      if (joint.range) rows += 2;
      if (model::FindAttribute(joint.attributes, "frictionloss") != nullptr)
        rows += joint.type == "free" ? 6 : 3;
    }
  }
  return rows + 6 * model::ElementsOf(object, "equality").size() +
         3 * model::ElementsOf(object, "tendon").size();
}

std::size_t CountJoints(const model::Object& object) {
  std::size_t joints = 0;
  for (const model::Body& body : object.bodies) joints += body.joints.size();
  return joints;
}

void WriteSize(double njmax, double nconmax, double nstack, ElementWriter& writer) {
  writer.OpenElement("size");
  writer.WriteNumber("njmax", njmax);
  if (nconmax > 0) writer.WriteNumber("nconmax", nconmax);
  if (nstack > 0) writer.WriteNumber("nstack", nstack);
  writer.CloseEmpty();
}

}  // namespace

void WriteSizes(const model::Object& object, bool scene, ElementWriter& writer) {
  if (!model::ElementsOf(object, "size").empty()) return;
  const std::size_t bodies = object.bodies.size();
  // Skip counting for small objects, which have few constraints.
  const std::size_t rows = bodies > 100 ? CountConstraints(object) : 0;
  const std::size_t geoms = scene ? CountCollidingGeoms(object) : 0;
  if (geoms <= kGeomsThatFit && rows <= kRowsThatFit && bodies <= kBodiesThatFit) return;
  // Each geom has four contacts, each contact four pyramid edges (condim 3).
  const auto contacts = static_cast<double>(std::max<std::size_t>(4 * geoms, scene ? 100 : 0));
  const double njmax = 4 * contacts + static_cast<double>(rows) + (scene ? 0 : 500);
  double nstack = 0;  // 0: MuJoCo's default
  if (bodies > kBodiesThatFit) {
    // MuJoCo's default, plus the pairs of bodies.
    const double size = njmax + static_cast<double>(CountJoints(object));
    nstack = 5 * size * size + static_cast<double>(bodies * bodies);
  } else if (bodies == 1) {
    // The unit is numbers; linear in the contacts, because one body has six degrees of freedom.
    nstack = 400 * contacts + 1e6;
  }
  WriteSize(njmax, contacts, nstack, writer);
}

}  // namespace mjforge::mjcf
