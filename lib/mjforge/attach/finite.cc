#include "mjforge/attach/finite.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "mjforge/attach/xml_tree.h"

namespace mjforge::attach {
namespace {

class Check {
 public:
  Check(const std::filesystem::path& file, diag::Findings& findings)
      : file_(file), findings_(findings) {}

  void Subject(std::string_view kind, const std::string& name, diag::SourceMark mark) {
    subject_ = fmt::format("{} '{}'", kind, name);
    mark_ = mark;
  }

  void Numbers(std::string_view what, std::span<const double> numbers) {
    if (std::ranges::all_of(numbers, [](double n) { return std::isfinite(n); })) return;
    AddError(findings_, diag::Code::kModelBadValue, mark_,
             fmt::format("{} of '{}' has a {} that is not a finite number", subject_,
                         file_.string(), what));
  }

  void Pose(const model::Pose& pose) {
    Numbers("pos", {pose.p.data(), 3});
    Numbers("quat", {pose.q.coeffs().data(), 4});
  }

  void Attributes(const std::vector<model::Attribute>& attributes) {
    for (const model::Attribute& attribute : attributes) {
      Numbers(attribute.name, {attribute.numbers.data(), attribute.numbers.size()});
    }
  }

  void Element(const model::Element& element) {
    Subject(element.tag, element.name, element.mark);
    Attributes(element.attributes);
    for (const model::Element& child : element.children) Attributes(child.attributes);
  }

  void Body(const model::Body& body) {
    Subject("body", body.name, body.mark);
    Pose(body.X_PB);
    Attributes(body.attributes);
    const model::MassProperties& properties = body.mass_properties;
    Numbers("mass", {&properties.mass, 1});
    Numbers("centre of mass", {properties.p_FCm.data(), 3});
    Numbers("inertia", {properties.I_Cm_F.data(), 9});
    for (const model::Joint& joint : body.joints) {
      Subject("joint", joint.name, joint.mark);
      Numbers("pos", {joint.pos.data(), 3});
      Numbers("axis", {joint.axis.data(), 3});
      if (joint.range) Numbers("range", {joint.range->data(), 2});
      Attributes(joint.attributes);
    }
    for (const model::Part& part : body.parts) {
      Subject("geom", part.name, part.mark);
      Pose(part.X_BG);
      Numbers("size", {part.shape.size.data(), 3});
      Attributes(part.attributes);
    }
    for (const model::Site& site : body.sites) {
      Subject("site", site.name, site.mark);
      Pose(site.X_BS);
      Numbers("size", {site.size.data(), 3});
      Attributes(site.attributes);
    }
    for (const model::Element& element : body.elements) Element(element);
  }

 private:
  const std::filesystem::path& file_;
  diag::Findings& findings_;
  std::string subject_;
  diag::SourceMark mark_;
};

}  // namespace

void CheckFinite(const model::Attachment& attachment, const std::filesystem::path& file,
                 diag::Findings& findings) {
  Check check(file, findings);
  for (const model::Body& body : attachment.bodies) check.Body(body);
  for (const model::Section& section : attachment.sections) {
    for (const model::Element& element : section.elements) check.Element(element);
  }
  for (const model::Material& material : attachment.materials) {
    check.Subject("material", material.name, material.mark);
    check.Attributes(material.attributes);
  }
  for (const auto& mesh : attachment.meshes) {
    check.Subject("mesh", mesh->name, mesh->mark);
    check.Attributes(mesh->attributes);
    for (const Eigen::Vector3d& v : mesh->mesh.vertices) {
      if (v.allFinite()) continue;
      check.Numbers("vertex", {v.data(), 3});
      break;
    }
  }
}

}  // namespace mjforge::attach
