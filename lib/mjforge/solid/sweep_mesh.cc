// Render mesh of a tube, as rings around its path, and its pieces: capsules, cylinders, cones.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mjforge/solid/polytope.h"
#include "mjforge/solid/render_mesh.h"
#include "mjforge/solid/sweep_frames.h"
#include "mjforge/solid/sweep_mesh.h"

namespace mjforge::solid {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
constexpr int kAlongCurve = 32;  // frames along four cubic segments

class SweepMesher {
 public:
  SweepMesher(const std::vector<PathSegment>& segments, const Tube& tube) : tube_(tube) {
    const TextureMapping& texture = tube.texture;
    const bool by_metre = texture.unit == TextureMapping::Unit::kMetre;
    has_texture_ = texture.unit != TextureMapping::Unit::kNone;
    const Eigen::AlignedBox3d box = BoxAround(tube.path);
    const double radius = *std::ranges::max_element(tube.radii);
    const double error = ChordError(box.sizes().maxCoeff() / 2 + radius);
    sides_ = SegmentsPerTurn(radius, error, kWholeTurn);
    const int per_turn =
        tube.smooth ? kAlongCurve : SegmentsPerTurn(tube.bend + radius, error, kWholeTurn);
    frames_ = SweepFramesOf(segments, tube.closed, per_turn);
    around_ = texture.repeat.x() * (by_metre ? 2 * pi * radius : 1);
    along_ = texture.repeat.y() / (by_metre ? 1 : frames_.back().arc_length);
  }

  TriangleMesh Run() {
    AddSide(0);
    if (tube_.wall) AddSide(*tube_.wall);
    if (!tube_.closed) {
      AddEnd(frames_.front(), -1);
      AddEnd(frames_.back(), 1);
    }
    return std::move(mesh_);
  }

 private:
  /// Returns a point at the distance r from the path, on the plane that cuts the tube. `share` is
  /// the point's angle about the path, as a share of a whole turn.
  static Vector3d At(const SweepFrame& frame, double share, double r) {
    const Vector3d across = r * Across(frame, share);
    return frame.p + across - across.dot(frame.cut) / frame.tangent.dot(frame.cut) * frame.tangent;
  }

  /// Returns the number of vertices of a ring; the seam of a texture has two vertices.
  int RingSize() const { return has_texture_ ? sides_ + 1 : sides_; }

  static Vector3d Across(const SweepFrame& frame, double share) {
    const double turn = share == 1 ? 0 : 2 * pi * share;
    return std::cos(turn) * frame.x + std::sin(turn) * frame.y();
  }

  int Add(const Vector3d& p, const Vector3d& normal, double u, double v) {
    mesh_.vertices.push_back(p);
    mesh_.normals.push_back(normal);
    if (has_texture_) mesh_.texcoords.emplace_back(u, v);
    return static_cast<int>(mesh_.vertices.size()) - 1;
  }

  int AddRing(const SweepFrame& frame, bool is_smooth, double less) {
    const int first = static_cast<int>(mesh_.vertices.size());
    const double side = less > 0 ? -1 : 1;
    const double length = frames_.back().arc_length;
    for (int i = 0; i < RingSize(); ++i) {
      const double share = static_cast<double>(i) / sides_;
      Vector3d normal = (Across(frame, share) - frame.slope * frame.tangent).normalized();
      if (is_smooth) normal = (normal - normal.dot(frame.cut) * frame.cut).normalized();
      Add(At(frame, share, frame.radius - less), side * normal, share * around_,
          (length - frame.arc_length) * along_);
    }
    return first;
  }

  bool IsSmooth(const SweepFrame& end, const SweepFrame& start) const {
    return end.tangent.dot(start.tangent) >= std::cos(tube_.crease) &&
           std::abs(end.slope - start.slope) < 0.5;
  }

  /// Adds the outer side (less = 0), or the inner side of a wall with the thickness `less`, m.
  void AddSide(double less) {
    const int first = static_cast<int>(mesh_.vertices.size());
    const bool closes = tube_.closed && !has_texture_ && IsSmooth(frames_.back(), frames_.front());
    int before = -1;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      const SweepFrame& frame = frames_[i];
      const bool repeats = i > 0 && frames_[i - 1].arc_length == frame.arc_length;
      if (repeats && IsSmooth(frames_[i - 1], frame)) continue;
      const bool has_next = i + 1 < frames_.size() && frames_[i + 1].arc_length == frame.arc_length;
      const bool joins = has_next && IsSmooth(frame, frames_[i + 1]);
      const int ring = closes && i + 1 == frames_.size() ? first : AddRing(frame, joins, less);
      if (before >= 0 && !repeats) AddBand(before, ring, less > 0);
      before = ring;
    }
  }

