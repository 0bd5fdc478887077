// Search for places: tries each body at drawn places until one is free, and stores the pose.

#include "mjforge/assemble/placements.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/names.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

// Maximum number of tries to find a place for one body.
constexpr std::size_t kMaxTries = 1000;
// Number of tries after which the search ends if every try failed because of the region itself, not
// because of other bodies.
constexpr std::size_t kHopelessTries = 200;

bool IsHopeless(const Misses& misses) {
  const bool never_fits = misses.AreAll(model::PlaceVerdict::kTooLarge) ||
                          misses.AreAll(model::PlaceVerdict::kTooHigh) ||
                          misses.AreAll(model::PlaceVerdict::kOutside);
  return never_fits && misses.count >= kHopelessTries;
}

// Returns a joint between a body and its ancestor `top` that can tilt objects on the body; null if
// there is none. Free joints are ignored, because a free body carries objects as well as the floor
// does.
const model::Joint* TiltingJoint(const std::vector<model::Body>& bodies,
                                 const std::vector<model::Pose>& X_WB, int body, int top) {
  constexpr double kVertical = 1e-6;  // sine of the angle to the vertical; tolerance for rounding
  for (; body >= 0 && body != top; body = bodies[static_cast<std::size_t>(body)].parent) {
    const auto i = static_cast<std::size_t>(body);
    for (const model::Joint& joint : bodies[i].joints) {
      if (joint.type == "ball") return &joint;
      if (joint.type == "hinge" && (X_WB[i].q * joint.axis).head<2>().norm() > kVertical)
        return &joint;
    }
  }
  return nullptr;
}

}  // namespace

void Assembly::PlaceBodies(Scope& scope) {
  if (placer_ == nullptr) {
    for (const spec::BodyEntry& entry : scope.values.spec().bodies) {
      if (!entry.place) continue;
      findings_.Add(Code::kModelBadPlace, entry.place->mark, "no search for places is available");
    }
    return;
  }
  Placements(scope, {object_, bodies_, repetition_, *placer_, place_seed_, left_out_, findings_})
      .Run();
}

void Placements::Run() {
  // Makes the spec's root body, which has no pose yet, a child of the world during the search,
  // because bodies must stand upright in the frame of the spec.
  model::Body& root = context_.object.bodies[static_cast<std::size_t>(scope_.body)];
  const int parent = std::exchange(root.parent, -1);
  context_.placer.Begin(context_.object);
  context_.placer.AddObstacle(scope_.body);
  X_WB_ = model::BodyPoses(context_.object);
  sample::Evaluator& values = scope_.values;
  const sample::StreamId bodies = sample::Child(values.root(), "bodies");
  for (const spec::BodyEntry& entry : values.spec().bodies) {
    if (!entry.place) continue;
    const auto count = context_.repetition.Count(entry.head, values, 0);
    if (!count) continue;
    instances_ = entry.head.condition ? 0 : *count;
    standing_ = 0;
    context_.repetition.ForEach(entry.head, values, bodies, [&] { Place(entry, bodies); });
  }
  WarnOfSweptPlaces();
  context_.object.bodies[static_cast<std::size_t>(scope_.body)].parent = parent;
}

void Placements::Place(const spec::BodyEntry& entry, sample::StreamId bodies) {
  const std::optional<std::string> name = scope_.values.Text(entry.head.name, bodies);
  const auto found = name ? context_.bodies.find(scope_.prefix + *name) : context_.bodies.end();
  if (found == context_.bodies.end()) return;  // the body was left out, or an error was reported
  const Request request = {entry, *name, found->second};
  const model::Body& body = context_.object.bodies[static_cast<std::size_t>(request.body)];
  if (!body.place_name.empty()) return;  // the entry repeats its name, which was reported
  sample::StreamId places = sample::Child(sample::Child(bodies, std::string_view(*name)), "place");
  if (context_.seed) places = sample::Child(places, std::size_t{*context_.seed});
  if (entry.place->pile) return PileUp(request, places);
  Misses misses;
  std::optional<Trial> trial;
  do {
    trial = Draw(request, sample::Child(places, misses.count));
    if (!trial) return;
    const model::PlaceResult result = context_.placer.Try(request.body, trial->where);
    if (result.verdict == model::PlaceVerdict::kStands) return Settle(request, *trial, result);
    misses.Add(result, names_);
  } while (trial->is_drawn && misses.count < kMaxTries && !IsHopeless(misses));
  GiveUp(request, *trial, misses);
}

