// Replaces attributes of actuators and joints: damping of servos, inherited ranges, and force
// ranges of joints.

#include <algorithm>
#include <numbers>
#include <string>

#include "mjforge/backport/inherited_gains.h"
#include "mjforge/backport/replacements.h"

namespace mjforge::backport {
namespace {

/// The gains of a servo (an actuator `position` or `intvelocity`), set by the servo itself or by
/// its default classes.
struct Gains {
  std::string kp = "1";
  std::string kv;
  bool mixed = false;  // true: default classes may set gains otherwise than by kp and kv
};

void ReadGains(const xml::XmlElement& element, Gains& gains) {
  if (!IsServo(element)) {
    if (element.tag == "motor") gains.kp = "1";
    const std::string* gain = element.tag == "general" ? element.Find("gainprm") : nullptr;
    const std::vector<double> numbers = xml::NumbersOf(gain == nullptr ? "" : *gain);
    if (!numbers.empty()) gains.kp = xml::TextOf({numbers[0]});
    gains.mixed |= element.tag != "motor" && element.tag != "general";
    return;
  }
  if (const std::string* kp = element.Find("kp")) {
    gains.kp = *kp;
    gains.mixed = false;
  }
  if (const std::string* kv = element.Find("kv")) gains.kv = *kv;
}

std::string Negative(const std::string& number) {
  const std::string text = xml::TextOf({-xml::NumbersOf(number).front()});
  return text == "-0" ? "0" : text;
}

bool IsNumber(const std::string& text) { return xml::NumbersOf(text).size() == 1; }

/// Returns the attribute that names the target of an actuator ("joint", "tendon", ...); an empty
/// text if the actuator has none.
std::string_view TransmissionOf(const xml::XmlElement& actuator) {
  for (const std::string_view attribute :
       {"joint", "jointinparent", "tendon", "site", "cranksite", "slidersite", "body"}) {
    if (actuator.Find(attribute) != nullptr) return attribute;
  }
  return {};
}

}  // namespace

// Replaces a servo that has the damping gain `kv` by a `<general>` actuator with an affine bias,
// whose third number is -kv. Does nothing if the gains are unknown, or if `dampratio` or
// `timeconst` is not 0.
void Replacements::ReplaceDamping(ClassedElement& servo) {
  if (!IsServo(*servo.element) || FindMissing(servo, "kv") == nullptr) return;
  Gains gains;
  for (const xml::XmlElement* element : elements_.DefaultsOf(servo)) ReadGains(*element, gains);
  ReadGains(*servo.element, gains);
  if (gains.kv.empty() || gains.mixed || !IsNumber(gains.kp) || !IsNumber(gains.kv)) return;
  xml::XmlElement& element = *servo.element;
  constexpr std::array kOthers = {"dampratio", "timeconst"};
  for (const char* other : kOthers) {
    const std::string* said = FindMissing(servo, other);
    if (said != nullptr && xml::NumbersOf(*said) != std::vector<double>{0}) return;
  }
  for (const char* other : kOthers) element.Remove(other);
  const bool integrates = element.tag == "intvelocity";
  element.tag = "general";
  element.Remove("kp");
  element.Remove("kv");
  element.Set("dyntype", integrates ? "integrator" : "none");
  element.Set("gaintype", "fixed");
  element.Set("biastype", "affine");
  element.Set("gainprm", gains.kp);
  element.Set("biasprm", "0 " + Negative(gains.kp) + " " + Negative(gains.kv) + " 0 0 0 0 0 0 0");
  if (integrates) element.Set("actlimited", "true");
  MarkReplaced(servo, "kv");
}

// Replaces `inheritrange` of a servo by the `ctrlrange` or `actrange` that MuJoCo would compute:
// the range of the joint or tendon, scaled about the middle of this range.
void Replacements::ReplaceInheritedRange(ClassedElement& actuator) {
  const std::string* inherit = FindMissing(actuator, "inheritrange");
  if (inherit == nullptr || !IsNumber(*inherit)) return;
  if (!IsServo(*actuator.element)) {
    // A general actuator may be a servo, depending on its gains and biases.
    if (actuator.element->tag == "general") return;
    return MarkReplaced(actuator, "inheritrange", "only servos inherit ranges");
  }
  const double factor = xml::NumbersOf(*inherit).front();
  const std::string_view attribute = TransmissionOf(*actuator.element);
  if (factor <= 0 || (attribute != "joint" && attribute != "tendon")) return;
  const std::string name = *actuator.element->Find(attribute);
  for (const ClassedElement* target : elements_.In(attribute)) {
    if (target->element->Name() != name) continue;
    const std::vector<double> range = xml::NumbersOf(elements_.Get(*target, "range", ""));
    if (range.size() != 2) return;
    const bool turns = attribute == "joint" && elements_.Get(*target, "type", "hinge") == "hinge";
    const bool degrees = turns && elements_.Setting("angle", "degree") == "degree";
    const double unit = degrees ? std::numbers::pi / 180 : 1;
    const double middle = (unit * range[0] + unit * range[1]) / 2;
    const double reach = (unit * range[1] - unit * range[0]) / 2 * factor;
    const std::string what = actuator.element->tag == "position" ? "ctrl" : "act";
    actuator.element->Set(what + "range", xml::TextOf({middle - reach, middle + reach}));
    actuator.element->Set(what + "limited", "true");
    MarkReplaced(actuator, "inheritrange");
    return;
  }
}

std::optional<std::vector<ClassedElement*>> Replacements::ActuatorsOf(const std::string& joint) {
  std::vector<ClassedElement*> drivers;
  for (ClassedElement* actuator : elements_.In("actuator")) {
    const std::string_view attribute = TransmissionOf(*actuator->element);
    if (attribute.empty()) continue;
    const std::string& name = *actuator->element->Find(attribute);
    if (attribute == "joint" || attribute == "jointinparent") {
      if (name == joint) drivers.push_back(actuator);
      continue;
    }
    if (attribute != "tendon") return std::nullopt;
    for (const ClassedElement* tendon : elements_.In("tendon")) {
      if (tendon->element->Name() != name) continue;
      if (tendon->element->tag == "spatial") return std::nullopt;
      for (const xml::XmlElement& moved : tendon->element->children) {
        if (moved.Find("joint") != nullptr && *moved.Find("joint") == joint) return std::nullopt;
      }
    }
  }
  return drivers;
}

// If exactly one actuator moves a joint, replaces the force range of the joint by a force range of
// this actuator. If the limit is off or no actuator moves the joint, stores that the attributes
// have no effect.
void Replacements::ReplaceJointForceRange(ClassedElement& joint, std::string_view range,
                                          std::string_view limited) {
  const bool has_limited = FindMissing(joint, limited) != nullptr;
  if (FindMissing(joint, range) == nullptr && !has_limited) return;
  const auto mark = [&](std::string_view why_neutral) {
    MarkReplaced(joint, range, why_neutral);
    MarkReplaced(joint, limited, why_neutral);
  };
  if (elements_.Get(joint, limited, "auto") == "false") return mark("the limit is switched off");
  const std::string type = elements_.Get(joint, "type", "hinge");
  const std::vector<double> numbers = xml::NumbersOf(elements_.Get(joint, range, ""));
  if (numbers.size() != 2 || (type != "hinge" && type != "slide")) return;
  const auto drivers = ActuatorsOf(joint.element->Name());
  if (!drivers) return;
  if (drivers->empty()) return mark("no actuator of the file moves the joint");
  if (drivers->size() == 1 && LimitForce(*drivers->front(), numbers)) mark({});
}

bool Replacements::LimitForce(ClassedElement& actuator, std::vector<double> range) {
  const std::vector<double> gear = xml::NumbersOf(elements_.Get(actuator, "gear", "1"));
  if (gear.empty() || gear[0] == 0) return false;
  for (double& bound : range) bound /= gear[0];
  if (gear[0] < 0) std::swap(range[0], range[1]);
  const std::vector<double> own = xml::NumbersOf(elements_.Get(actuator, "forcerange", ""));
  const std::string limited = elements_.Get(actuator, "forcelimited", "auto");
  if (limited != "false" && own.size() == 2) {
    range = {std::max(range[0], own[0]), std::min(range[1], own[1])};
  }
  if (range[0] >= range[1]) return false;
  actuator.element->Set("forcerange", xml::TextOf(range));
  actuator.element->Set("forcelimited", "true");
  return true;
}

}  // namespace mjforge::backport
