// Smallest enclosing disc of discs, by growing the basis of an LP-type problem.

#include "mjforge/placing/enclosing_disc.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace mjforge::placing {
namespace {

using Eigen::Vector2d;

constexpr double kRelativeRounding = 1e-12;
constexpr int kMostGrowths = 200;

// Returns the distance from a point to the farthest point of a disc.
double Reach(const Vector2d& from, const Disc& disc) {
  return (disc.center - from).norm() + disc.radius;
}

bool ContainsAll(const Disc& around, std::span<const Disc> discs) {
  return std::ranges::all_of(discs, [&](const Disc& disc) {
    return Reach(around.center, disc) <= around.radius * (1 + kRelativeRounding);
  });
}

Disc Around(const Disc& a, const Disc& b) {
  const Vector2d way = b.center - a.center;
  const double distance = way.norm();
  if (distance + b.radius <= a.radius) return a;
  if (distance + a.radius <= b.radius) return b;
  const double radius = (distance + a.radius + b.radius) / 2;
  return {a.center + way * ((radius - a.radius) / distance), radius};
}

// Returns the smallest disc that contains three discs and touches each (problem of Apollonius), if
// one exists: |x - c_i| = R - r_i. Differences of the squared equations are linear in x and R.
std::optional<Disc> Around(const Disc& a, const Disc& b, const Disc& c) {
  Eigen::Matrix2d edges;
  edges.row(0) = b.center - a.center;
  edges.row(1) = c.center - a.center;
  const double area = edges.determinant();
  if (std::abs(area) <= kRelativeRounding * edges.squaredNorm()) return std::nullopt;
  // Substitutes S = R - r_a and y = x - c_a, which gives |y| = S and the linear equations edges y =
  // constant + slope S.
  const Vector2d grow(b.radius - a.radius, c.radius - a.radius);
  Vector2d constant;
  constant << edges.row(0).squaredNorm() - grow.x() * grow.x(),
      edges.row(1).squaredNorm() - grow.y() * grow.y();
  Eigen::Matrix2d inverse;
  inverse << edges(1, 1), -edges(0, 1), -edges(1, 0), edges(0, 0);
  const Vector2d base = inverse * constant / (2 * area);
  const Vector2d slope = inverse * grow / area;
  // Solves |base + slope S|^2 = S^2 for S.
  const double p = slope.squaredNorm() - 1;
  const double q = base.dot(slope);
  const double s = base.squaredNorm();
  const double root = q * q - p * s;
  if (root < 0) return std::nullopt;
  std::optional<Disc> smallest;
  for (const double sign : {-1.0, 1.0}) {
    const double S =
        std::abs(p) < kRelativeRounding ? -s / (2 * q) : (-q + sign * std::sqrt(root)) / p;
    const double radius = S + a.radius;
    if (!(S >= 0) || radius < b.radius || radius < c.radius) continue;
    if (!smallest || radius < smallest->radius)
      smallest = Disc{a.center + base + slope * S, radius};
  }
  return smallest;
}

// Adds a disc, which is not inside the enclosing disc of the basis, to the basis: the at most three
// discs that determine the enclosing disc. Removes discs that the basis no longer needs. Returns
// the new enclosing disc.
Disc Extend(std::vector<Disc>& basis, const Disc& added) {
  std::vector<Disc> all = basis;
  all.push_back(added);
  Disc best{added.center, std::numeric_limits<double>::infinity()};
  const auto consider = [&](const Disc& around, std::vector<Disc> of) {
    if (around.radius >= best.radius || !ContainsAll(around, all)) return;
    best = around;
    basis = std::move(of);
  };
  consider(added, {added});
  const std::size_t others = all.size() - 1;
  for (std::size_t i = 0; i < others; ++i) {
    consider(Around(added, all[i]), {added, all[i]});
    for (std::size_t j = i + 1; j < others; ++j) {
      if (const auto around = Around(added, all[i], all[j]))
        consider(*around, {added, all[i], all[j]});
    }
  }
  return best;
}

}  // namespace

Disc EnclosingDisc(std::span<const Disc> discs) {
  std::vector<Disc> basis = {discs.front()};
  Disc around = discs.front();
  for (int i = 0; i < kMostGrowths; ++i) {
    const auto farthest = std::ranges::max_element(
        discs, {}, [&](const Disc& disc) { return Reach(around.center, disc); });
    const double reach = Reach(around.center, *farthest);
    if (reach <= around.radius * (1 + kRelativeRounding)) return around;
    std::vector<Disc> larger = basis;
    const Disc next = Extend(larger, *farthest);
    if (!std::isfinite(next.radius) || next.radius <= around.radius) break;  // because of rounding
    around = next;
    basis = std::move(larger);
  }
  // Widens the disc so that it contains all discs in spite of rounding.
  for (const Disc& disc : discs)
    around.radius = std::max(around.radius, Reach(around.center, disc));
  return around;
}

}  // namespace mjforge::placing