bool Placements::HasHeading(const Request& request, const Trial& trial,
                            const model::PlaceResult& result) {
  constexpr double kSamePoint = 1e-6;  // m
  if (!trial.where.facing) return true;
  const Eigen::Vector3d p_W = X_WB(trial.where.support) * result.X_SupportBody.p;
  if ((p_W.head<2>() - *trial.where.facing).norm() > kSamePoint) return true;
  FieldReader(scope_.values, context_.findings, "body", request.name, scope_.values.root())
      .Report(Code::kModelBadPlace, *request.entry.place->Find(Key::kFacing),
              "is the point at which the body stands", "turn it by `yaw`");
  return false;
}

void Placements::Settle(const Request& request, const Trial& trial,
                        const model::PlaceResult& result) {
  if (!HasHeading(request, trial, result)) return;
  ++standing_;
  const int support = trial.where.support;
  const std::vector<model::Body>& bodies = context_.object.bodies;
  if (const model::Joint* joint = TiltingJoint(bodies, X_WB_, support, scope_.body)) {
    diag::Finding& finding = context_.findings.Warn(
        Code::kModelBadPlace, request.entry.place->mark,
        fmt::format("body {} stands at {}, which joint {} tilts", Quoted(request.name),
                    Quoted(trial.at), Quoted(joint->name.substr(scope_.prefix.size()))),
        "it falls when the joint moves");
    finding.notes.push_back({joint->mark, "the joint is here"});
  }
  model::Body& body = context_.object.bodies[static_cast<std::size_t>(request.body)];
  body.parent = support;
  body.X_PB = model::Pose();
  const model::Pose X_ZeroStart = model::StartPose(body);  // motion of the body's own joints
  body.X_PB = result.X_SupportBody;
  if (std::ranges::any_of(body.joints, model::HasStart))
    body.X_PB = body.X_PB * X_ZeroStart.Inverse();
  body.place_name = names_.OutermostName(trial.at);
  context_.placer.AddObstacle(request.body, trial.where.clear);
  placed_.push_back(request.body);
  X_WB_ = model::BodyPoses(context_.object);
}

bool Placements::LeaveOut(const Request& request) {
  FieldReader reader(scope_.values, context_.findings, "body", request.name, scope_.values.root());
  bool fewer = false;
  reader.ReadOptional(request.entry.head, Key::kFewer, &FieldReader::Boolean, fewer);
  if (!fewer) return false;
  context_.left_out.insert(scope_.prefix + request.name);
  return true;
}

void Placements::GiveUp(const Request& request, const Trial& trial, const Misses& misses) {
  if (LeaveOut(request)) return;
  NoRoom what;
  what.body = request.name;
  what.at = trial.at;
  what.owner = names_.NameOf(trial.where.support);
  what.region = trial.where.region;
  what.clear = trial.where.clear;
  what.standing = standing_;
  what.instances = instances_;
  what.mark = request.entry.place->Find(Key::kAt)->value.mark;
  what.target = trial.target.mark();
  what.has_uv = request.entry.place->Find(Key::kUv) != nullptr;
  if (trial.where.beside) what.beside = names_.NameOf(trial.where.beside->body);
  if (what.region != nullptr && !what.has_uv && what.beside.empty())
    what.widest_gap = context_.placer.WidestGap(request.body, trial.where);
  ReportNoRoom(what, misses, context_.findings);
}

}  // namespace mjforge::assemble
