// Tubes: volumes swept by a disc along a path, and their exact mass.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

#include "mjforge/solid/moments.h"
#include "mjforge/solid/render_mesh.h"
#include "mjforge/solid/sweep_mesh.h"

namespace mjforge::solid {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

/// Adds the moments of the volume swept by a disc along the segment, multiplied by `sign`. The
/// radius of the disc is that of the segment minus `less`. The disc's centre follows the path, so
/// that the volume of a slice of thickness ds is the disc's area times ds. The slice's centre of
/// mass is off the path by the curvature times r^2 / 4 (Goodman and Goodman, "Generalizations of
/// the theorems of Pappus", 1969).
void AddSegment(const PathSegment& segment, double less, double sign, Moments& sum) {
  using Rule = boost::math::quadrature::gauss<double, 20>;
  const auto add = [&](double t, double weight) {
    const Vector3d d = segment.Derivative(t);
    const double speed = d.norm();
    const Vector3d tangent = d / speed;
    const Vector3d dd = segment.SecondDerivative(t);
    const Vector3d curvature = (dd - dd.dot(tangent) * tangent) / (speed * speed);
    const Vector3d c = segment.At(t);
    const double r = segment.RadiusAt(t) - less;
    const double area = pi * r * r;
    const double ds = sign * weight * speed;
    const Vector3d shift = -area * r * r / 4 * curvature;
    sum.volume += ds * area;
    sum.first += ds * (area * c + shift);
    sum.second += ds * (area * c * c.transpose() + c * shift.transpose() + shift * c.transpose() +
                        area * r * r / 4 * (Matrix3d::Identity() - tangent * tangent.transpose()));
  };
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    for (const double side : {-1, 1})
      add(0.5 + side * Rule::abscissa()[i] / 2, Rule::weights()[i] / 2);
  }
}

/// Adds the moments of the volume between the disc at a segment's end p and the plane that cuts the
/// tube at the corner; `cut` is the plane's normal. `sign` is negated for a segment's start. Let u
/// be the vector from p to a point of the disc. Along the tangent, the plane is at the distance
/// dot(g, u) from this point. The volume is 0 by symmetry.
void AddCut(const Vector3d& p, const Vector3d& tangent, const Vector3d& cut, double r, double sign,
            Moments& sum) {
  const Vector3d g = -(cut - cut.dot(tangent) * tangent) / cut.dot(tangent);
  const double second = sign * pi * r * r * r * r / 4;
  const Vector3d first = second * g;
  const double along = second * g.squaredNorm() / 2;
  sum.first += first + along * tangent;
  sum.second += p * first.transpose() + first * p.transpose() +
                along * (p * tangent.transpose() + tangent * p.transpose());
}

Mass MassOf(const std::vector<PathSegment>& segments, const Tube& tube) {
  Moments sum;
  Vector3d origin = Vector3d::Zero();  // near the centre, to reduce cancellation
  for (const Vector3d& p : tube.path) origin += p / static_cast<double>(tube.path.size());
  const auto add = [&](double less, double sign) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
      PathSegment segment = segments[i];
      segment.a -= origin;
      segment.b -= origin;
      AddSegment(segment, less, sign, sum);
      if (i + 1 == segments.size() && !tube.closed) continue;
      const PathSegment& next = segments[(i + 1) % segments.size()];
      const Vector3d in = segments[i].Derivative(1).normalized();
      const Vector3d out = next.Derivative(0).normalized();
      const Vector3d cut = (in + out).normalized();
      const double r = segments[i].radius_b - less;
      AddCut(segment.At(1), in, cut, r, sign, sum);
      AddCut(segment.At(1), out, cut, r, -sign, sum);
    }
  };
  add(0, 1);
  if (tube.wall) add(*tube.wall, -1);
  return MassOf(sum, origin);
}

}  // namespace

std::optional<Solid> Make(const Tube& tube, Fault& fault) {
  const std::optional<std::vector<PathSegment>> segments = SweepPathOf(tube, fault);
  if (!segments) return std::nullopt;
  Solid solid;
  solid.render_mesh = MakeSweepMesh(*segments, tube);
  RoundCoordinates(solid.render_mesh);
  solid.pieces = MakeSweepPieces(*segments, tube);
  solid.mass = MassOf(*segments, tube);
  solid.extent = SweepExtentOf(*segments, tube.closed);
  return solid;
}

}  // namespace mjforge::solid
