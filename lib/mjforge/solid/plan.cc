#include "mjforge/solid/plan.h"

#include <algorithm>

#include <fmt/format.h>

namespace mjforge::solid {
namespace {

std::optional<std::vector<Corner>> Rounded(const Outline& outline, double round, double inset,
                                           Fault& fault) {
  return RoundedCorners(outline, std::vector<double>(outline.corners.size(), round), inset, fault);
}

/// The outline as it is seen.
Outline Drawn(const Outline& outline, double round) {
  constexpr int kPerTurn = 48;
  Fault unused;
  Outline drawn;
  for (const Point& point : PointsOf(*Rounded(outline, round, 0, unused), kPerTurn, false))
    drawn.Add(point, 0);
  return drawn;
}

bool HolesAreGood(const std::vector<Outline>& loops, double round, Fault& fault) {
  const Outline outline = Drawn(loops[0], round);
  for (std::size_t i = 1; i < loops.size(); ++i) {
    const Outline& hole = loops[i];
    if (const auto at = Meeting(hole, outline)) {
      fault = {"begins a line that crosses or touches the polygon", hole.sources[*at], i};
    } else if (!Contains(outline, hole.corners[0])) {
      fault = {"is outside of the polygon", std::nullopt, i};
    }
    for (std::size_t k = 1; k < i && fault.message.empty(); ++k) {
      if (const auto at = Meeting(hole, loops[k])) {
        fault = {fmt::format("begins a line that crosses or touches hole {}", k), hole.sources[*at],
                 i};
      } else if (Contains(loops[k], hole.corners[0]) || Contains(hole, loops[k].corners[0])) {
        fault = {fmt::format("and hole {} lie in each other", k), std::nullopt, i};
      }
    }
    if (!fault.message.empty()) return false;
  }
  return true;
}

/// What a bevel leaves at the ends must still be the same loops.
bool BevelIsGood(const Plan& plan, const Prism& prism, Fault& fault) {
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
  for (std::size_t i = 0; i < plan.loops.size(); ++i) {
    const Outline& loop = plan.loops[i];
    Outline& end = ends.emplace_back(loop);
    end.corners = ParallelOf(loop, prism.bevel);
    for (std::size_t k = 0; k < loop.corners.size(); ++k) {
      const std::size_t next = loop.Next(k);
      const Point before = loop.corners[next] - loop.corners[k];
      if (before.dot(end.corners[next] - end.corners[k]) > 0) continue;
      fault = {fmt::format("begins a side of {:g} m, too short for a bevel of {:g} m",
                           before.norm(), prism.bevel),
               loop.sources[k], i};
      return false;
    }
    Fault crossing;
    bool meets = !OutlineOf(end.corners, crossing);
    for (std::size_t k = 0; k < i && !meets; ++k) meets = Meeting(end, ends[k]).has_value();
    if (!meets) continue;
    fault = {fmt::format("leaves a part too thin for a bevel of {:g} m", prism.bevel), std::nullopt,
             i};
    return false;
  }
  return true;
}

/// Without corners at the place of the one before, as between two arcs that leave nothing of a
/// side.
void RemoveRepeats(std::vector<Point>& middle, std::vector<Point>& end) {
  constexpr double kSame = 1e-9;
  Eigen::AlignedBox2d box;
  for (const Point& point : middle) box.extend(point);
  const double same = kSame * box.diagonal().norm();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < middle.size(); ++i) {
    const Point& before = kept > 0 ? middle[kept - 1] : middle.back();
    if ((middle[i] - before).norm() <= same) continue;
    middle[kept] = middle[i];
    end[kept++] = end[i];
  }
  middle.resize(kept);
  end.resize(kept);
}

}  // namespace

std::vector<Corner> Plan::CornersOf(std::size_t loop, double inset) const {
  Fault unused;  // PlanOf has seen to that
  return *Rounded(loops[loop], loop == 0 ? round : 0, inset, unused);
}

std::vector<Node> Plan::BorderAt(double inset) const {
  std::vector<Node> border;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const std::vector<Node> nodes = NodesOf(CornersOf(i, inset));
    border.insert(border.end(), nodes.begin(), nodes.end());
  }
  return border;
}

Levels Plan::LevelsAt(double bevel, int per_turn, bool inside) const {
  Levels levels;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    std::vector<Point> middle = PointsOf(CornersOf(i, 0), per_turn, inside);
    std::vector<Point> end = PointsOf(CornersOf(i, bevel), per_turn, inside);
    RemoveRepeats(middle, end);
    levels.middle.Add(middle);
    levels.end.Add(end);
  }
  return levels;
}

std::optional<Plan> PlanOf(const Prism& prism, Fault& fault) {
  fault = {};
  Plan plan;
  plan.round = prism.round;
  std::optional<Outline> outline = OutlineOf(prism.polygon, fault);
  if (!outline || !Rounded(*outline, prism.round, 0, fault)) return std::nullopt;
  plan.loops.push_back(*std::move(outline));
  std::size_t count = prism.polygon.size();
  for (const std::vector<Point>& points : prism.holes) {
    std::optional<Outline> hole = OutlineOf(points, fault);
    count += points.size();
    if (hole && count > kMostPoints)
      fault = {fmt::format("is one of holes with more than {} points", kMostPoints), std::nullopt};
    if (!hole || count > kMostPoints) {
      fault.loop = plan.loops.size();
      return std::nullopt;
    }
    hole->Reverse();
    plan.loops.push_back(*std::move(hole));
  }
  if (!HolesAreGood(plan.loops, prism.round, fault)) return std::nullopt;
  if (prism.bevel > 0 && !BevelIsGood(plan, prism, fault)) return std::nullopt;
  return plan;
}

}  // namespace mjforge::solid
