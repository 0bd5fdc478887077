// Completion of a family's base MJCF: adds materials and joint friction of all variants, and moves
// elements a little if their flags for special poses differ between variants.
//
// MuJoCo takes shortcuts for special poses: for example, MuJoCo does not transform a geom whose
// pose equals that of its body to 1e-6. Flags of the compiled model (geom_sameframe) select the
// shortcuts. All variants are simulated with the flags of the base; therefore a flag that is set in
// the base must be right for every variant. A flag that is not set costs time, and changes the
// weights of constraints a little (dof_invweight0 of bodies with body_simple).

#include "mjforge/family/final_base.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/family/base.h"
#include "mjforge/family/coincidences.h"
#include "mjforge/structure/structure.h"

namespace mjforge::family {
namespace {

using structure::kBody;
using structure::kBodyRotation;
using structure::kInertia;
using structure::kInertiaRotation;
using structure::kNone;

// Offsets of moved elements: along x, y and z in m, and half the angles of rotations about x, y and
// z in rad. The offsets are far above MuJoCo's tolerance of 1e-6 for equal frames, and differ
// between inertia frames and other elements, because equal offsets would give them equal poses.
constexpr double kBodyOffset = 1e-5;
constexpr double kOffset = 2e-5;

// A kind of element with flags for special poses: names of the arrays with its flags, positions and
// orientations, and its tag in MJCF.
struct Flagged {
  std::string_view flags;
  std::string_view tag;
  std::string_view pos;
  std::string_view quat;  // empty: only the position matters
};
constexpr Flagged kFlagged[] = {{kBodyFlags, "inertial", "body_ipos", "body_iquat"},
                                {kGeomFlags, "geom", "geom_pos", "geom_quat"},
                                {kSiteFlags, "site", "site_pos", "site_quat"},
                                {kJointFlags, "joint", "jnt_pos", ""}};

constexpr unsigned Bit(int flag) { return 1U << static_cast<unsigned>(flag); }

// Returns true if the flag `base` of an element in the base MJCF is valid for all variants. Bit v
// of `variants` is set if the element has the flag v in any variant.
bool IsRight(std::string_view array, unsigned base, unsigned variants) {
  if (array == kJointFlags) return base == 0 || variants == Bit(1);
  if (base == kNone) return true;
  if (base == kBodyRotation) return (variants & ~(Bit(kBody) | Bit(kBodyRotation))) == 0;
  if (base == kInertiaRotation) return (variants & ~(Bit(kInertia) | Bit(kInertiaRotation))) == 0;
  return variants == Bit(static_cast<int>(base));
}

// Returns true if an element has the orientation of its body in all variants, or the orientation of
// the body's inertia frame in all variants.
bool HasOneRotation(unsigned variants) {
  return IsRight({}, kBodyRotation, variants) || IsRight({}, kInertiaRotation, variants);
}

class BaseCompletion {
 public:
  BaseCompletion(const Header& header, const bytes::Assets& assets, const Survey& survey,
                 diag::Findings& findings)
      : header_(header), assets_(assets), survey_(survey), findings_(findings) {}

  std::optional<FinalBase> operator()() {
    base_.text = WithMaterials(header_.base, survey_.materials);
    base_.text = WithFriction(base_.text);
    std::optional<Numbers> flags = FlagsOf(base_.text);
    if (!flags) return std::nullopt;
    for (const Flagged& array : kFlagged) Move(array, *flags);
    if (poses_.empty()) return std::move(base_);
    base_.text = WithPoses(base_.text, poses_);
    flags = FlagsOf(base_.text);
    if (!flags) return std::nullopt;
    for (const Flagged& array : kFlagged) Check(array, *flags);
    return findings_.HasErrors() ? std::nullopt : std::optional(std::move(base_));
  }

