// Finds bodies of an object that touch at the start or in the zero configuration (qpos0).
#include "mjforge/validate/self_collisions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/validate/contact_finder.h"

namespace mjforge::validate {
namespace {

// Largest number of pairs of bodies that are reported one by one.
constexpr std::size_t kMostPairs = 50;
constexpr double kRounding = 1e-12;  // m, rounding error of a distance

// Returns true if two numbers of qpos are equal up to rounding: MuJoCo normalises quaternions of
// bodies, but not those of keyframes.
bool IsSamePosition(double a, double b) { return std::abs(a - b) < 1e-9; }

// Positions of all joints: the start, which the keyframe of the file contains if there is one, or
// the zero configuration, at which a simulation begins that ignores the keyframe.
enum class Configuration { kStart, kZero };

std::string_view ConfigurationText(Configuration configuration) {
  return configuration == Configuration::kStart ? "in the start pose" : "in the zero configuration";
}

class SelfCollisions {
 public:
  SelfCollisions(mjModel& m, const model::Object& object, diag::Findings& findings)
      : m_(m), object_(object), findings_(findings), order_(mjcf::DepthFirstOrder(object)) {}

  bool Check() {
    ContactFinder finder(m_);
    const std::span<const mjtNum> start = compiled::StartOf(m_);
    const std::span<const mjtNum> zero(m_.qpos0, start.size());
    const bool starts_at_zero = std::ranges::equal(start, zero, IsSamePosition);
    if (!starts_at_zero) MoveTo(finder, start);
    if (ReportTouching(finder, Configuration::kStart) > 0) return true;
    if (starts_at_zero) return false;
    MoveTo(finder, zero);
    return ReportTouching(finder, Configuration::kZero) > 0;
  }

 private:
  static void MoveTo(ContactFinder& finder, std::span<const mjtNum> qpos) {
    std::ranges::copy(qpos, finder.qpos().begin());
    finder.Move();
  }

  /// Reports pairs of bodies that touch in the configuration to which `finder` was moved; returns
  /// the number of these pairs.
  std::size_t ReportTouching(ContactFinder& finder, Configuration configuration) {
    std::size_t found = 0;
    for (const BodyContact& contact : finder.Find()) {
      if (contact.margin - contact.distance < Allowed(contact)) continue;
      // Skips free bodies, which stay at their start when the joints of others are at zero.
      if (configuration == Configuration::kZero && !AreInOneTree(contact)) continue;
      const bool related = AreParentAndChild(contact.body1, contact.body2);
      if (related && InHost()) continue;
      if (++found <= kMostPairs) Report(contact, related, configuration);
    }
    if (found > kMostPairs) {
      diag::Finding& finding =
          findings_.Add(diag::Code::kMujocoSelfCollision, object_.bodies.front().mark,
                        fmt::format("{} more pairs of bodies touch {}", found - kMostPairs,
                                    ConfigurationText(configuration)));
      if (configuration == Configuration::kZero) finding.severity = diag::Severity::kWarning;
    }
    return found;
  }

  bool AreInOneTree(const BodyContact& contact) const {
    return m_.body_rootid[contact.body1] == m_.body_rootid[contact.body2];
  }

  /// Returns the penetration depth from which a contact is reported, m.
  double Allowed(const BodyContact& contact) const {
    const double usual = object_.checks.self_collision;
    return IsPiled(contact.body1) || IsPiled(contact.body2)
               ? std::max(usual, model::Pile::kMostDepth)
               : usual;
  }

  bool IsPiled(int id) const {
    const int root = order_[static_cast<std::size_t>(m_.body_rootid[id] - 1)];
    return std::ranges::any_of(object_.piles, [&](const model::Pile& pile) {
      return std::ranges::find(pile.items, root, &model::Pile::Item::body) != pile.items.end();
    });
  }

  const model::Body& BodyOf(int id) const {
    return object_.bodies[static_cast<std::size_t>(order_[static_cast<std::size_t>(id - 1)])];
  }

