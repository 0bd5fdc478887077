// Validation of a tube's path, arcs at its corners, and Catmull-Rom splines.

#include "mjforge/solid/sweep_path.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mjforge/solid/outline.h"

namespace mjforge::solid {
namespace {

using Eigen::Vector3d;

constexpr double kSame = 1e-12;      // distance of equal points, relative to the longest line
constexpr double kTurnsBack = 1e-6;  // a path turns back if 1 + cosine of its turn is at most this
constexpr double kFits = 1e-9;       // tolerance as a share of a line's length

class PathReader {
 public:
  PathReader(const Tube& tube, Fault& fault) : tube_(tube), fault_(fault) {
    const std::size_t count = tube.path.size();
    for (std::size_t i = 0; i < (tube.closed ? count : count - 1); ++i)
      lines_.emplace_back(tube.path[(i + 1) % count] - tube.path[i]);
    corners_.resize(count);
  }

  std::optional<std::vector<PathSegment>> Run() {
    if (!LinesAreValid()) return std::nullopt;
    if (tube_.smooth) return Smooth();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (!ReadCorner(i)) return std::nullopt;
    }
    if (!CornersFit()) return std::nullopt;
    std::vector<PathSegment> segments;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (tube_.bend > 0 && HasCorner(i) && corners_[i].turn > 0) segments.push_back(ArcAt(i));
      const std::size_t next = (i + 1) % tube_.path.size();
      const Vector3d direction = lines_[i].normalized();
      const double start = tube_.bend > 0 ? corners_[i].taken : 0;
      const double end = tube_.bend > 0 ? corners_[next].taken : 0;
      if (lines_[i].norm() - start - end <= kFits * lines_[i].norm()) continue;
      segments.push_back({.a = tube_.path[i] + start * direction,
                          .b = tube_.path[next] - end * direction,
                          .da = direction,
                          .db = direction,
                          .radius_a = tube_.radii[i],
                          .radius_b = tube_.radii[next],
                          .point = i});
    }
    return segments;
  }

 private:
  struct Corner {
    double turn = 0;   // rad
    double taken = 0;  // length that the corner removes from each of its two lines, m
  };

  bool HasCorner(std::size_t i) const {
    return tube_.closed || (i > 0 && i + 1 < tube_.path.size());
  }
  const Vector3d& LineInto(std::size_t i) const {
    return lines_[(i + lines_.size() - 1) % lines_.size()];
  }

  bool Fail(std::string message, std::size_t point) {
    fault_ = {std::move(message), point};
    return false;
  }

