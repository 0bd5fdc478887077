// Checks the attributes, poses, sizes, masses and mesh vertices of an attachment for NaN and
// infinity.
#include "mjforge/attach/finite_check.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/xml/xml.h"

namespace mjforge::attach {
namespace {

using xml::AddError;

template <typename Array>
std::span<const double> SpanOf(const Array& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

class FiniteCheck {
 public:
  FiniteCheck(const std::filesystem::path& file, diag::Findings& findings)
      : file_(file), findings_(findings) {}

  void Check(const model::Attachment& attachment) {
    for (const model::Body& body : attachment.bodies) CheckBody(body);
    for (const model::Section& section : attachment.sections) {
      for (const model::Element& element : section.elements) CheckElement(element);
    }
    for (const model::Material& material : attachment.materials) CheckThing("material", material);
    for (const auto& mesh : attachment.meshes) {
      CheckThing("mesh", *mesh);
      const auto bad = std::ranges::find_if(mesh->mesh.vertices,
                                            [](const auto& vertex) { return !vertex.allFinite(); });
      if (bad != mesh->mesh.vertices.end()) CheckNumbers("mesh", *mesh, "vertex", SpanOf(*bad));
    }
  }

 private:
  using Named = std::pair<std::string_view, std::span<const double>>;

  template <typename Thing>
  void CheckNumbers(std::string_view kind, const Thing& thing, std::string_view what,
                    std::span<const double> numbers) {
    if (std::ranges::all_of(numbers, [](double n) { return std::isfinite(n); })) return;
    AddError(findings_, diag::Code::kModelBadValue, thing.mark,
             fmt::format("{} '{}' of '{}' has a {} that is not a finite number", kind, thing.name,
                         file_.string(), what));
  }

  /// Reports each list of numbers in `all`, and each attribute of the element `thing` (a body,
  /// joint, geom, ...), that contains NaN or infinity.
  template <typename Thing>
  void CheckThing(std::string_view kind, const Thing& thing,
                  std::initializer_list<Named> all = {}) {
    for (const auto& [what, numbers] : all) CheckNumbers(kind, thing, what, numbers);
    for (const model::Attribute& attribute : thing.attributes) {
      CheckNumbers(kind, thing, attribute.name, SpanOf(attribute.numbers));
    }
  }

  void CheckElement(const model::Element& element) {
    CheckThing(element.tag, element);
    for (const model::Element& child : element.children) {
      for (const model::Attribute& attribute : child.attributes) {
        CheckNumbers(element.tag, element, attribute.name, SpanOf(attribute.numbers));
      }
    }
  }

  void CheckBody(const model::Body& body) {
    const auto pos = [](const model::Pose& pose) { return Named("pos", SpanOf(pose.p)); };
    const auto quat = [](const model::Pose& pose) {
      return Named("quat", SpanOf(pose.q.coeffs()));
    };
    CheckThing("body", body, {pos(body.X_PB), quat(body.X_PB)});
    const model::MassProperties& mass = body.mass_properties;
    CheckNumbers("body", body, "mass", {&mass.mass, 1});
    CheckNumbers("body", body, "centre of mass", SpanOf(mass.p_FCm));
    CheckNumbers("body", body, "inertia", SpanOf(mass.I_Cm_F));
    for (const model::Joint& joint : body.joints) {
      const Named range("range", joint.range ? SpanOf(*joint.range) : std::span<const double>());
      CheckThing("joint", joint, {{"pos", SpanOf(joint.pos)}, {"axis", SpanOf(joint.axis)}, range});
    }
    for (const model::Part& part : body.parts) {
      CheckThing("geom", part,
                 {pos(part.X_BG), quat(part.X_BG), {"size", SpanOf(part.shape.size)}});
    }
    for (const model::Site& site : body.sites) {
      CheckThing("site", site, {pos(site.X_BS), quat(site.X_BS), {"size", SpanOf(site.size)}});
    }
    for (const model::Element& element : body.elements) CheckElement(element);
  }

  const std::filesystem::path& file_;
  diag::Findings& findings_;
};

}  // namespace

void CheckFinite(const model::Attachment& attachment, const std::filesystem::path& file,
                 diag::Findings& findings) {
  FiniteCheck(file, findings).Check(attachment);
}

}  // namespace mjforge::attach
