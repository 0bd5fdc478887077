// The pose in which pictures show an object: checks of its joints.

#include "mjforge/assemble/shown_pose.h"

#include <algorithm>
#include <iterator>
#include <span>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"

namespace mjforge::assemble {
namespace {

using diag::Code;

// Returns true if the spec lists a joint with this name, which `if` may leave out.
bool IsListed(const spec::ObjectSpec& spec, std::string_view joint) {
  const auto has_name = [&](const spec::Entry& entry) {
    return spec::LiteralText(entry.name) == joint;
  };
  return std::ranges::any_of(spec.joints, has_name) ||
         std::ranges::any_of(spec.bodies, [&](const spec::BodyEntry& body) {
           return std::ranges::any_of(body.joints, has_name);
         });
}

// Removes the object's prefix from a name.
std::string_view OwnName(const model::Object& object, std::string_view name) {
  const std::size_t prefix = object.name.size() + 1;
  return name.starts_with(object.name + "_") ? name.substr(prefix) : name;
}

// Returns the joints with this name or else with further words in front of it, as commands do.
std::vector<std::string_view> FindJoints(std::span<const std::string_view> joints,
                                         std::string_view name) {
  if (std::ranges::find(joints, name) != joints.end()) return {name};
  std::vector<std::string_view> fitting;
  std::ranges::copy_if(joints, std::back_inserter(fitting), [&](std::string_view joint) {
    return joint.ends_with(fmt::format("_{}", name));
  });
  return fitting;
}

}  // namespace

void CheckShownPose(const spec::ObjectSpec& spec, const model::Object& object,
                    diag::Findings& findings) {
  if (spec.view.pose.empty()) return;
  std::vector<std::string_view> joints;
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) joints.push_back(joint.name);
  }
  for (const spec::PictureView::Position& position : spec.view.pose) {
    const std::string shown = Quoted(position.joint);
    const std::vector<std::string_view> fitting = FindJoints(joints, position.joint);
    if (fitting.empty() && !IsListed(spec, position.joint)) {
      std::vector<std::string_view> names;
      for (const std::string_view joint : joints) names.push_back(OwnName(object, joint));
      findings.Warn(Code::kModelUnknownReference, position.mark,
                    fmt::format("view: the object has no joint {}", shown),
                    diag::DidYouMean(position.joint, names));
    } else if (fitting.size() > 1) {
      findings.Warn(Code::kModelUnknownReference, position.mark,
                    fmt::format("view: {} could be joint {} or {}", shown, Quoted(fitting[0]),
                                Quoted(fitting[1])),
                    "give its full name");
    }
  }
}

}  // namespace mjforge::assemble