  /// Returns the highest ancestor of a body (or the body itself) that is rigidly connected with it.
  int RigidGroup(int id) const {
    while (m_.body_jntnum[id] == 0 && m_.body_parentid[id] != 0) id = m_.body_parentid[id];
    return id;
  }

  bool AreParentAndChild(int a, int b) const {
    const int group_a = RigidGroup(a);
    const int group_b = RigidGroup(b);
    const auto is_child = [&](int child, int parent) {
      const int above = m_.body_parentid[child];
      return above != 0 && RigidGroup(above) == parent;
    };
    return is_child(group_b, group_a) || is_child(group_a, group_b);
  }

  bool InHost() const { return object_.bodies.front().name.empty(); }

  /// Returns the name of a body as written in the spec, without the prefix of the object. For a
  /// root without a name, returns the name of the object, because the model that includes the
  /// object names the root.
  std::string_view BodyNameInSpec(const model::Body& body) const {
    if (InHost() && body.parent == 0) return object_.name;
    return model::OwnName(body.name, object_.name);
  }

  /// Returns true if both bodies are from one attached file, in which the contact may be intended.
  bool AreFromOneFile(const model::Body& first, const model::Body& second) const {
    return first.attached >= 0 && first.attached == second.attached;
  }

  /// Returns a hint for two bodies that touch. Suggests an exclude only within one tree, because
  /// free bodies would pass through each other.
  std::string TouchHint(const BodyContact& contact, const model::Body& first,
                        const model::Body& second, Configuration configuration) const {
    std::string hint = configuration == Configuration::kZero ? "write `start: zero`, " : "";
    hint += "move them apart";
    if (!AreInOneTree(contact)) return hint;
    return hint + fmt::format(", or write `contact: {{exclude: [[{}, {}]]}}`",
                              BodyNameInSpec(first), BodyNameInSpec(second));
  }

  void Report(const BodyContact& contact, bool related, Configuration configuration) {
    const model::Body* first = &BodyOf(contact.body1);
    const model::Body* second = &BodyOf(contact.body2);
    int first_geom = contact.geom1;
    int second_geom = contact.geom2;
    if (second < first) {  // the spec's order may differ from MuJoCo's depth-first order
      std::swap(first, second);
      std::swap(first_geom, second_geom);
    }
    const bool is_zero = configuration == Configuration::kZero;
    std::string message = fmt::format(
        "bodies '{}' and '{}' touch {}: geoms '{}' and '{}', {}", first->name, second->name,
        ConfigurationText(configuration), m_.names + m_.name_geomadr[first_geom],
        m_.names + m_.name_geomadr[second_geom], DepthText(contact.distance));
    if (is_zero) message += "; a reset without the keyframe begins there";
    if (related) message += "; MuJoCo lets parent and child collide because the parent is fixed";
    diag::Finding& finding =
        findings_.Add(diag::Code::kMujocoSelfCollision, second->mark, std::move(message),
                      TouchHint(contact, *first, *second, configuration));
    if (is_zero || related || AreFromOneFile(*first, *second))
      finding.severity = diag::Severity::kWarning;
    if (first->mark) finding.notes.push_back({first->mark, fmt::format("'{}'", first->name)});
  }

  mjModel& m_;
  const model::Object& object_;
  diag::Findings& findings_;
  const std::vector<int> order_;  // i: index of the body with MuJoCo's id i + 1
};

}  // namespace

std::string DepthText(double distance) {
  const double mm = std::abs(distance) < kRounding ? 0 : 1000 * std::abs(distance);
  return expr::RoundedText(mm) +
         (distance > kRounding ? " mm apart, within the margin" : " mm deep");
}

bool CheckSelfCollision(mjModel& m, const model::Object& object, diag::Findings& findings) {
  return SelfCollisions(m, object, findings).Check();
}

}  // namespace mjforge::validate
