// Writers of <body>, <inertial>, <joint>, <site> and <geom>, for the bodies of an object in
// depth-first order.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "mjforge/expr/expr.h"
#include "mjforge/mjcf/section_writers.h"

namespace mjforge::mjcf {
namespace {

using model::Applies;
using model::Role;

// Default color of collision geoms, as in robosuite.
constexpr std::string_view kCollisionColor = " rgba=\"0.5 0 0 1\"";

// Diagonalized inertia matrix.
struct PrincipalInertia {
  Eigen::Quaterniond axes;
  Eigen::Vector3d moments;
};

// Returns the moments about the body's given axes if these are principal axes; otherwise replaces
// MuJoCo's diagonalization of the attribute fullinertia (mju_eig3), which stops at off-diagonal
// terms of 1e-12 kg m^2: a large error for a small object.
PrincipalInertia Diagonalize(const model::Body& body) {
  constexpr double kRounding = 1e-12;  // relative, above the rounding error of rotating a tensor
  const Eigen::Matrix3d& inertia = body.mass_properties.I_Cm_F;
  if (body.principal_axes) {
    const Eigen::Matrix3d R = body.principal_axes->toRotationMatrix();
    const Eigen::Matrix3d rotated = R.transpose() * inertia * R;
    const Eigen::Vector3d moments = rotated.diagonal();
    if ((rotated - Eigen::Matrix3d(moments.asDiagonal())).cwiseAbs().maxCoeff() <=
        kRounding * inertia.trace())
      return {*body.principal_axes, moments.cwiseMax(0.0)};
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  return {Eigen::Quaterniond(axes), solver.eigenvalues()};
}

/// Returns `value` rounded to the ten significant digits with which it is written.
double Written(double value) { return expr::ParseNumber(expr::NumberText(value)).value_or(value); }

/// Reduces the largest principal moment C of a flat body (A + B = C) by a relative 2e-9 if the
/// rounded moments in the file would violate A + B >= C, because MuJoCo rejects such a body.
void KeepRealizable(Eigen::Vector3d& moments) {
  constexpr double kRounding = 2e-9;  // relative, above the rounding error of ten digits
  Eigen::Index largest = 0;
  moments.maxCoeff(&largest);
  double& c = moments[largest];
  const double a = moments[(largest + 1) % 3];
  const double b = moments[(largest + 2) % 3];
  if (std::abs(c - (a + b)) > kRounding * (a + b)) return;
  if (Written(a) + Written(b) < Written(c)) c = (1 - kRounding) * (a + b);
}

class BodyWriter {
 public:
  BodyWriter(const model::Object& object, const TargetRules& rules, ElementWriter& writer)
      : object_(object), rules_(rules), writer_(writer) {}

  /// Writes the start tag of a body and its content without child bodies. `lift`, m, is added to
  /// the height of a child of the world.
  void Begin(const model::Body& body, double lift) {
    writer_.OpenElement("body", body.mark);
    if (!body.name.empty()) writer_.WriteText("name", body.name);
    model::Pose pose = body.X_PB;
    if (body.parent < 0) pose.p.z() += lift;
    writer_.WritePose(pose);
    for (const model::Attribute& attribute : body.attributes) writer_.WriteAttribute(attribute);
    writer_.BeginContent();
    WriteInertial(body);
    for (const model::Joint& joint : body.joints) WriteJoint(joint);
    for (const model::Site& site : body.sites) WriteSite(site);
    for (const model::Element& element : body.elements) WriteElement(element, writer_);
    for (const model::Part& part : body.parts) WritePart(part);
  }

 private:
  void WriteInertial(const model::Body& body) {
    const model::MassProperties& properties = body.mass_properties;
    if (properties.mass == 0) {
      // MuJoCo 2.2 rejects a body with several massless geoms and no inertial element, and other
      // simulators reject a mass of 0. This mass is MuJoCo's minimum (mjMINVAL).
      if (model::GeomCount(body) < 2) return;
      writer_.OpenElement("inertial", body.mark);
      writer_.WriteRaw(" pos=\"0 0 0\" mass=\"1e-15\" diaginertia=\"0 0 0\"");
      writer_.CloseEmpty();
    } else if (body.explicit_inertial) {
      PrincipalInertia principal = Diagonalize(body);
      KeepRealizable(principal.moments);
      writer_.OpenElement("inertial", body.mark);
      writer_.WritePose({properties.p_FCm, principal.axes});
      writer_.WriteNumber("mass", properties.mass);
      writer_.WriteVector("diaginertia", principal.moments);
      writer_.CloseEmpty();
    }
  }

  void WriteJoint(const model::Joint& joint) {
    writer_.OpenElement("joint", joint.mark);
    writer_.WriteText("name", joint.name);
    writer_.WriteText("type", joint.type);
    if (joint.type != "free") {
      writer_.WritePoint("pos", joint.pos);
      writer_.WritePoint("axis", joint.axis);
      writer_.WriteRaw(joint.range ? " limited=\"true\"" : " limited=\"false\"");
      if (joint.range) writer_.WriteVector("range", *joint.range);
    }
    for (const model::Attribute& attribute : joint.attributes) writer_.WriteAttribute(attribute);
    writer_.CloseEmpty();
  }

  void WriteSite(const model::Site& site) {
    writer_.OpenElement("site", site.mark);
    writer_.WriteText("name", site.name);
    writer_.WriteText("type", model::GeomTypeName(site.type));
    WriteSize(site.type, site.size);
    writer_.WritePose(site.X_BS);
    WriteMaterial(site.material);
    for (const model::Attribute& attribute : site.attributes) writer_.WriteAttribute(attribute);
    writer_.CloseEmpty();
  }

  void WritePart(const model::Part& part) {
    if (part.as_is) return WriteAttachedGeom(part);
    std::size_t shape = 0;  // offsets of the shape's attributes in the text, bytes
    std::size_t shape_end = 0;
    if (part.role != Role::kVisual) {
      writer_.OpenElement("geom", part.mark);
      writer_.WriteText("name", part.name);
      shape = writer_.size();
      WriteShape(part);
      shape_end = writer_.size();
      WriteMass(part);
      WriteCollisionAttributes(part);
      writer_.CloseEmpty();
    }
    if (part.role == Role::kCollision) return;
    writer_.OpenElement("geom", part.mark);
    writer_.WriteText("name", part.name, model::kVisualSuffix);
    if (shape_end > 0) {
      writer_.RepeatText(shape, shape_end);
    } else {
      WriteShape(part);
    }
    WriteVisualAttributes(part);
    writer_.CloseEmpty();
  }

  // Writes a geom of a part with `as_is`: a geom that robocasa reads as a region, or a geom of an
  // attached file. The mass is 0, because attached bodies have an <inertial> element.
  void WriteAttachedGeom(const model::Part& part) {
    writer_.OpenElement("geom", part.mark);
    writer_.WriteText("name", part.name);
    WriteShape(part);
    writer_.WriteRaw(" mass=\"0\"");
    WriteMaterial(part.material);
    for (const model::Attribute& attribute : part.attributes) writer_.WriteAttribute(attribute);
    writer_.CloseEmpty();
  }

  void WriteShape(const model::Part& part) {
    writer_.WriteText("type", model::GeomTypeName(part.shape.type));
    if (part.shape.type == model::GeomType::kMesh) {
      writer_.WriteText("mesh", object_.meshes[static_cast<std::size_t>(part.mesh)]->name);
    } else {
      WriteSize(part.shape.type, part.shape.size);
    }
    writer_.WritePose(part.X_BG);
  }

  void WriteSize(model::GeomType type, const Eigen::Vector3d& size) {
    if (type == model::GeomType::kSphere && rules_.sphere_sizes == 3) {
      writer_.WritePoint("size", Eigen::Vector3d::Constant(size[0]));
      return;
    }
    writer_.WriteVector("size", size, static_cast<std::size_t>(model::SizeCount(type)));
  }

  void WriteMass(const model::Part& part) {
    if (part.mass > 0 && part.density > 0) {
      writer_.WriteNumber("density", part.density);
    } else {
      writer_.WriteNumber("mass", part.mass);
    }
  }

  void WriteMaterial(int material) {
    if (material < 0) return;
    writer_.WriteText("material", object_.materials[static_cast<std::size_t>(material)].name);
  }

  void WriteCollisionAttributes(const model::Part& part) {
    const bool shows_look = part.role == Role::kCollision;
    bool has_group = false;
    bool has_color = shows_look && part.material >= 0;
    if (shows_look) WriteMaterial(part.material);
    for (const model::Attribute& attribute : part.attributes) {
      if (attribute.applies == Applies::kVisual && !shows_look) continue;
      has_group |= attribute.name == "group";
      has_color |= attribute.name == "rgba";
      writer_.WriteAttribute(attribute);
    }
    if (!has_group) writer_.WriteRaw(GroupAttribute(rules_.collision_group));
    if (!has_color) writer_.WriteRaw(kCollisionColor);
  }

  void WriteVisualAttributes(const model::Part& part) {
    writer_.WriteRaw(" contype=\"0\" conaffinity=\"0\"");
    if (part.role == Role::kVisual && part.mass > 0) {
      WriteMass(part);
    } else {
      writer_.WriteRaw(" mass=\"0\"");
    }
    WriteMaterial(part.material);
    bool has_group = false;
    for (const model::Attribute& attribute : part.attributes) {
      if (attribute.applies == Applies::kCollision) continue;
      has_group |= attribute.name == "group";
      writer_.WriteAttribute(attribute);
    }
    if (!has_group) writer_.WriteRaw(GroupAttribute(rules_.visual_group));
  }

  const model::Object& object_;
  const TargetRules& rules_;
  ElementWriter& writer_;
};

}  // namespace

std::string_view GroupAttribute(int group) {
  constexpr std::string_view kAttributes[] = {" group=\"0\"", " group=\"1\"", " group=\"2\"",
                                              " group=\"3\""};
  return kAttributes[group];
}

std::vector<int> DepthFirstOrder(const model::Object& object) {
  const std::size_t count = object.bodies.size();
  std::vector<int> order;
  // Children of each body as linked lists, filled from back to front to preserve the order. The
  // last element of `first_child` is the list of the children of the world.
  std::vector<int> first_child(count + 1, -1);
  std::vector<int> next_sibling(count, -1);
  for (std::size_t i = count; i-- > 0;) {
    const int parent = object.bodies[i].parent;
    int& head = first_child[parent < 0 ? count : static_cast<std::size_t>(parent)];
    next_sibling[i] = head;
    head = static_cast<int>(i);
  }
  std::vector<int> open = {first_child[count]};
  while (!open.empty()) {
    const int body = open.back();
    if (body < 0) {
      open.pop_back();
      continue;
    }
    open.back() = next_sibling[static_cast<std::size_t>(body)];
    order.push_back(body);
    open.push_back(first_child[static_cast<std::size_t>(body)]);
  }
  return order;
}

void WriteBodies(const model::Object& object, const TargetRules& rules, double lift,
                 ElementWriter& writer) {
  BodyWriter bodies(object, rules, writer);
  std::vector<int> open;
  for (const int i : DepthFirstOrder(object)) {
    const model::Body& body = object.bodies[static_cast<std::size_t>(i)];
    while (!open.empty() && open.back() != body.parent) {
      writer.EndElement("body");
      open.pop_back();
    }
    bodies.Begin(body, lift);
    open.push_back(i);
  }
  for (; !open.empty(); open.pop_back()) writer.EndElement("body");
}

}  // namespace mjforge::mjcf
