// Validation of rounding and bevels of a prism, and its cross sections.

#include "mjforge/solid/inset_polygon.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "mjforge/solid/hole_outlines.h"

namespace mjforge::solid {
namespace {

std::optional<std::vector<RoundedCorner>> Rounded(const Outline& outline, double round,
                                                  double inset, Fault& fault) {
  return RoundCorners(outline, std::vector<double>(outline.corners.size(), round), inset, fault);
}

/// Returns the outline with points along its rounded corners.
Outline Discretized(const Outline& outline, double round) {
  constexpr int kPerTurn = 48;
  Fault unused;
  Outline discretized;
  for (const Point2& point : PointsOf(*Rounded(outline, round, 0, unused), kPerTurn, false))
    discretized.Add(point, 0);
  return discretized;
}

/// Returns false and sets `fault` if the bevel is at least half the height or the radius of the
/// corners, removes a whole side, or makes loops touch each other or themselves.
bool BevelIsValid(const BasePolygon& base, const Prism& prism, Fault& fault) {
  if (2 * prism.bevel >= prism.height) {
    fault = {fmt::format("is bevelled by {:g} m, half its height of {:g} m or more", prism.bevel,
                         prism.height)};
    return false;
  }
  if (prism.round > 0 && prism.bevel >= prism.round) {
    fault = {fmt::format("is bevelled by {:g} m, no less than its corners are rounded with: {:g} m",
                         prism.bevel, prism.round)};
    return false;
  }
  std::vector<Outline> ends;
  for (std::size_t i = 0; i < base.loops.size(); ++i) {
    const Outline& loop = base.loops[i];
    Outline& end = ends.emplace_back(loop);
    end.corners = ParallelOf(loop, prism.bevel);
    for (std::size_t k = 0; k < loop.corners.size(); ++k) {
      const std::size_t next = loop.Next(k);
      const Point2 before = loop.corners[next] - loop.corners[k];
      if (before.dot(end.corners[next] - end.corners[k]) > 0) continue;
      fault = {fmt::format("begins a side of {:g} m, too short for a bevel of {:g} m",
                           before.norm(), prism.bevel),
               loop.sources[k], i};
      return false;
    }
    Fault crossing;
    bool meets = !OutlineOf(end.corners, crossing);
    for (std::size_t k = 0; k < i && !meets; ++k) meets = FirstContact(end, ends[k]).has_value();
    if (!meets) continue;
    fault = {fmt::format("leaves a part too thin for a bevel of {:g} m", prism.bevel), std::nullopt,
             i};
    return false;
  }
  return true;
}

/// Removes corners that coincide with the previous corner, which occur between two arcs that use up
/// a side.
void RemoveRepeats(std::vector<Point2>& middle, std::vector<Point2>& end) {
  constexpr double kSame = 1e-9;
  const double same = kSame * BoxAround(middle).diagonal().norm();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const Point2& before = kept > 0 ? middle[kept - 1] : middle.back();
    if ((middle[i] - before).norm() <= same) continue;
    middle[kept] = middle[i];
    end[kept++] = end[i];
  }
  middle.resize(kept);
  end.resize(kept);
}

}  // namespace

std::vector<RoundedCorner> BasePolygon::CornersOf(std::size_t loop, double inset) const {
  Fault unused;  // BasePolygonOf has validated the corners
  return *Rounded(loops[loop], loop == 0 ? round : 0, inset, unused);
}

std::vector<std::vector<ArcDirections>> BasePolygon::Directions() const {
  std::vector<std::vector<ArcDirections>> directions;
  for (std::size_t i = 0; i < loops.size(); ++i)
    directions.push_back(DirectionsOf(CornersOf(i, 0)));
  return directions;
}

std::vector<QuadratureNode> BasePolygon::BoundaryAt(
    double inset, const std::vector<std::vector<ArcDirections>>& directions) const {
  std::vector<QuadratureNode> boundary;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const std::vector<QuadratureNode> nodes = NodesOf(CornersOf(i, inset), directions[i]);
    boundary.insert(boundary.end(), nodes.begin(), nodes.end());
  }
  return boundary;
}

PrismSections BasePolygon::SectionsAt(double bevel, int per_turn, bool inside) const {
  PrismSections sections;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    std::vector<Point2> middle = PointsOf(CornersOf(i, 0), per_turn, inside);
    std::vector<Point2> end = PointsOf(CornersOf(i, bevel), per_turn, inside);
    RemoveRepeats(middle, end);
    sections.middle.Add(middle);
    sections.end.Add(end);
  }
  return sections;
}

std::optional<BasePolygon> BasePolygonOf(const Prism& prism, Fault& fault) {
  fault = {};
  BasePolygon base;
  base.round = prism.round;
  std::optional<Outline> outline = OutlineOf(prism.polygon, fault);
  if (!outline || !Rounded(*outline, prism.round, 0, fault)) return std::nullopt;
  base.loops.push_back(*std::move(outline));
  std::optional<std::vector<Outline>> holes =
      HolesIn(Discretized(base.loops[0], prism.round),
              {.outlines = prism.holes, .other_points = prism.polygon.size()}, fault);
  if (!holes) return std::nullopt;
  std::ranges::move(*holes, std::back_inserter(base.loops));
  if (prism.bevel > 0 && !BevelIsValid(base, prism, fault)) return std::nullopt;
  return base;
}

}  // namespace mjforge::solid
