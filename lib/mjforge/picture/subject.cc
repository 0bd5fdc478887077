// Pose of a subject: search for joints by name, and setting of joint positions.

#include "mjforge/picture/subject.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace mjforge::picture {
namespace {

using diag::Code;

std::string_view NameOf(const mjModel& m, int joint) { return m.names + m.name_jntadr[joint]; }

// Returns true if `full` is `name` with a prefix: "hammer_hinge" for "hinge".
bool EndsIn(std::string_view full, std::string_view name) {
  return full.size() > name.size() + 1 && full.ends_with(name) &&
         full[full.size() - name.size() - 1] == '_';
}

// Returns the names of the hinges and slides, for suggestions: each name in full, and also without
// its first word, without its first two words, and so on ("box_lid_hinge", "lid_hinge", "hinge").
std::vector<std::string_view> JointNames(const mjModel& m) {
  std::vector<std::string_view> words;
  for (int i = 0; i < m.njnt; ++i) {
    if (!compiled::HasOneNumber(m, i)) continue;
    const std::string_view full = NameOf(m, i);
    words.push_back(full);
    for (std::size_t at = full.find('_'); at != full.npos; at = full.find('_', at + 1)) {
      words.push_back(full.substr(at + 1));
    }
  }
  return words;
}

}  // namespace

void Subject::State::Update() {
  compiled::UpdatePoses(*model, *data);
  mj_camlight(model.get(), data.get());
  mj_tendon(model.get(), data.get());
}

void Subject::State::Move(const JointPositions& pose) {
  for (const auto& [joint, value] : pose) data->qpos[model->jnt_qposadr[joint]] = value;
  Update();
}

void Subject::State::Move(const std::vector<double>& positions) {
  if (positions.size() != static_cast<std::size_t>(model->nq))
    throw std::invalid_argument("positions of another model");
  std::ranges::copy(positions, data->qpos);
  Update();
}

Subject::Subject(std::unique_ptr<State> state) : state_(std::move(state)) { Reset(Pose::kStart); }
Subject::~Subject() = default;

void Subject::Reset(Pose pose) {
  const mjModel& m = *state_->model;
  mjtNum* const qpos = state_->data->qpos;
  std::ranges::copy(compiled::StartOf(m), qpos);
  for (int i = 0; i < m.njnt && pose == Pose::kZero; ++i) {
    if (compiled::HasOneNumber(m, i)) qpos[m.jnt_qposadr[i]] = 0;
    if (m.jnt_type[i] == mjJNT_BALL)
      std::ranges::copy(std::array<mjtNum, 4>{1, 0, 0, 0}, qpos + m.jnt_qposadr[i]);
  }
  state_->Update();
}

std::vector<Joint> Subject::joints() const {
  const mjModel& m = *state_->model;
  std::vector<Joint> joints;
  for (int i = 0; i < m.njnt; ++i) {
    Joint& joint = joints.emplace_back();
    joint.name = NameOf(m, i);
    joint.type = static_cast<Joint::Type>(m.jnt_type[i]);
    joint.limited = m.jnt_limited[i] != 0;
    joint.range = {m.jnt_range[2 * i], m.jnt_range[2 * i + 1]};
    if (compiled::HasOneNumber(m, i)) joint.value = state_->data->qpos[m.jnt_qposadr[i]];
  }
  return joints;
}

std::optional<int> Subject::FindJoint(std::string_view name, diag::Findings& findings) const {
  const mjModel& m = *state_->model;
  std::vector<int> fitting;
  for (int i = 0; i < m.njnt; ++i) {
    if (NameOf(m, i) == name) return i;
    if (EndsIn(NameOf(m, i), name)) fitting.push_back(i);
  }
  if (fitting.size() == 1) return fitting.front();
  if (fitting.size() > 1) {
    findings.Add(Code::kPictureUnknownJoint, {},
                 fmt::format("'{}' could be joint '{}' or '{}'", name, NameOf(m, fitting[0]),
                             NameOf(m, fitting[1])),
                 "give its full name");
    return std::nullopt;
  }
  const std::vector<std::string_view> candidates = JointNames(m);
  std::string hint = diag::DidYouMean(name, candidates);
  if (hint.empty() && candidates.empty()) hint = "the object has no hinge or slide";
  if (hint.empty()) hint = "'--layer joints' shows the joints' names";
  findings.Add(Code::kPictureUnknownJoint, {}, fmt::format("there is no joint '{}'", name),
               std::move(hint));
  return std::nullopt;
}

bool Subject::SetJoint(int joint, double value, diag::Findings& findings) {
  const mjModel& m = *state_->model;
  if (!compiled::HasOneNumber(m, joint)) {
    findings.Add(Code::kPictureBadJointValue, {},
                 fmt::format("joint '{}' is {} and cannot be set by one number", NameOf(m, joint),
                             m.jnt_type[joint] == mjJNT_FREE ? "free" : "a ball"));
    return false;
  }
  const double lo = m.jnt_range[2 * joint];
  const double hi = m.jnt_range[2 * joint + 1];
  // Tolerance, because a value given in degrees is rounded when converted to radians.
  const double slack = 1e-6 * (hi - lo);
  if (m.jnt_limited[joint] != 0 && (value < lo - slack || value > hi + slack)) {
    const char* unit = m.jnt_type[joint] == mjJNT_HINGE ? "rad" : "m";
    findings.Add(Code::kPictureBadJointValue, {},
                 fmt::format("joint '{}' does not reach {:.6g} {}: its range is {:.6g} to {:.6g}",
                             NameOf(m, joint), value, unit, lo, hi));
    return false;
  }
  state_->data->qpos[m.jnt_qposadr[joint]] = value;
  state_->Update();
  return true;
}

}  // namespace mjforge::picture
