// Placer: finds the pose of a body in a region or at a site, and tests the pose for overlap.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "mjforge/placing/balance.h"
#include "mjforge/placing/body_shapes.h"
#include "mjforge/placing/footprint.h"
#include "mjforge/placing/free_play.h"
#include "mjforge/placing/obstacles.h"
#include "mjforge/placing/orientation.h"
#include "mjforge/placing/placing.h"
#include "mjforge/placing/stable_poses.h"
#include "mjforge/placing/widest_gap.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using model::PlaceResult;
using model::PlaceTry;
using model::PlaceVerdict;
using model::Pose;

constexpr double kSameAngle = 1e-12;  // rad
// Distance, m, up to which obstacles carry a body that was lowered until it touched the first
// obstacle.
constexpr double kCarrying = 2 * kContactGap;
constexpr int kMostTurns = 20;
// Least gap between a body and the body beside it, m. Without a gap, rounding would decide whether
// the bodies overlap.
constexpr double kLeastGap = 1e-6;

Eigen::Quaterniond AboutZ(double angle) { return model::FromAxisAngle(Vector3d::UnitZ(), angle); }

// Returns the angle from the -y axis to a direction, counter-clockwise, rad.
double AngleOf(const Vector2d& direction) { return std::atan2(direction.x(), -direction.y()); }

// Returns the direction at an angle from the -y axis.
Vector2d DirectionAt(double angle) { return {std::sin(angle), -std::cos(angle)}; }

// Extent of shapes along a direction, m.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double Middle() const { return (low + high) / 2; }
  double Half() const { return (high - low) / 2; }
};

Extent ExtentOf(std::span<const distance::PlacedShape> shapes, const Vector2d& direction) {
  const Vector3d way(direction.x(), direction.y(), 0);
  Extent extent;
  for (const distance::PlacedShape& placed : shapes) {
    extent.low = std::min(extent.low, way.dot(distance::FarthestPoint(placed, -way)));
    extent.high = std::max(extent.high, way.dot(distance::FarthestPoint(placed, way)));
  }
  return shapes.empty() ? Extent{0, 0} : extent;
}

void Block(const Blocker& by, PlaceResult& result) {
  result.verdict = PlaceVerdict::kBlocked;
  result.blocker = by.body;
  result.distance = by.distance;
}

// The heading and position of a body in its region's frame R.
struct Stance {
  double yaw;
  Footprint footprint;         // turned by `yaw`
  std::optional<Vector2d> at;  // nullopt: the footprint does not fit into the region
};

// Evaluates one attempt (PlaceTry) to place a body in a region.
class RegionTry {
 public:
  RegionTry(const model::Object& object, const Orientation& of, const PlaceTry& where)
      : object_(object),
        of_(of),
        where_(where),
        region_(*where.region),
        X_WR_(PoseInWorld(object, where.support) * region_.X_BR) {
    if (region_.has_walls) region_.margin += kContactGap;
  }

  PlaceResult Run(const Obstacles& obstacles) const {
    const Stance stance = FindStance();
    PlaceResult result;
    result.footprint = stance.footprint.Box().sizes();
    result.size = of_.size;
    if (of_.size.z() + kContactGap > region_.height) {
      result.verdict = PlaceVerdict::kTooHigh;
    } else if (!stance.at) {
      result.verdict = PlaceVerdict::kTooLarge;
    } else if (where_.beside &&
               !FitsAt(region_, stance.footprint, *stance.at, OverhangAt(stance.yaw))) {
      const bool fits =
          PositionIn(region_, stance.footprint, {0, 0}, OverhangAt(stance.yaw)).has_value();
      result.verdict = fits ? PlaceVerdict::kOutside : PlaceVerdict::kTooLarge;
    } else {
      Put(stance, obstacles, result);
    }
    return result;
  }

  double WidestGap(const Obstacles& obstacles) const {
    return placing::WidestGap(region_, X_WR_, of_.size.z(), obstacles, SupportPlane());
  }

 private:
  Support SupportPlane() const {
    Support support{where_.support, X_WR_.p, X_WR_.q * Vector3d::UnitZ()};
    const auto at = [&](int body) -> const model::Body& {
      return object_.bodies[static_cast<std::size_t>(body)];
    };
    for (int body = where_.support; body >= 0 && !at(body).place_name.empty();
         body = at(body).parent)
      support.below.push_back(body);
    return support;
  }

  // Iterates if the body faces a point, because its heading and its position depend on each other.
  Stance FindStance() const {
    double yaw = YawAt(Vector2d::Zero());
    for (int i = 0;; ++i) {
      Stance stance{yaw, of_.footprint.Turned(yaw), std::nullopt};
      stance.at = where_.beside ? NextTo(yaw)
                                : PositionIn(region_, stance.footprint, where_.uv, OverhangAt(yaw));
      if (!where_.facing || !stance.at || i == kMostTurns) return stance;
      const double next = YawAt(*stance.at);
      if (std::abs(next - yaw) <= kSameAngle) return stance;
      yaw = next;
    }
  }

