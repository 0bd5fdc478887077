// Readers of cameras and lights, and the check of the bodies at which they look.

#include "mjforge/assemble/views.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/names.h"
#include "mjforge/assemble/pose_reader.h"

namespace mjforge::assemble {
namespace {

using spec::Key;

constexpr std::string_view kPos = "pos";
constexpr std::string_view kQuat = "quat";
constexpr std::string_view kDir = "dir";

// Converts to degrees the angles that MJCF expects in degrees, regardless of the setting `angle` of
// its element `compiler`.
void ToDegrees(model::Element& view) {
  for (const std::string_view name : {"fovy", "cutoff"}) {
    model::Attribute* attribute = model::FindAttribute(view.attributes, name);
    if (attribute == nullptr) continue;
    attribute->numbers.Change().front() *= 180 / std::numbers::pi;
  }
}

}  // namespace

void MoveView(const model::Pose& X_AB, model::Element& view) {
  const model::Pose X_BV = {VectorOf(view, kPos), QuaternionOf(view)};
  const model::Pose X_AV = X_AB * X_BV;
  SetNumbers(view.attributes, kPos, X_AV.p);
  if (view.tag == "camera") {
    SetNumbers(view.attributes, kQuat, model::Wxyz(X_AV.q));
    return;
  }
  SetNumbers(view.attributes, kDir,
             Eigen::Vector3d(X_AB.q * VectorOf(view, kDir, -Eigen::Vector3d::UnitZ())));
}

void Assembly::AddViews(Scope& scope, const std::vector<spec::Entry>& entries,
                        sample::StreamId path) {
  for (const spec::Entry& entry : entries) {
    const bool is_camera = entry.element == &spec::kCameraElement;
    const sample::StreamId list = sample::Child(path, is_camera ? "cameras" : "lights");
    repetition_.Expand(entry, scope.values, list, body().elements.size(),
                       [&] { AddView(scope, entry, list); });
  }
}

void Assembly::AddView(Scope& scope, const spec::Entry& entry, sample::StreamId list) {
  const std::optional<std::string> name = ReadName(scope, entry, list, findings_);
  if (!name) return;
  FieldReader reader(scope.values, findings_, entry.element->name, *name,
                     sample::Child(list, std::string_view(*name)));
  model::Element view;
  view.tag = entry.element->name;
  view.name = scope.prefix + *name;
  view.mark = entry.mark;
  bool good = ReadAttributes(reader, entry, view.attributes);
  if (good) ToDegrees(view);
  if (const spec::Field* field = entry.Find(Key::kAxis)) {
    const auto dir = ReadDirection(reader, *field);
    if (dir) SetNumbers(view.attributes, kDir, *dir);
    good &= dir.has_value();
  }
  const std::optional<model::Pose> X_SV = ReadPose(reader, entry);
  if (!good || !X_SV) return;
  SetNumbers(view.attributes, kPos, X_SV->p);
  if (view.tag == "camera") SetNumbers(view.attributes, kQuat, model::Wxyz(X_SV->q));
  MoveView(scope.X_BS, view);
  if (model::Attribute* target = model::FindAttribute(view.attributes, "target")) {
    const bool is_root = target->text == scope.values.spec().name;
    target->text = is_root ? object_.bodies[static_cast<std::size_t>(scope.body)].name
                           : scope.outer_prefix() + target->text;
    AddUnlessPresent({.name = "mode", .text = "targetbody"}, view.attributes);
  }
  body().elements.push_back(std::move(view));
}

void CheckViews(const model::Object& object, diag::Findings& findings) {
  const auto shown = [&](std::string_view name) { return model::OwnName(name, object.name); };
  std::vector<std::string_view> names;
  for (const model::Body& body : object.bodies) names.push_back(shown(body.name));
  for (const model::Body& body : object.bodies) {
    for (const model::Element& view : body.elements) {
      const model::Attribute* target = model::FindAttribute(view.attributes, "target");
      if (target == nullptr) continue;
      if (target->text == body.name) {
        findings.Add(diag::Code::kModelBadValue, view.mark,
                     fmt::format("{} {} looks at the body that it is on", view.tag,
                                 Quoted(shown(view.name))),
                     "turn it by `xyaxes` or another orientation, or put it on another body");
        continue;
      }
      const std::string_view name = shown(target->text);
      if (std::ranges::find(names, name) != names.end()) continue;
      findings.Add(diag::Code::kModelUnknownReference, view.mark,
                   fmt::format("{} {} looks at {}, but the object has no body of that name",
                               view.tag, Quoted(shown(view.name)), Quoted(name)),
                   diag::DidYouMean(name, names));
    }
  }
}

}  // namespace mjforge::assemble
