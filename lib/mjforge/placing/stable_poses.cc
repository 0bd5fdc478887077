// Stable poses from the faces of the convex hull.

#include "mjforge/placing/stable_poses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "mjforge/placing/body_shapes.h"
#include "mjforge/placing/tilting.h"
#include "mjforge/solid/solid.h"

namespace mjforge::placing {
namespace {

using Eigen::Vector3d;
using solid::Polytope;

constexpr int kAround = 64;         // points of a round shape per circle around its axis
constexpr int kAlong = 8;           // circles of points from the equator to the pole
constexpr double kCoplanar = 1e-4;  // rad; faces at smaller angles count as one face
constexpr double kRolling = 0.55;   // rad; angle between faces of a round side (12 or more faces)
constexpr double kUpright = 1e-6;   // rad; smaller rotations from the modelled pose are ignored
constexpr double kLeastMargin = 0.02;  // rad; poses that tip more easily are omitted
constexpr double kProbability = 1e-6;  // smaller differences do not change the order of poses
constexpr double kTie = 1e-9;          // smaller differences of cosines are rounding errors
constexpr double kSameHeight = 1e-6;   // m
constexpr double kMostTilt = 0.03;     // rad
constexpr double kFaceError = 0.01;    // rad; largest error of a face's normal at a round shape

// Returns a point of the unit sphere: point number `around` of the circle at the latitude number
// `along`. Longitudes begin with half a step, so that the sides of cylinders and capsules have
// faces perpendicular to the x and y axes.
Vector3d OnSphere(int around, int along) {
  const double longitude = 2 * std::numbers::pi * (around + 0.5) / kAround;
  const double latitude = std::numbers::pi / 2 * along / kAlong;
  return {std::cos(longitude) * std::cos(latitude), std::sin(longitude) * std::cos(latitude),
          std::sin(latitude)};
}

// Adds points, in frame A, whose convex hull equals or approximates the shape.
void AddPoints(const BodyShape& of, std::vector<Vector3d>& points_A) {
  const Vector3d& size = of.shape.size;
  const auto add = [&](const Vector3d& p_G) { points_A.push_back(of.X_AG * p_G); };
  switch (of.shape.type) {
    case model::GeomType::kMesh:
    case model::GeomType::kBox:
      for (const Vector3d& vertex : model::VerticesOf(of.shape)) add(vertex);
      return;
    case model::GeomType::kCylinder:
      for (int i = 0; i < kAround; ++i) {
        for (const double end : {-size.y(), size.y()})
          add(size.x() * OnSphere(i, 0) + Vector3d(0, 0, end));
      }
      return;
    case model::GeomType::kSphere:
    case model::GeomType::kEllipsoid:
    case model::GeomType::kCapsule:
      break;
  }
  const bool is_ellipsoid = of.shape.type == model::GeomType::kEllipsoid;
  const Vector3d radii = is_ellipsoid ? size : Vector3d(Vector3d::Constant(size.x()));
  const double shift = of.shape.type == model::GeomType::kCapsule ? size.y() : 0;
  for (int along = -kAlong; along <= kAlong; ++along) {
    const int count = std::abs(along) == kAlong ? 1 : kAround;
    for (int i = 0; i < count; ++i) {
      const Vector3d p_G = radii.cwiseProduct(OnSphere(i, along));
      if (along >= 0) add(p_G + Vector3d(0, 0, shift));
      if (along <= 0 && (shift > 0 || along < 0)) add(p_G - Vector3d(0, 0, shift));
    }
  }
}

// Returns the solid angle of a triangle seen from the origin (van Oosterom and Strackee, "The solid
// angle of a plane triangle", 1983).
double SolidAngle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)),
                        la * lb * lc + a.dot(b) * lc + a.dot(c) * lb + b.dot(c) * la);
}