  Overhang OverhangAt(double yaw) const {
    return {where_.overhang, (AboutZ(yaw) * of_.q_LB * of_.p_BCm).head<2>()};
  }

  // Returns the angle of the body's front in L, rad. If the front points up or down, returns the
  // angle for the upright body.
  double FrontAngle() const {
    constexpr double kSteep = 0.1;
    const Vector2d front = DirectionAt(where_.front);
    const Vector2d ahead = (of_.q_LB * Vector3d(front.x(), front.y(), 0)).head<2>();
    return ahead.norm() > kSteep ? AngleOf(ahead) : where_.front;
  }

  double YawAt(const Vector2d& at) const {
    const double front = FrontAngle();
    Vector2d ahead = DirectionAt(front);
    if (where_.facing) {
      const Vector3d p_W(where_.facing->x(), where_.facing->y(), X_WR_.p.z());
      ahead = (X_WR_.Inverse() * p_W).head<2>() - at;
    } else if (where_.direction) {
      ahead = (X_WR_.q.conjugate() * Vector3d(where_.direction->x(), where_.direction->y(), 0))
                  .head<2>();
    } else if (where_.beside) {
      ahead = NeighbourFront();
    }
    return AngleOf(ahead) - front + where_.yaw;
  }

  Pose NeighbourPose() const { return X_WR_.Inverse() * PoseInWorld(object_, where_.beside->body); }

  Vector2d NeighbourFront() const {
    const Vector2d front = DirectionAt(where_.beside->front);
    return (NeighbourPose().q * Vector3d(front.x(), front.y(), 0)).head<2>();
  }

  // Returns the position beside the neighbour: `gap` away in the direction of `side`, and shifted
  // along the neighbour's side by the share `uv`. Distances are between extents of the bodies along
  // and across the neighbour's front.
  Vector2d NextTo(double yaw) const {
    const model::Beside& beside = *where_.beside;
    const Vector2d front = NeighbourFront().normalized();
    const Vector2d right(front.y(), -front.x());
    const bool is_lateral = beside.side == model::Side::kLeft || beside.side == model::Side::kRight;
    Vector2d away = is_lateral ? right : front;
    if (beside.side == model::Side::kLeft || beside.side == model::Side::kBack) away = -away;
    const Vector2d across = is_lateral ? -front : -right;
    const PlacedShapes own = ShapesAt(of_.shapes, {Vector3d::Zero(), AboutZ(yaw) * of_.q_LB});
    const PlacedShapes other = ShapesAt(ShapesBelow(object_, beside.body), NeighbourPose());
    const double gap = std::max(beside.gap, kLeastGap);
    const double distance = ExtentOf(other, away).high + gap - ExtentOf(own, away).low;
    const Extent along_other = ExtentOf(other, across);
    const Extent along_own = ExtentOf(own, across);
    const double shift = (is_lateral ? where_.uv.y() : where_.uv.x()) *
                         std::abs(along_other.Half() - along_own.Half());
    return distance * away + (along_other.Middle() - along_own.Middle() + shift) * across;
  }

  // Puts the body onto the region, and stores its pose in `result`. If the body would tip over or
  // is too near to an obstacle, also stores the verdict kBlocked and the blocking body.
  void Put(const Stance& stance, const Obstacles& obstacles, PlaceResult& result) const {
    const Support support = SupportPlane();
    Pose X_RB{{stance.at->x(), stance.at->y(), kContactGap - of_.bottom},
              AboutZ(stance.yaw) * of_.q_LB};
    const double rise = region_.has_walls ? Rise(X_RB, support, obstacles) : 0;
    X_RB.p.z() += rise;
    result.X_SupportBody = region_.X_BR * X_RB;
    const Pose X_WB = X_WR_ * X_RB;
    // A body that touches an obstacle above the region's plane, such as the edge of a wall, may tip
    // over.
    if (rise > kContactGap) {
      const PlacedShapes shapes = ShapesAt(of_.shapes, X_WB);
      const std::vector<Contact> contacts = obstacles.FindContacts(shapes, kCarrying);
      if (!IsBalanced(shapes, contacts, X_WB * of_.p_BCm)) {
        Block({contacts.empty() ? where_.support : contacts.front().body}, result);
        return;
      }
    }
    const Pose X_WL = X_WR_ * Pose{X_RB.p, AboutZ(stance.yaw)};
    const auto blocker =
        obstacles.FindBlocker({of_.placed, X_WL}, std::max(where_.clear, region_.clear), support);
    if (blocker) return Block(*blocker, result);
    const PlacedShapes shapes = ShapesAt(of_.shapes, X_WB);
    if (std::ranges::any_of(obstacles.FindContacts(shapes, kCarrying), &Contact::of_boxes)) return;
    const double drop = obstacles.Drop(shapes, support.up_W, kCarrying);
    if (drop < kCarrying) X_RB.p.z() -= drop + kContactDepth;
    result.X_SupportBody = region_.X_BR * X_RB;
  }

