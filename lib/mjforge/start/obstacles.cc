// Search for elements whose meaning depends on the zero configuration (qpos0) and that cannot be
// rewritten.
#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/start/configurations.h"
#include "mjforge/start/rewriting.h"
#include "mjforge/start/start.h"

namespace mjforge::start {
namespace {

using model::Element;
using model::Joint;

class ObstacleFinder {
 public:
  explicit ObstacleFinder(const Configurations& configurations)
      : configurations_(configurations), object_(configurations.object()) {}

  std::vector<Obstacle> Find() {
    for (const model::Body& body : object_.bodies) {
      for (std::size_t i = 0; i < body.joints.size(); ++i) {
        CheckSpringDamper(body.joints[i]);
        if (body.joints[i].type == "ball") CheckBall(body, i);
      }
    }
    for (const Element& equality : model::ElementsOf(object_, "equality")) CheckEquality(equality);
    for (const Element& tendon : model::ElementsOf(object_, "tendon")) CheckSpring(tendon);
    for (const Element& actuator : model::ElementsOf(object_, "actuator")) CheckMuscle(actuator);
    return std::move(obstacles_);
  }

 private:
  // Returns the name without the object's prefix, as written in the spec.
  std::string_view Shown(std::string_view name) const { return model::OwnName(name, object_.name); }

  void Add(diag::SourceMark mark, std::string reason, std::string remedy = {}) {
    obstacles_.push_back({mark, std::move(reason), std::move(remedy)});
  }

  // Reports `springdamper`: MuJoCo computes stiffness and damping with the inertia at zero.
  void CheckSpringDamper(const Joint& joint) {
    const sample::Numbers numbers = NumbersOf(joint.attributes, "springdamper");
    if (numbers.size() < 2 || !(numbers[0] > 0) || !(numbers[1] > 0)) return;
    Add(joint.mark,
        fmt::format("`springdamper` of joint '{}' depends on the inertia at zero",
                    Shown(joint.name)),
        "give its `stiffness` and `damping`");
  }

  void CheckBall(const model::Body& body, std::size_t position) {
    const Joint& joint = body.joints[position];
    const bool is_turned = IsTurned(model::JointMotion(joint, {}, joint.start).q);
    const bool is_followed = IsTurned(MotionOfLaterJoints(body, position).q);
    const auto add = [&](diag::SourceMark mark, std::string_view what) {
      Add(mark,
          fmt::format("{} of ball joint '{}' is measured from its zero", what, Shown(joint.name)));
    };
    if (is_turned && joint.range) add(joint.mark, "the range");
    if (is_turned && NumberOf(joint, "stiffness", 0, 0) > 0) add(joint.mark, "the spring");
    if (!is_turned && !is_followed) return;
    for (const Element& actuator : model::ElementsOf(object_, "actuator")) {
      if (TextOf(actuator, "joint") == joint.name ||
          TextOf(actuator, "jointinparent") == joint.name)
        add(actuator.mark, fmt::format("actuator '{}'", Shown(actuator.name)));
    }
    for (const Element& sensor : model::ElementsOf(object_, "sensor")) {
      const bool depends = sensor.tag == "ballquat" || (sensor.tag == "ballangvel" && is_followed);
      if (depends && TextOf(sensor, "joint") == joint.name)
        add(sensor.mark, fmt::format("sensor '{}'", Shown(sensor.name)));
    }
  }

  void CheckEquality(const Element& equality) {
    for (const std::string_view attribute : {"tendon1", "tendon2"}) {
      const Element* tendon = configurations_.FindTendon(TextOf(equality, attribute));
      if (tendon == nullptr || !Configurations::Wraps(*tendon) ||
          !configurations_.ChangesPath(*tendon, configurations_.zero(), configurations_.start())) {
        continue;
      }
      Add(equality.mark,
          fmt::format("equality '{}' measures tendon '{}' from zero, and only MuJoCo computes the "
                      "length of a tendon around a geom",
                      Shown(equality.name), Shown(tendon->name)));
    }
  }

  void CheckSpring(const Element& tendon) {
    if (!Configurations::Wraps(tendon) || !ChangesSpring(configurations_, tendon)) return;
    Add(tendon.mark,
        fmt::format("the spring of tendon '{}' is at rest at zero, and only MuJoCo computes the "
                    "length of a tendon around a geom",
                    Shown(tendon.name)),
        "give its `springlength`");
  }

  // Reports a muscle without a force, which MuJoCo computes from the inertia at zero, or without a
  // length range, which MuJoCo finds by a simulation that begins at zero.
  void CheckMuscle(const Element& actuator) {
    const bool is_shortcut = actuator.tag == "muscle";
    const auto is_muscle = [&](std::string_view attribute) {
      return is_shortcut || TextOf(actuator, attribute) == "muscle";
    };
    const auto lacks_force = [&](std::string_view type, std::string_view numbers) {
      if (!is_muscle(type)) return false;
      const sample::Numbers given = NumbersOf(actuator.attributes, is_shortcut ? "force" : numbers);
      const std::size_t position = is_shortcut ? 0 : 2;
      return given.size() <= position ? is_shortcut : given[position] < 0;
    };
    if (lacks_force("gaintype", "gainprm") || lacks_force("biastype", "biasprm")) {
      Add(actuator.mark,
          fmt::format("the force of muscle '{}' depends on the inertia at zero",
                      Shown(actuator.name)),
          is_shortcut ? "give its `force`" : "give the force in its parameters");
    }
    const sample::Numbers range = NumbersOf(actuator.attributes, "lengthrange");
    if ((range.size() < 2 || !(range[0] < range[1])) &&
        (is_muscle("gaintype") || is_muscle("biastype"))) {
      Add(actuator.mark,
          fmt::format("MuJoCo computes the range of lengths of muscle '{}' from zero",
                      Shown(actuator.name)),
          "give its `lengthrange`");
    }
  }

  const Configurations& configurations_;
  const model::Object& object_;
  std::vector<Obstacle> obstacles_;
};

}  // namespace

std::vector<Obstacle> FindObstacles(const model::Object& object) {
  if (!IsMoved(object)) return {};
  const Configurations configurations(object);
  return ObstacleFinder(configurations).Find();
}

}  // namespace mjforge::start