// Returns the smallest rotation that turns a direction down; for +z a half turn about x.
Eigen::Quaterniond TurnDown(const Vector3d& direction) {
  if (direction.z() <= -std::cos(kUpright)) return Eigen::Quaterniond::Identity();
  const Vector3d axis = direction.cross(-Vector3d::UnitZ());
  const double angle = std::atan2(axis.norm(), -direction.z());
  return model::FromAxisAngle(axis.norm() > kUpright ? axis : Vector3d(Vector3d::UnitX()), angle);
}

// Faces of a hull that form one stable pose.
struct Rest {
  Vector3d down = Vector3d::Zero();  // normal of the representative face
  double margin = std::numbers::pi;
  double solid_angle = 0;
  std::size_t side = 0;   // index, in SidesOf(), of the side that is nearest to `down`
  double alignment = -1;  // cosine of the angle between `down` and that side
  double height = std::numeric_limits<double>::infinity();  // height of the centre of mass, m
};

// Names of stable poses by the side that is down, in the order of SidesOf(). The lower side of the
// modelled body has the name "leaning", for poses that differ a little from the modelled pose,
// which is named "upright".
constexpr std::array<std::string_view, 6> kNames = {"leaning", "upside_down", "on_front",
                                                    "on_back", "on_right",    "on_left"};

std::array<Vector3d, 6> SidesOf(double front) {
  const Vector3d ahead(std::sin(front), -std::cos(front), 0);
  const Vector3d right(ahead.y(), -ahead.x(), 0);
  return {-Vector3d::UnitZ(), Vector3d::UnitZ(), ahead, -ahead, right, -right};
}

// Joins the faces of a hull to stable poses.
class RestFinder {
 public:
  RestFinder(const Polytope& hull, const PlacedShapes& shapes, const Vector3d& center, double front)
      : hull_(hull),
        shapes_(shapes),
        center_(center),
        sides_(SidesOf(front)),
        leaders_(hull.faces.size()) {
    std::iota(leaders_.begin(), leaders_.end(), 0);
    for (std::size_t f = 0; f < hull.faces.size(); ++f) {
      double margin = std::numbers::pi;
      VisitEdges(f, [&](int a, int b) {
        margin = std::min(margin, TipAngle(f, a, b));
        faces_at_[{a, b}] = f;
      });
      is_stable_.push_back(margin >= -kCoplanar);
    }
    JoinFaces();
  }

  std::vector<Rest> Find() {
    std::map<std::size_t, Rest> rests;
    for (std::size_t f = 0; f < hull_.faces.size(); ++f) {
      Rest& rest = rests[Leader(f)];
      const std::vector<int>& corners = hull_.faces[f].corners;
      for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        rest.solid_angle +=
            SolidAngle(FromCenter(corners[0]), FromCenter(corners[i]), FromCenter(corners[i + 1]));
      VisitEdges(f, [&](int a, int b) {
        const auto other = faces_at_.find({b, a});
        if (other == faces_at_.end() || Leader(other->second) != Leader(f))
          rest.margin = std::min(rest.margin, TipAngle(f, a, b));
      });
      if (is_stable_[f]) Represent(hull_.faces[f].normal, rest);
    }
    std::vector<Rest> stable;
    for (auto& [leader, rest] : rests) {
      if (std::isfinite(rest.height) && rest.margin >= kLeastMargin && Settle(rest))
        stable.push_back(rest);
    }
    return stable;
  }

 private:
  // Moves the normal of a pose to where the exact shapes rest. Returns false if they do not rest
  // near it. The hull has polygons in place of circles, so that an edge and a point of a rim, from
  // which the body would roll along the rim, look like a face.
  bool Settle(Rest& rest) const {
    const Vector3d face =
        std::exchange(rest.down, LowestNear(shapes_, center_, rest.down, kFaceError));
    return face.dot(rest.down) >= std::cos(kFaceError) &&
           !SinksWhenTilted(shapes_, center_, rest.down, std::min(rest.margin / 2, kMostTilt));
  }

  Vector3d FromCenter(int corner) const {
    return hull_.vertices[static_cast<std::size_t>(corner)] - center_;
  }

  template <typename Visit>
  void VisitEdges(std::size_t face, const Visit& visit) const {
    const std::vector<int>& corners = hull_.faces[face].corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
      visit(corners[i], corners[(i + 1) % corners.size()]);
  }