  void AddBand(int from, int to, bool inward) {
    for (int i = 0; i < sides_; ++i) {
      const int next = (i + 1) % RingSize();
      if (inward)
        AddQuad(from + i, to + i, to + next, from + next, mesh_);
      else
        AddQuad(from + i, from + next, to + next, to + i, mesh_);
    }
  }

  void AddTriangle(int a, int b, int c, bool is_reversed) {
    if (is_reversed) std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  }

  /// Adds the disc or ring at an end. `side` is 1 at the end of the path and -1 at its start.
  void AddEnd(const SweepFrame& frame, double side) {
    const Vector3d normal = side * frame.tangent;
    const auto add = [&](double r) {
      const int first = static_cast<int>(mesh_.vertices.size());
      for (int i = 0; i < sides_; ++i) {
        const double share = static_cast<double>(i) / sides_;
        const double relative = r / frame.radius / 2;
        Add(At(frame, share, r), normal, 0.5 + relative * std::cos(2 * pi * share),
            0.5 + relative * std::sin(2 * pi * share));
      }
      return first;
    };
    const int outer = add(frame.radius);
    const int inner = tube_.wall ? add(frame.radius - *tube_.wall) : -1;
    for (int i = 0; i < sides_; ++i) {
      const int next = (i + 1) % sides_;
      if (inner >= 0) {
        AddTriangle(outer + i, outer + next, inner + next, side < 0);
        AddTriangle(outer + i, inner + next, inner + i, side < 0);
      } else if (i > 0 && next > 0) {
        AddTriangle(outer, outer + i, outer + next, side < 0);
      }
    }
  }

  const Tube& tube_;
  int sides_ = 0;
  std::vector<SweepFrame> frames_;
  bool has_texture_ = false;
  double around_ = 1;
  double along_ = 1;
  TriangleMesh mesh_;
};

/// Returns a truncated cone between two frames.
ConvexPiece ConeBetween(const SweepFrame& a, const SweepFrame& b) {
  constexpr int kSides = 12;
  ConvexPiece piece;
  for (const SweepFrame* frame : {&a, &b}) {
    for (int i = 0; i < kSides; ++i) {
      const double turn = 2 * pi * i / kSides;
      piece.mesh.vertices.emplace_back(
          frame->p + frame->radius * (std::cos(turn) * a.x + std::sin(turn) * a.y()));
    }
  }
  for (int i = 0; i < kSides; ++i) {
    const int next = (i + 1) % kSides;
    piece.mesh.triangles.push_back({i, next, kSides + next});
    piece.mesh.triangles.push_back({i, kSides + next, kSides + i});
    if (i == 0 || next == 0) continue;
    piece.mesh.triangles.push_back({0, next, i});
    piece.mesh.triangles.push_back({kSides, kSides + i, kSides + next});
  }
  return piece;
}

}  // namespace

TriangleMesh MakeSweepMesh(const std::vector<PathSegment>& segments, const Tube& tube) {
  return SweepMesher(segments, tube).Run();
}

std::vector<ConvexPiece> MakeSweepPieces(const std::vector<PathSegment>& segments,
                                         const Tube& tube) {
  const std::vector<SweepFrame> frames = SweepFramesOf(segments, tube.closed, tube.facets);
  std::vector<std::pair<SweepFrame, SweepFrame>> steps;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    if (frames[i + 1].arc_length > frames[i].arc_length)
      steps.emplace_back(frames[i], frames[i + 1]);
  }
  std::vector<ConvexPiece> pieces;
  bool was_round = tube.closed;  // the previous piece has a round end
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto& [a, b] = steps[i];
    const bool is_even = std::abs(a.radius - b.radius) <= 1e-9 * a.radius;
    const bool is_end = !tube.closed && (i == 0 || i + 1 == steps.size());
    const bool is_round = is_even && !is_end;
    const double half = (b.p - a.p).norm() / 2;
    // Fills the gap between two flat ends at a corner.
    if (!is_round && !was_round && i > 0)
      pieces.push_back(Primitive(ConvexPiece::Type::kSphere, {a.radius, 0, 0}, a.p, a.p));
    if (is_even) {
      pieces.push_back(
          Primitive(is_end ? ConvexPiece::Type::kCylinder : ConvexPiece::Type::kCapsule,
                    {a.radius, half, 0}, a.p, b.p));
    } else {
      pieces.push_back(ConeBetween(a, b));
    }
    was_round = is_round;
  }
  return pieces;
}

}  // namespace mjforge::solid