 private:
  // Compiles a base MJCF and returns the flags for special poses; nullopt after adding a finding.
  std::optional<Numbers> FlagsOf(const std::string& text) {
    if (!engine_) engine_.emplace();
    const engine::Loaded loaded = engine_->LoadText(text, assets_);
    Numbers flags;
    if (loaded.model) {
      AddCoincidences(*loaded.model, flags);
      return flags;
    }
    findings_.Add(diag::Code::kMujocoError, {},
                  "MuJoCo refused the base of the family: " + engine::OneLine(loaded.error));
    return std::nullopt;
  }

  // Calls `act` for each element whose flag in the base is not valid for all variants (IsRight). If
  // `if_different` is true, also calls `act` for each element whose flag differs between variants.
  template <typename Act>
  void ForEachWrong(const Flagged& array, const Numbers& flags, bool if_different, const Act& act) {
    const auto& [shape, at] = header_.Find(array.flags);
    const auto variants = std::span(survey_.flags).subspan(at, shape.size());
    const double* base = flags.values.data() + flags.Find(array.flags).second;
    for (std::size_t i = 0; i < variants.size(); ++i) {
      const bool is_one = (variants[i] & (variants[i] - 1)) == 0;
      const bool is_right = IsRight(array.flags, static_cast<unsigned>(base[i]), variants[i]);
      if (!is_right || (if_different && !is_one)) act(i, variants[i]);
    }
  }

  void Move(const Flagged& array, const Numbers& flags) {
    ForEachWrong(array, flags, true, [&](std::size_t i, unsigned variants) {
      const double offset = array.flags == kBodyFlags ? kBodyOffset : kOffset;
      NewPose pose{.tag = array.tag, .number = i, .pos = {}, .quat = {}};
      const std::span<const double> pos = First(array.pos, i);
      pose.pos = Eigen::Vector3d(pos[0] + offset, pos[1] + offset, pos[2] + offset);
      base_.moved[std::string(array.pos)].insert(i);
      if (!array.quat.empty() && !HasOneRotation(variants)) {
        const std::span<const double> q = First(array.quat, i);
        const Eigen::Quaterniond turned =
            Eigen::Quaterniond(q[0], q[1], q[2], q[3]) *
            Eigen::Quaterniond(1, offset, offset, offset).normalized();
        pose.quat = model::Wxyz(turned);
        base_.moved[std::string(array.quat)].insert(i);
      }
      poses_.push_back(std::move(pose));
    });
  }

  void Check(const Flagged& array, const Numbers& flags) {
    ForEachWrong(array, flags, false, [&](std::size_t i, unsigned) {
      const ArrayShape& shape = header_.Find(array.flags).first;
      findings_.Add(diag::Code::kMujocoMismatch, {},
                    "the variants have no common base: MuJoCo compiles " + std::string(shape.name) +
                        " of '" + shape.elements[i] + "' as a special case",
                    "please report this with the spec and the seed");
    });
  }

  // Returns the numbers of an element in the first variant.
  std::span<const double> First(std::string_view array, std::size_t element) const {
    return header_.NumbersOf(array, element, survey_.first);
  }

  // Finds joints that have no friction in the first variant but have friction in another variant.
  // Sets their `frictionloss` to the largest value of any variant, because simulators ignore the
  // friction of joints that have none in the base.
  std::string WithFriction(const std::string& text) {
    const auto& [shape, at] = header_.Find("dof_frictionloss");
    std::vector<std::pair<std::string, double>> joints;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (survey_.first[at + i] == 0 && survey_.largest[at + i] > 0 && shape.components[i] == 0)
        joints.emplace_back(shape.elements[i], survey_.largest[at + i]);
    }
    return WithFrictions(text, joints);
  }

  const Header& header_;
  const bytes::Assets& assets_;
  const Survey& survey_;
  diag::Findings& findings_;
  std::optional<engine::Engine> engine_;
  std::vector<NewPose> poses_;
  FinalBase base_;
};

}  // namespace

std::optional<FinalBase> Complete(const Header& header, const bytes::Assets& assets,
                                  const Survey& survey, diag::Findings& findings) {
  return BaseCompletion(header, assets, survey, findings)();
}

}  // namespace mjforge::family