  // Returns the angle, rad, by which a body that rests on a face must be tilted to tip over the
  // edge ab; negative if the centre of mass is beyond the edge.
  double TipAngle(std::size_t face, int a, int b) const {
    const Vector3d& normal = hull_.faces[face].normal;
    const Vector3d inwards = normal.cross(FromCenter(b) - FromCenter(a)).normalized();
    return std::atan2(-FromCenter(a).dot(inwards), FromCenter(a).dot(normal));
  }

  void JoinFaces() {
    for (const auto& [edge, f] : faces_at_) {
      const auto other = faces_at_.find({edge.second, edge.first});
      if (other == faces_at_.end()) continue;
      const std::size_t g = other->second;
      const Vector3d& normal = hull_.faces[g].normal;
      const double angle =
          std::atan2(hull_.faces[f].normal.cross(normal).norm(), hull_.faces[f].normal.dot(normal));
      if (angle <= kCoplanar || (angle <= kRolling && is_stable_[f] && is_stable_[g]))
        leaders_[Leader(f)] = Leader(g);
    }
  }

  std::size_t Leader(std::size_t face) const {
    while (leaders_[face] != face) face = leaders_[face];
    return face;
  }

  // Makes a face the representative of the pose if the centre of mass is lower above it or, at
  // equal heights, if its normal is nearer to one of the six sides than the representative's
  // normal; if both are equally near, the face with the earlier side is used.
  void Represent(const Vector3d& normal, Rest& rest) const {
    const double height = CenterHeight(shapes_, center_, normal);
    if (height > rest.height + kSameHeight) return;
    if (height < rest.height - kSameHeight) {
      rest.height = height;
      rest.alignment = -1;
    }
    for (std::size_t side = 0; side < sides_.size(); ++side) {
      const double alignment = normal.dot(sides_[side]);
      const bool is_tie = std::abs(alignment - rest.alignment) <= kTie;
      if (is_tie ? side >= rest.side : alignment < rest.alignment) continue;
      rest.alignment = alignment;
      rest.side = side;
      rest.down = normal;
    }
  }

  const Polytope& hull_;
  const PlacedShapes& shapes_;  // exact
  Vector3d center_;
  std::array<Vector3d, 6> sides_;
  std::vector<std::size_t> leaders_;  // union-find parents of the faces
  std::vector<bool> is_stable_;
  std::map<std::pair<int, int>, std::size_t> faces_at_;  // faces by the corners of an edge
};

}  // namespace

std::vector<model::StablePose> StablePosesOf(const model::Object& object, int body, double front) {
  std::vector<Vector3d> points;
  const std::vector<BodyShape> shapes = ShapesBelow(object, body);
  for (const BodyShape& shape : shapes) AddPoints(shape, points);
  solid::Fault fault;
  const std::optional<Polytope> hull = solid::HullOf(points, fault);
  if (!hull) return {};
  const PlacedShapes exact = ShapesAt(shapes, {});
  std::vector<Rest> rests = RestFinder(*hull, exact, MassBelow(object, body).p_FCm, front).Find();
  // Rounds the solid angles, because rounding errors must not decide the order of poses.
  const auto key = [](const Rest& rest) {
    return std::pair(-std::round(rest.solid_angle / kProbability), rest.side);
  };
  std::ranges::stable_sort(rests, {}, key);
  double sum = 0;
  for (const Rest& rest : rests) sum += rest.solid_angle;
  std::array<int, kNames.size()> counts{};
  std::vector<model::StablePose> poses;
  for (const Rest& rest : rests) {
    const Eigen::Quaterniond rotation = TurnDown(rest.down);
    std::string name(kNames[rest.side]);
    if (rotation.w() == 1) {
      name = "upright";
    } else if (const int count = ++counts[rest.side]; count > 1) {
      name += "_" + std::to_string(count);
    }
    poses.push_back({std::move(name), rotation, rest.margin, rest.solid_angle / sum});
  }
  return poses;
}

}  // namespace mjforge::placing
