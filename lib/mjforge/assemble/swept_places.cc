// Warnings of places that are in the way of a joint of the body on which they are.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"
#include "mjforge/assemble/placements.h"

namespace mjforge::assemble {
namespace {

// Number of positions of a joint, evenly spaced in its range, at which objects are looked for.
constexpr int kPositions = 33;

const model::Body& BodyOf(const model::Object& object, int body) {
  return object.bodies[static_cast<std::size_t>(body)];
}

// Returns true if a body is `top` or below it, and no body between them, and not the body itself,
// has a place.
bool IsPartOf(const model::Object& object, int body, int top) {
  for (; body >= 0 && body != top; body = BodyOf(object, body).parent) {
    if (!BodyOf(object, body).place_name.empty()) return false;
  }
  return body == top;
}

bool IsBelow(const model::Object& object, int body, int top) {
  while (body >= 0 && body != top) body = BodyOf(object, body).parent;
  return body == top;
}

// Returns the body of which `body` is a part: the nearest ancestor, or the body itself, that has a
// place or whose parent is the world or the root of the spec.
int OwnerOf(const model::Object& object, int body, int root) {
  while (body != root && BodyOf(object, body).place_name.empty() &&
         BodyOf(object, body).parent >= 0 && BodyOf(object, body).parent != root)
    body = BodyOf(object, body).parent;
  return body;
}

}  // namespace

void Placements::WarnOfSweptPlaces() {
  const model::Object& object = context_.object;
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    const int moved = static_cast<int>(i);
    const model::Body& body = object.bodies[i];
    if (body.joints.empty() || !body.place_name.empty()) continue;
    // Objects on the body that the joint belongs to, but not on the part that the joint moves.
    std::vector<int> standing;
    std::ranges::copy_if(placed_, std::back_inserter(standing), [&](int placed) {
      const int support = BodyOf(object, placed).parent;
      return IsPartOf(object, moved, OwnerOf(object, support, scope_.body)) &&
             !IsBelow(object, placed, moved);
    });
    if (standing.empty()) continue;
    for (std::size_t joint = 0; joint < body.joints.size(); ++joint)
      WarnOfSweep(i, joint, standing);
  }
}

void Placements::WarnOfSweep(std::size_t body, std::size_t joint,
                             const std::vector<int>& standing) {
  const model::Object& object = context_.object;
  model::Body moved;
  moved.X_PB = object.bodies[body].X_PB;
  moved.joints = object.bodies[body].joints;
  const model::Joint& of = object.bodies[body].joints[joint];
  if (of.type != "hinge" && of.type != "slide") return;
  const Eigen::Vector2d sweep = model::DisplacementsOf(of).array() + model::ZeroPosition(of)[0];
  if (sweep[0] == sweep[1]) return;
  const int parent = object.bodies[body].parent;
  for (int i = 0; i < kPositions; ++i) {
    const double position = std::lerp(sweep[0], sweep[1], i / (kPositions - 1.0));
    moved.joints[joint].start = {position};
    const model::Pose X_PB = model::StartPose(moved);
    const int hit = context_.placer.FindOverlap(static_cast<int>(body),
                                                parent < 0 ? X_PB : X_WB(parent) * X_PB, standing);
    if (hit < 0) continue;
    context_.findings
        .Warn(diag::Code::kModelBadPlace, BodyAt(hit).mark,
              fmt::format("body {} is in the way of joint {} at {}", Quoted(names_.NameOf(hit)),
                          Quoted(of.name.substr(scope_.prefix.size())),
                          of.type == "slide"
                              ? fmt::format("{:.3g} mm", 1000 * position)
                              : fmt::format("{:.3g} deg", position * 180 / std::numbers::pi)),
              "place it elsewhere, or limit the joint's range")
        .notes.push_back({of.mark, "the joint is here"});
    return;
  }
}

}  // namespace mjforge::assemble
