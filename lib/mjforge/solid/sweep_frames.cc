// Frames along the segments of a path: points, tangents, and rotation-minimizing normals.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/solid/sweep_frames.h"

namespace mjforge::solid {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

void AddFrames(const PathSegment& segment, int per_turn, std::vector<SweepFrame>& frames) {
  const double turn = segment.type == PathSegment::Type::kArc
                          ? segment.angle / (2 * std::numbers::pi)
                      : segment.type == PathSegment::Type::kCubic ? 0.25
                                                                  : 0;
  const int steps = std::max(1, static_cast<int>(std::ceil(turn * per_turn - 1e-9)));
  const double start = frames.empty() ? 0 : frames.back().arc_length;
  double arc_length = start;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Vector3d d = segment.Derivative(t);
    const Vector3d p = segment.At(t);
    if (i > 0) arc_length += (p - frames.back().p).norm();
    frames.push_back({.p = p,
                      .tangent = d.normalized(),
                      .x = Vector3d::Zero(),
                      .cut = d.normalized(),
                      .radius = segment.RadiusAt(t),
                      .slope = (segment.radius_b - segment.radius_a) / d.norm(),
                      .arc_length = arc_length});
  }
}

void SetCut(SweepFrame& end, SweepFrame& start) {
  end.cut = start.cut = (end.tangent + start.tangent).normalized();
}

}  // namespace

std::vector<SweepFrame> SweepFramesOf(const std::vector<PathSegment>& segments, bool closed,
                                      int per_turn) {
  std::vector<SweepFrame> frames;
  for (const PathSegment& segment : segments) {
    const std::size_t before = frames.size();
    AddFrames(segment, per_turn, frames);
    if (before > 0) SetCut(frames[before - 1], frames[before]);
  }
  if (closed) SetCut(frames.back(), frames.front());
  const Vector3d& tangent = frames.front().tangent;
  Eigen::Index least = 0;
  tangent.cwiseAbs().minCoeff(&least);
  frames.front().x = tangent.cross(Vector3d::Unit(least)).normalized();
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const Quaterniond turn = Quaterniond::FromTwoVectors(frames[i - 1].tangent, frames[i].tangent);
    const Vector3d x = turn * frames[i - 1].x;
    frames[i].x = (x - x.dot(frames[i].tangent) * frames[i].tangent).normalized();
  }
  if (!closed) return frames;
  // Distributes the rotation between the last frame and the first along the path.
  const Quaterniond turn = Quaterniond::FromTwoVectors(frames.back().tangent, tangent);
  const Vector3d end = turn * frames.back().x;
  const Vector3d& x = frames.front().x;
  const double missing = std::atan2(end.cross(x).dot(tangent), end.dot(x));
  for (SweepFrame& frame : frames) {
    const double angle = missing * frame.arc_length / frames.back().arc_length;
    frame.x = Eigen::AngleAxisd(angle, frame.tangent) * frame.x;
  }
  return frames;
}

}  // namespace mjforge::solid
