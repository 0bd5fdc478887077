#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

#include "mjforge/solid/look.h"
#include "mjforge/solid/moments.h"
#include "mjforge/solid/sweep.h"

namespace mjforge::solid {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using std::numbers::pi;

/// Adds what a disc that moves along the span sweeps. Its centre follows the line, so a slice of
/// the thickness ds has the volume of the disc times ds, and a centre that lies off the line by the
/// curvature times r^2 / 4 (Goodman and Goodman, "Generalizations of the theorems of Pappus",
/// 1969).
void AddSpan(const Span& span, double less, double sign, Moments& sum) {
  using Rule = boost::math::quadrature::gauss<double, 20>;
  const auto add = [&](double t, double weight) {
    const Vector3d d = span.Derivative(t);
    const double speed = d.norm();
    const Vector3d way = d / speed;
    const Vector3d turn = span.SecondDerivative(t);
    const Vector3d curvature = (turn - turn.dot(way) * way) / (speed * speed);
    const Vector3d c = span.At(t);
    const double r = span.RadiusAt(t) - less;
    const double area = pi * r * r;
    const double ds = sign * weight * speed;
    const Vector3d shift = -area * r * r / 4 * curvature;
    sum.volume += ds * area;
    sum.first += ds * (area * c + shift);
    sum.second += ds * (area * c * c.transpose() + c * shift.transpose() + shift * c.transpose() +
                        area * r * r / 4 * (Matrix3d::Identity() - way * way.transpose()));
  };
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    for (const double side : {-1, 1})
      add(0.5 + side * Rule::abscissa()[i] / 2, Rule::weights()[i] / 2);
  }
}

/// What the cut at a corner adds to the disc's way along a line that ends there, or with `sign` -1
/// takes from one that begins: the cut is at the distance g u from a point u of the disc.
void AddCut(const Vector3d& p, const Vector3d& way, const Vector3d& cut, double r, double sign,
            Moments& sum) {
  const Vector3d g = -(cut - cut.dot(way) * way) / cut.dot(way);
  const double second = sign * pi * r * r * r * r / 4;
  const Vector3d first = second * g;
  const double along = second * g.squaredNorm() / 2;
  sum.first += first + along * way;
  sum.second += p * first.transpose() + first * p.transpose() +
                along * (p * way.transpose() + way * p.transpose());
}

Mass MassOf(const std::vector<Span>& spans, const Tube& tube) {
  Moments sum;
  Vector3d origin = Vector3d::Zero();  // near the centre: the less cancels
  for (const Vector3d& p : tube.path) origin += p / static_cast<double>(tube.path.size());
  const auto add = [&](double less, double sign) {
    for (std::size_t i = 0; i < spans.size(); ++i) {
      Span span = spans[i];
      span.a -= origin;
      span.b -= origin;
      AddSpan(span, less, sign, sum);
      if (i + 1 == spans.size() && !tube.closed) continue;
      const Span& next = spans[(i + 1) % spans.size()];
      const Vector3d in = spans[i].Derivative(1).normalized();
      const Vector3d out = next.Derivative(0).normalized();
      const Vector3d cut = (in + out).normalized();
      const double r = spans[i].radius_b - less;
      AddCut(span.At(1), in, cut, r, sign, sum);
      AddCut(span.At(1), out, cut, r, -sign, sum);
    }
  };
  add(0, 1);
  if (tube.wall) add(*tube.wall, -1);
  return MassOf(sum, origin);
}

}  // namespace

std::optional<Solid> Make(const Tube& tube, Fault& fault) {
  const std::optional<std::vector<Span>> spans = CenterLineOf(tube, fault);
  if (!spans) return std::nullopt;
  Solid solid;
  solid.look = SweptLook(*spans, tube);
  RoundForText(solid.look);
  solid.pieces = SweptPieces(*spans, tube);
  solid.mass = MassOf(*spans, tube);
  return solid;
}

}  // namespace mjforge::solid
