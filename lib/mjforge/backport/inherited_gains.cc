// Gains of actuators that come from default classes. The facts come from experiments: every kind of
// actuator beside a default of every other kind, in MuJoCo 2.2.2 and in releases from 2.3.2 to 4.0.
#include "mjforge/backport/inherited_gains.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace mjforge::backport {
namespace {

constexpr int kAdhesionInherits = 232;     // first release in which adhesion has an inherited gain
constexpr int kServoKeepsBias = 310;       // first release in which a servo can be damped
constexpr int kKindsAreApart = 3'016'000;  // first release that keeps kinds of actuators apart

// Attributes that set the gains, biases and dynamics of an actuator.
constexpr std::string_view kGains[] = {"kp",    "kv",    "gain",  "area",      "diameter",  "bias",
                                       "force", "scale", "range", "timeconst", "dampratio", "lmin",
                                       "lmax",  "vmax",  "fpmax", "fvmax"};

bool SetsGains(const xml::XmlElement& element) {
  return std::ranges::any_of(kGains, [&](std::string_view gain) { return element.Find(gain); });
}

// Returns number `index` of a list in the last default `<general>` whose list is that long; empty
// if there is none, or if a later default of an adhesion or a servo sets `own`.
std::string FromGeneral(const std::vector<const xml::XmlElement*>& defaults, std::string_view list,
                        std::size_t index, std::string_view own) {
  std::string number;
  for (const xml::XmlElement* element : defaults) {
    const bool may_reset = element->tag == "adhesion" || IsServo(*element);
    if (may_reset && element->Find(own) != nullptr) number.clear();
    const std::string* text = element->tag == "general" ? element->Find(list) : nullptr;
    const std::vector<double> numbers = xml::NumbersOf(text == nullptr ? "" : *text);
    if (numbers.size() > index) number = xml::TextOf({numbers[index]});
  }
  return number;
}

bool WriteGain(const DefaultClasses& elements, const ClassedElement& adhesion) {
  if (adhesion.element->Find("gain") != nullptr) return false;
  const auto defaults = elements.DefaultsOf(adhesion);
  std::string gain = FromGeneral(defaults, "gainprm", 0, "gain");
  if (gain.empty()) {
    for (const xml::XmlElement* element : defaults) {
      const std::string* own = element->tag == "adhesion" ? element->Find("gain") : nullptr;
      if (own != nullptr) gain = *own;
    }
  }
  if (!gain.empty()) adhesion.element->Set("gain", gain);
  return !gain.empty();
}

// Writes the `kv` that a damper has from a default damper.
bool WriteDamperGain(const DefaultClasses& elements, const ClassedElement& damper) {
  if (damper.element->Find("kv") != nullptr) return false;
  const std::string* kv = nullptr;
  for (const xml::XmlElement* element : elements.DefaultsOf(damper)) {
    if (element->tag == "damper" && element->Find("kv") != nullptr) kv = element->Find("kv");
  }
  if (kv != nullptr) damper.element->Set("kv", std::string(*kv));
  return kv != nullptr;
}

// Returns true if the gains of a servo are those of servos and general actuators alone, and its
// damping is a number, so that `kv` can replace the damping.
bool HasPlainGains(const DefaultClasses& elements, const ClassedElement& servo) {
  bool is_mixed = false;
  for (const xml::XmlElement* element : elements.DefaultsOf(servo)) {
    const bool is_servo = IsServo(*element);
    if (!is_servo && element->tag != "general" && element->tag != "motor") is_mixed = true;
    if (is_servo && element->Find("kp") != nullptr) is_mixed = false;
  }
  return (!is_mixed || servo.element->Find("kp") != nullptr) &&
         elements.Find(servo, "dampratio") == nullptr &&
         elements.Find(servo, "timeconst") == nullptr;
}

bool WriteDamping(const DefaultClasses& elements, const ClassedElement& servo) {
  if (servo.element->Find("kv") != nullptr || !HasPlainGains(elements, servo)) return false;
  const std::string bias = FromGeneral(elements.DefaultsOf(servo), "biasprm", 2, "kv");
  if (bias.empty() || bias == "0") return false;
  servo.element->Set("kv", xml::TextOf({-xml::NumbersOf(bias).front()}));
  return true;
}

// Returns the kind of the last default that sets the gains of an actuator and is of another kind;
// empty if there is none, or if the actuator sets a gain itself. DefaultClasses::In("actuator")
// also returns the section <actuator>, which has no kind.
std::string_view ForeignKind(const DefaultClasses& elements, const ClassedElement& actuator) {
  const std::string& own = actuator.element->tag;
  if (own == "actuator" || own == "general" || own == "motor" || SetsGains(*actuator.element))
    return {};
  std::string_view kind;
  for (const xml::XmlElement* element : elements.DefaultsOf(actuator)) {
    if (element->tag == own && SetsGains(*element)) kind = {};
    if (element->tag != own && element->tag != "general" && SetsGains(*element))
      kind = element->tag;
  }
  return kind;
}

}  // namespace

bool IsServo(const xml::XmlElement& element) {
  return element.tag == "position" || element.tag == "intvelocity";
}

bool WriteInheritedGains(xml::XmlElement& root, int version) {
  bool changed = false;
  DefaultClasses elements(root);
  for (const ClassedElement* actuator : elements.In("actuator")) {
    if (actuator->element->tag == "adhesion" && version < kAdhesionInherits)
      changed = WriteGain(elements, *actuator) || changed;
    if (actuator->element->tag == "damper" && version < kKindsAreApart)
      changed = WriteDamperGain(elements, *actuator) || changed;
    if (IsServo(*actuator->element) && version < kServoKeepsBias)
      changed = WriteDamping(elements, *actuator) || changed;
  }
  return changed;
}

void WarnOfForeignGains(xml::XmlElement& root, int version, diag::Findings& findings) {
  if (version >= kKindsAreApart) return;
  DefaultClasses elements(root);
  std::set<std::pair<std::string_view, std::string_view>> warned;
  for (const ClassedElement* actuator : elements.In("actuator")) {
    const std::string_view kind = ForeignKind(elements, *actuator);
    if (kind.empty() || !warned.emplace(kind, actuator->element->tag).second) continue;
    findings.Warn(
        diag::Code::kMujocoOlder, actuator->element->mark,
        fmt::format("{} has gains of the default <{}> up to MuJoCo 3.15, and not in later releases",
                    actuator->element->Description(), kind),
        "write the gains at the actuator");
  }
}

}  // namespace mjforge::backport
