// Reader of `view:`: azimuth and elevation of the camera, and positions of the joints, for
// pictures.

#include <numbers>

#include <fmt/format.h>

#include "mjforge/spec/context.h"

namespace mjforge::spec {
namespace {

using diag::Code;

// Returns the number of a constant. Otherwise returns nullopt, and adds a finding unless the value
// was already reported. Drawn numbers are not allowed, because pictures of all variants have the
// same view.
std::optional<double> FixedNumber(std::string_view name, diag::SourceMark mark, const Value& value,
                                  Context& context) {
  const std::optional<double> number = ConstantOf(value);
  if (!number && value.components != 0) {
    context.findings.Add(Code::kSpecBadValue, mark,
                         fmt::format("'{}' of a view is not a fixed number", name),
                         "write a number with its unit: 30deg, 5cm");
  }
  return number;
}

}  // namespace

void ReadView(const YamlNode& view, Context& context) {
  if (!IsMap(view, "azimuth, elevation and pose", context)) return;
  PictureView& shown = context.spec.view;
  for (const Field& field : ReadElementFields(kViewElement, view, context)) {
    const auto number = FixedNumber(field.info->key, field.mark, field.value, context);
    if (!number) continue;
    (field.info->key == "azimuth" ? shown.azimuth : shown.elevation) =
        *number * 180 / std::numbers::pi;
  }
  const YamlNode* pose = view.Find("pose");
  if (pose == nullptr) return;
  for (const JointPosition& position : ReadPositions(*pose, context)) {
    const std::optional<std::string_view> joint = LiteralText(position.joint);
    if (!joint) {
      context.findings.Add(Code::kSpecBadValue, position.mark,
                           "the name of a joint in a view is not a fixed text",
                           "write the name itself");
      continue;
    }
    const auto number = FixedNumber(*joint, position.mark, position.value, context);
    if (!number) continue;
    const expr::Dimensions& dimensions = position.value.dimensions;
    shown.pose.push_back({std::string(*joint), *number,
                          dimensions.empty() ? expr::Dimension() : dimensions[0], position.mark});
  }
}

}  // namespace mjforge::spec
