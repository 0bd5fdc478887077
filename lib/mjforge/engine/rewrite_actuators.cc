// Servos, ranges and limits of actuators.

#include <algorithm>
#include <numbers>
#include <string>

#include "mjforge/engine/rewrite.h"

namespace mjforge::engine {
namespace {

bool IsServo(const XmlElement& element) {
  return element.tag == "position" || element.tag == "intvelocity";
}

/// The gains of a servo, as its default classes and then itself say them.
struct Gains {
  std::string kp = "1";
  std::string kv;
  bool mixed = false;  // with what other actuators say in its classes
};

void ReadGains(const XmlElement& element, Gains& gains) {
  if (!IsServo(element)) {
    if (element.tag == "motor") gains.kp = "1";
    gains.mixed |= element.tag != "motor" && element.tag != "general";
    gains.mixed |= element.Find("gainprm") != nullptr || element.Find("biasprm") != nullptr;
    return;
  }
  if (const std::string* kp = element.Find("kp")) {
    gains.kp = *kp;
    gains.mixed = false;
  }
  if (const std::string* kv = element.Find("kv")) gains.kv = *kv;
}

std::string Negative(const std::string& number) {
  const std::string text = TextOf({-NumbersOf(number).front()});
  return text == "-0" ? "0" : text;
}

bool IsNumber(const std::string& text) { return NumbersOf(text).size() == 1; }

/// "joint", "tendon" or another attribute that says what an actuator acts on.
std::string_view TransmissionOf(const XmlElement& actuator) {
  for (const std::string_view attribute :
       {"joint", "jointinparent", "tendon", "site", "cranksite", "slidersite", "body"}) {
    if (actuator.Find(attribute) != nullptr) return attribute;
  }
  return {};
}

}  // namespace

// kv is the third number of an affine bias.
void Rewriting::DampServo(Placed& servo) {
  if (!IsServo(*servo.element) || Lacking(servo, "kv") == nullptr) return;
  Gains gains;
  for (const XmlElement* element : elements_.DefaultsOf(servo)) ReadGains(*element, gains);
  ReadGains(*servo.element, gains);
  if (gains.kv.empty() || gains.mixed || !IsNumber(gains.kp) || !IsNumber(gains.kv)) return;
  XmlElement& element = *servo.element;
  for (const char* other : {"dampratio", "timeconst"}) {
    const std::string* said = Lacking(servo, other);
    if (said != nullptr && NumbersOf(*said) != std::vector<double>{0}) return;
    element.Remove(other);
  }
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
  Done(servo, "kv");
}

// The range of the joint or tendon, made larger or smaller about its middle.
void Rewriting::InheritRange(Placed& actuator) {
  const std::string* inherit = Lacking(actuator, "inheritrange");
  if (inherit == nullptr || !IsNumber(*inherit)) return;
  if (!IsServo(*actuator.element)) {
    if (actuator.element->tag == "general") return;  // may be one by its numbers
    return Done(actuator, "inheritrange", "only servos inherit ranges");
  }
  const double factor = NumbersOf(*inherit).front();
  const std::string_view attribute = TransmissionOf(*actuator.element);
  if (factor <= 0 || (attribute != "joint" && attribute != "tendon")) return;
  const std::string name = *actuator.element->Find(attribute);
  for (const Placed* target : elements_.In(attribute)) {
    if (target->element->Name() != name) continue;
    const std::vector<double> range = NumbersOf(elements_.Get(*target, "range", ""));
    if (range.size() != 2) return;
    const bool turns = attribute == "joint" && elements_.Get(*target, "type", "hinge") == "hinge";
    const bool degrees = turns && elements_.Setting("angle", "degree") == "degree";
    const double unit = degrees ? std::numbers::pi / 180 : 1;
    const double middle = (unit * range[0] + unit * range[1]) / 2;
    const double reach = (unit * range[1] - unit * range[0]) / 2 * factor;
    const std::string what = actuator.element->tag == "position" ? "ctrl" : "act";
    actuator.element->Set(what + "range", TextOf({middle - reach, middle + reach}));
    actuator.element->Set(what + "limited", "true");
    Done(actuator, "inheritrange");
    return;
  }
}

std::optional<std::vector<Placed*>> Rewriting::DriversOf(const std::string& joint) {
  std::vector<Placed*> drivers;
  for (Placed* actuator : elements_.In("actuator")) {
    const std::string_view attribute = TransmissionOf(*actuator->element);
    if (attribute.empty()) continue;
    const std::string& name = *actuator->element->Find(attribute);
    if (attribute == "joint" || attribute == "jointinparent") {
      if (name == joint) drivers.push_back(actuator);
      continue;
    }
    if (attribute != "tendon") return std::nullopt;
    for (const Placed* tendon : elements_.In("tendon")) {
      if (tendon->element->Name() != name) continue;
      if (tendon->element->tag == "spatial") return std::nullopt;
      for (const XmlElement& moved : tendon->element->children) {
        if (moved.Find("joint") != nullptr && *moved.Find("joint") == joint) return std::nullopt;
      }
    }
  }
  return drivers;
}

// What one actuator can do to a joint is limited where the actuator is.
void Rewriting::LimitJoint(Placed& joint, std::string_view range, std::string_view limited) {
  const bool says_limited = Lacking(joint, limited) != nullptr;
  if (Lacking(joint, range) == nullptr && !says_limited) return;
  const auto done = [&](std::string_view why_nothing) {
    Done(joint, range, why_nothing);
    Done(joint, limited, why_nothing);
  };
  if (elements_.Get(joint, limited, "auto") == "false") return done("the limit is switched off");
  const std::string type = elements_.Get(joint, "type", "hinge");
  const std::vector<double> numbers = NumbersOf(elements_.Get(joint, range, ""));
  if (numbers.size() != 2 || (type != "hinge" && type != "slide")) return;
  const auto drivers = DriversOf(joint.element->Name());
  if (!drivers) return;
  if (drivers->empty()) return done("no actuator of the file moves the joint");
  if (drivers->size() == 1 && LimitForce(*drivers->front(), numbers)) done({});
}

bool Rewriting::LimitForce(Placed& actuator, std::vector<double> range) {
  const std::vector<double> gear = NumbersOf(elements_.Get(actuator, "gear", "1"));
  if (gear.empty() || gear[0] == 0) return false;
  for (double& bound : range) bound /= gear[0];
  if (gear[0] < 0) std::swap(range[0], range[1]);
  const std::vector<double> own = NumbersOf(elements_.Get(actuator, "forcerange", ""));
  const std::string limited = elements_.Get(actuator, "forcelimited", "auto");
  if (limited != "false" && own.size() == 2) {
    range = {std::max(range[0], own[0]), std::min(range[1], own[1])};
  }
  if (range[0] >= range[1]) return false;
  actuator.element->Set("forcerange", TextOf(range));
  actuator.element->Set("forcelimited", "true");
  return true;
}

}  // namespace mjforge::engine
