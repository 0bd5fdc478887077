#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "mjforge/mjcf/sections.h"

namespace mjforge::mjcf {
namespace {

using model::Applies;
using model::Role;

// What robosuite's collision geoms look like where nothing else is said.
constexpr std::string_view kCollisionLook = " rgba=\"0.5 0 0 1\"";

// An inertia matrix in its own axes.
struct Principal {
  Eigen::Quaterniond axes;
  Eigen::Vector3d moments;
};

// Not `fullinertia`: MuJoCo's diagonalization stops at off-diagonal terms of 1e-12 kg m^2
// (mju_eig3), much for a small object.
Principal PrincipalOf(const Eigen::Matrix3d& inertia) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0) axes.col(0) *= -1;
  return {Eigen::Quaterniond(axes), solver.eigenvalues()};
}

class BodyWriter {
 public:
  BodyWriter(const model::Object& object, const GeomGroups& groups, ElementWriter& writer)
      : object_(object), groups_(groups), writer_(writer) {}

  /// The body's start and everything in it but child bodies and the end.
  void Begin(const model::Body& body, double lift) {
    writer_.Open("body", body.mark);
    if (!body.name.empty()) writer_.Text("name", body.name);
    model::Pose pose = body.X_PB;
    if (body.parent < 0) pose.p.z() += lift;
    writer_.Pose(pose);
    for (const model::Attribute& attribute : body.attributes) writer_.Attribute(attribute);
    writer_.Content();
    Inertial(body);
    for (const model::Joint& joint : body.joints) Joint(joint);
    for (const model::Site& site : body.sites) Site(site);
    for (const model::Element& element : body.elements) WriteElement(element, writer_);
    for (const model::Part& part : body.parts) Part(part);
  }

 private:
  void Inertial(const model::Body& body) {
    const model::MassProperties& properties = body.mass_properties;
    if (properties.mass == 0) {
      // MuJoCo 2.2 does not load several massless geoms without it, and other simulators do not
      // load a mass of 0: this is the least that MuJoCo calls a mass.
      if (model::GeomCount(body) < 2) return;
      writer_.Open("inertial", body.mark);
      writer_.Raw(" pos=\"0 0 0\" mass=\"1e-15\" diaginertia=\"0 0 0\"");
      writer_.Close();
    } else if (body.explicit_inertial) {
      const Principal principal = PrincipalOf(properties.I_Cm_F);
      writer_.Open("inertial", body.mark);
      writer_.Pose({properties.p_FCm, principal.axes});
      writer_.Number("mass", properties.mass);
      writer_.Vector("diaginertia", principal.moments);
      writer_.Close();
    }
  }

  void Joint(const model::Joint& joint) {
    writer_.Open("joint", joint.mark);
    writer_.Text("name", joint.name);
    writer_.Text("type", joint.type);
    if (joint.type != "free") {
      writer_.Point("pos", joint.pos);
      writer_.Point("axis", joint.axis);
      writer_.Raw(joint.range ? " limited=\"true\"" : " limited=\"false\"");
      if (joint.range) writer_.Vector("range", *joint.range);
    }
    for (const model::Attribute& attribute : joint.attributes) writer_.Attribute(attribute);
    writer_.Close();
  }

  void Site(const model::Site& site) {
    writer_.Open("site", site.mark);
    writer_.Text("name", site.name);
    writer_.Text("type", model::GeomTypeName(site.type));
    Size(site.type, site.size);
    writer_.Pose(site.X_BS);
    Material(site.material);
    for (const model::Attribute& attribute : site.attributes) writer_.Attribute(attribute);
    writer_.Close();
  }

  void Part(const model::Part& part) {
    if (part.as_is) return AsItIs(part);
    std::size_t shape = 0;  // bytes of the text
    std::size_t shape_end = 0;
    if (part.role != Role::kVisual) {
      writer_.Open("geom", part.mark);
      writer_.Text("name", part.name);
      shape = writer_.size();
      Shape(part);
      shape_end = writer_.size();
      Mass(part);
      CollisionRest(part);
      writer_.Close();
    }
    if (part.role == Role::kCollision) return;
    writer_.Open("geom", part.mark);
    writer_.Text("name", part.name, model::kVisualSuffix);
    if (shape_end > 0) {
      writer_.Repeat(shape, shape_end);
    } else {
      Shape(part);
    }
    VisualRest(part);
    writer_.Close();
  }

