// Check of the contact properties of parts: contact bits and margins.
#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::static_checks {
namespace {

using diag::Code;

constexpr double kMostHover = 0.001;  // m; objects that rest farther above a part visibly hover

void CheckPart(const model::Part& part, Reporter& reporter) {
  if (NumberOf(part, "contype", 0, 1) == 0 && NumberOf(part, "conaffinity", 0, 1) == 0) {
    reporter.Warning(
        Code::kPhysicsNoContact, part.mark,
        fmt::format("part '{}' has the role `{}`, but collides with nothing: contype "
                    "and conaffinity are 0",
                    part.NameInSpec(), part.role == model::Role::kBoth ? "both" : "collision"),
        "leave the two out, or use `role: visual`");
  }
  const double hover = NumberOf(part, "margin", 0, 0) - NumberOf(part, "gap", 0, 0);
  if (hover > kMostHover) {
    reporter.Warning(Code::kPhysicsMargin, part.mark,
                     fmt::format("things stop {} mm before they touch part '{}': that is its "
                                 "margin minus its gap",
                                 expr::RoundedText(1000 * hover), part.NameInSpec()),
                     "lengths are in metres; a `gap` as large as the margin lets contacts be "
                     "found early, but act late");
  }
}

}  // namespace

void CheckContacts(const model::Object& object, Reporter& reporter) {
  for (const model::Body& body : object.bodies) {
    std::string_view checked;  // name of the last checked part, whose pieces are adjacent
    for (const model::Part& part : body.parts) {
      // Skips geoms of attached files (`as_is`), because their role follows from their contact
      // bits.
      if (part.role == model::Role::kVisual || part.as_is || part.NameInSpec() == checked) continue;
      CheckPart(part, reporter);
      checked = part.NameInSpec();
    }
  }
}

}  // namespace mjforge::static_checks