  // Returns the height above the region's plane at which the body, lowered from above, touches an
  // obstacle; 0 if the body touches none. The descent begins below the ceiling of the region or,
  // without a ceiling, above the body that has the region.
  double Rise(const Pose& X_RB, const Support& support, const Obstacles& obstacles) const {
    const auto [lowest, highest] = obstacles.HeightsOf(where_.support, support);
    const double start = std::isfinite(region_.height)
                             ? std::max(region_.height - of_.size.z() - 2 * kContactGap, 0.0)
                             : std::max(highest, 0.0);
    Pose X_RStart = X_RB;
    X_RStart.p.z() += start;
    const double most = start + std::max(-lowest, 0.0) + of_.size.z();
    const double drop = obstacles.Drop(ShapesAt(of_.shapes, X_WR_ * X_RStart), support.up_W, most);
    const double rise = drop < most ? start - std::max(drop - kContactGap, 0.0) : 0;
    if (rise <= 0 || rise < highest - kContactGap) return rise;
    // A body that would lie on a lid stands below the lid if it has room there.
    const PlacedShapes standing = ShapesAt(of_.shapes, X_WR_ * X_RB);
    return obstacles.Drop(standing, support.up_W, kContactGap) > 0 ? 0 : rise;
  }

  const model::Object& object_;
  const Orientation& of_;
  const PlaceTry& where_;
  model::Region region_;  // region of the attempt, with a margin to its walls
  Pose X_WR_;
};

class ExactPlacer : public model::Placer {
 public:
  void Begin(const model::Object& object) override {
    object_ = &object;
    obstacles_.Clear();
    TryBody(-1);
  }

  void AddObstacle(int body, double clear) override {
    obstacles_.Add(*object_, body, clear);
    TryBody(-1);
  }

  PlaceResult Try(int body, const PlaceTry& where) override {
    if (where.region == nullptr) return TryAtSite(body, where);
    return RegionTry(*object_, FindOrientation(body, where), where).Run(obstacles_);
  }

  int FindOverlap(int body, const Pose& X_WBody, const std::vector<int>& among) override {
    return obstacles_.FindOverlap(ShapesAt(ShapesBelow(*object_, body), X_WBody), among);
  }

  double WidestGap(int body, const PlaceTry& where) override {
    return RegionTry(*object_, FindOrientation(body, where), where).WidestGap(obstacles_);
  }

  std::vector<model::StablePose> StablePoses(int body, double front) override {
    return StablePosesOf(*object_, body, front);
  }

 private:
  const Orientation& FindOrientation(int body, const PlaceTry& where) {
    TryBody(body);
    auto orientation = std::ranges::find(orientations_, where.lying, &Orientation::asked);
    if (orientation == orientations_.end())
      orientation = orientations_.insert(orientation, OrientationOf(*object_, body, where.lying));
    return *orientation;
  }

  // Places the body so that the frames of two sites match, except for the yaw about their z axis.
  // The support is no obstacle, because bodies touch at their sites.
  PlaceResult TryAtSite(int body, const PlaceTry& where) const {
    Pose X_SiteSite;
    X_SiteSite.q = AboutZ(where.yaw);
    PlaceResult result;
    result.X_SupportBody = where.X_SupportSite * X_SiteSite * where.X_BodySite.Inverse();
    const Pose X_WSupport = PoseInWorld(*object_, where.support);
    const Support support{.body = where.support,
                          .p_W = X_WSupport * where.X_SupportSite.p,
                          .up_W = Vector3d::UnitZ(),
                          .is_ignored = true};
    const PlacedShapes shapes = ShapesAt(ShapesBelow(*object_, body), {});
    if (const auto blocker = obstacles_.FindBlocker({shapes, X_WSupport * result.X_SupportBody},
                                                    where.clear, support))
      Block(*blocker, result);
    return result;
  }

  // Clears the cached orientations if `body` is not the body of the last attempt.
  void TryBody(int body) {
    if (body == body_) return;
    body_ = body;
    orientations_.clear();
  }

  const model::Object* object_ = nullptr;
  Obstacles obstacles_;
  // Body of the last attempts, and cache of its orientations.
  int body_ = -1;
  std::vector<Orientation> orientations_;
};

}  // namespace

std::unique_ptr<model::Placer> MakePlacer() { return std::make_unique<ExactPlacer>(); }

}  // namespace mjforge::placing