  // Its body states the inertia.
  void AsItIs(const model::Part& part) {
    writer_.Open("geom", part.mark);
    writer_.Text("name", part.name);
    Shape(part);
    writer_.Raw(" mass=\"0\"");
    Material(part.material);
    for (const model::Attribute& attribute : part.attributes) writer_.Attribute(attribute);
    writer_.Close();
  }

  void Shape(const model::Part& part) {
    writer_.Text("type", model::GeomTypeName(part.shape.type));
    if (part.shape.type == model::GeomType::kMesh) {
      writer_.Text("mesh", object_.meshes[static_cast<std::size_t>(part.mesh)]->name);
    } else {
      Size(part.shape.type, part.shape.size);
    }
    writer_.Pose(part.X_BG);
  }

  void Size(model::GeomType type, const Eigen::Vector3d& size) {
    if (type == model::GeomType::kSphere && groups_.sphere_sizes == 3) {
      writer_.Point("size", Eigen::Vector3d::Constant(size[0]));
      return;
    }
    writer_.Vector("size", size, static_cast<std::size_t>(model::SizeCount(type)));
  }

  void Mass(const model::Part& part) {
    if (part.mass > 0 && part.density > 0) {
      writer_.Number("density", part.density);
    } else {
      writer_.Number("mass", part.mass);
    }
  }

  void Material(int material) {
    if (material < 0) return;
    writer_.Text("material", object_.materials[static_cast<std::size_t>(material)].name);
  }

  void CollisionRest(const model::Part& part) {
    const bool shows_look = part.role == Role::kCollision;
    bool has_group = false;
    bool has_look = shows_look && part.material >= 0;
    if (shows_look) Material(part.material);
    for (const model::Attribute& attribute : part.attributes) {
      if (attribute.applies == Applies::kVisual && !shows_look) continue;
      has_group |= attribute.name == "group";
      has_look |= attribute.name == "rgba";
      writer_.Attribute(attribute);
    }
    if (!has_group) writer_.Raw(groups_.collision);
    if (!has_look) writer_.Raw(kCollisionLook);
  }

  void VisualRest(const model::Part& part) {
    writer_.Raw(" contype=\"0\" conaffinity=\"0\"");
    if (part.role == Role::kVisual && part.mass > 0) {
      Mass(part);
    } else {
      writer_.Raw(" mass=\"0\"");
    }
    Material(part.material);
    bool has_group = false;
    for (const model::Attribute& attribute : part.attributes) {
      if (attribute.applies == Applies::kCollision) continue;
      has_group |= attribute.name == "group";
      writer_.Attribute(attribute);
    }
    if (!has_group) writer_.Raw(groups_.visual);
  }

  const model::Object& object_;
  const GeomGroups& groups_;
  ElementWriter& writer_;
};

}  // namespace

std::vector<int> DepthFirst(const model::Object& object) {
  const std::size_t count = object.bodies.size();
  std::vector<int> order;
  // Children as linked lists, filled from the back to keep their order; the
  // entry after the last body is the world's.
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

void WriteBodies(const model::Object& object, const GeomGroups& groups, double lift,
                 ElementWriter& writer) {
  BodyWriter bodies(object, groups, writer);
  std::vector<int> open;
  for (const int i : DepthFirst(object)) {
    const model::Body& body = object.bodies[static_cast<std::size_t>(i)];
    while (!open.empty() && open.back() != body.parent) {
      writer.End("body");
      open.pop_back();
    }
    bodies.Begin(body, lift);
    open.push_back(i);
  }
  for (; !open.empty(); open.pop_back()) writer.End("body");
}

}  // namespace mjforge::mjcf