  bool LinesAreValid() {
    double size = 0;
    for (const Vector3d& line : lines_) size = std::max(size, line.norm());
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const std::size_t next = (i + 1) % tube_.path.size();
      if (lines_[i].norm() <= kSame * size)
        return Fail("is at the same place as the point before it", next);
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const double radius = tube_.radii[i];
      if (!(radius > 0)) return Fail(fmt::format("has a radius of {:g} m", radius), i);
      if (tube_.wall && *tube_.wall >= radius)
        return Fail(fmt::format("has a radius of {:g} m, no more than its wall of {:g} m", radius,
                                *tube_.wall),
                    i);
      if (!HasCorner(i)) continue;
      const double cosine = LineInto(i).normalized().dot(lines_[i].normalized());
      if (1 + cosine <= kTurnsBack) return Fail("turns back on the line before it", i);
    }
    return true;
  }

  bool ReadCorner(std::size_t i) {
    if (!HasCorner(i)) return true;
    const Vector3d in = LineInto(i).normalized();
    const Vector3d out = lines_[i].normalized();
    Corner& corner = corners_[i];
    corner.turn = std::atan2(in.cross(out).norm(), in.dot(out));
    if (corner.turn < 1e-9) corner.turn = 0;
    const double tangent = std::tan(corner.turn / 2);
    corner.taken = (tube_.bend > 0 ? tube_.bend : tube_.radii[i]) * tangent;
    if (corner.turn > 0 && tube_.bend > 0 && tube_.bend < tube_.radii[i])
      return Fail(fmt::format("bends with {:g} m, less than its radius of {:g} m", tube_.bend,
                              tube_.radii[i]),
                  i);
    return true;
  }

  bool CornersFit() {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const std::size_t next = (i + 1) % tube_.path.size();
      const double length = lines_[i].norm();
      const double taken = corners_[i].taken + corners_[next].taken;
      if (taken <= length * (1 + kFits)) continue;
      return Fail(
          fmt::format("begins a line of {:g} m, too short for its corners, which take {:g} m",
                      length, taken),
          i);
    }
    return true;
  }

  PathSegment ArcAt(std::size_t i) const {
    const Vector3d in = LineInto(i).normalized();
    const Vector3d out = lines_[i].normalized();
    const Vector3d start = tube_.path[i] - corners_[i].taken * in;
    const Vector3d inward = (out - in.dot(out) * in).normalized();
    return {.type = PathSegment::Type::kArc,
            .a = start + tube_.bend * inward,
            .b = Vector3d::Zero(),
            .da = -tube_.bend * inward,
            .db = tube_.bend * in,
            .angle = corners_[i].turn,
            .radius_a = tube_.radii[i],
            .radius_b = tube_.radii[i],
            .point = i};
  }

  // Returns a Catmull-Rom spline with centripetal knots, which has no loops. Source: Yuksel,
  // Schaefer and Keyser, "Parameterization and applications of Catmull-Rom curves", 2011.
  std::optional<std::vector<PathSegment>> Smooth() {
    const auto knot = [](const Vector3d& line) { return std::sqrt(line.norm()); };
    const auto slope = [&](std::size_t i) {  // derivative at a point, per unit of the knots
      const bool first = !HasCorner(i) && i == 0;
      const bool last = !HasCorner(i) && i > 0;
      const Vector3d& in = first ? lines_[0] : LineInto(i);
      const Vector3d& out = last ? in : lines_[i];
      const double before = knot(in);
      const double after = knot(out);
      const Vector3d sum = in / before - (in + out) / (before + after) + out / after;
      return first || last ? Vector3d(in / before) : sum;
    };
    std::vector<PathSegment> segments;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const std::size_t next = (i + 1) % tube_.path.size();
      const double step = knot(lines_[i]);
      segments.push_back({.type = PathSegment::Type::kCubic,
                          .a = tube_.path[i],
                          .b = tube_.path[next],
                          .da = step * slope(i),
                          .db = step * slope(next),
                          .radius_a = tube_.radii[i],
                          .radius_b = tube_.radii[next],
                          .point = i});
      if (!IsWideEnough(segments.back())) return std::nullopt;
    }
    return segments;
  }

  /// Rejects curves whose radius of curvature is less than the tube's radius.
  bool IsWideEnough(const PathSegment& segment) {
    constexpr int kSamples = 32;
    for (int k = 0; k <= kSamples; ++k) {
      const double t = static_cast<double>(k) / kSamples;
      const Vector3d d = segment.Derivative(t);
      const double curvature = d.cross(segment.SecondDerivative(t)).norm() / std::pow(d.norm(), 3);
      if (curvature * segment.RadiusAt(t) < 1) continue;
      return Fail(
          fmt::format("begins a curve with a radius of {:g} m, less than the tube's of {:g} m",
                      1 / curvature, segment.RadiusAt(t)),
          segment.point);
    }
    return true;
  }

  const Tube& tube_;
  Fault& fault_;
  std::vector<Vector3d> lines_;  // from each point to the next
  std::vector<Corner> corners_;
};

}  // namespace

Vector3d PathSegment::At(double t) const {
  if (type == Type::kLine) return (1 - t) * a + t * b;
  if (type == Type::kArc) return a + std::cos(t * angle) * da + std::sin(t * angle) * db;
  const double s = 1 - t;
  return s * s * (1 + 2 * t) * a + t * t * (1 + 2 * s) * b + t * s * s * da - t * t * s * db;
}

Vector3d PathSegment::Derivative(double t) const {
  if (type == Type::kLine) return b - a;
  if (type == Type::kArc) return angle * (std::cos(t * angle) * db - std::sin(t * angle) * da);
  return 6 * t * (1 - t) * (b - a) + (1 - t) * (1 - 3 * t) * da + t * (3 * t - 2) * db;
}

Vector3d PathSegment::SecondDerivative(double t) const {
  if (type == Type::kLine) return Vector3d::Zero();
  if (type == Type::kArc)
    return -angle * angle * (std::cos(t * angle) * da + std::sin(t * angle) * db);
  return 6 * (1 - 2 * t) * (b - a) + (6 * t - 4) * da + (6 * t - 2) * db;
}

std::optional<std::vector<PathSegment>> SweepPathOf(const Tube& tube, Fault& fault) {
  if (HasBadCount(tube.path.size(), tube.closed ? 3 : 2, fault)) return std::nullopt;
  return PathReader(tube, fault).Run();
}

}  // namespace mjforge::solid
