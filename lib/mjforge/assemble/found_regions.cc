// Search for regions of `type: auto`, and the check that declared regions are level at the start.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/level_faces.h"
#include "mjforge/assemble/names.h"
#include "mjforge/assemble/regions.h"

namespace mjforge::assemble {
namespace {

using Eigen::Vector2d;

// If a search finds no region, the message states the size of the largest level face with at least
// this area, m^2, and at least this free height, m.
constexpr double kAnyArea = 1e-8;
constexpr double kAnyHeight = 1e-5;

// Returns true if the body or one of its ancestors has a free joint or no place yet. Such a loose
// body does not limit the regions of other bodies.
bool IsLoose(const model::Object& object, std::size_t index) {
  auto i = static_cast<int>(index);
  while (i > 0) {
    const model::Body& body = object.bodies[static_cast<std::size_t>(i)];
    if (model::FreeJointOf(body) != nullptr) return true;
    i = body.parent;
  }
  return i < 0;
}

class FaceFinder {
 public:
  FaceFinder(const FaceSearch& search, const model::Object& object)
      : search_(search), object_(object), poses_(model::BodyPoses(object)) {}

  // Returns the colliding parts of one body; for the root body, only the parts that belong to the
  // spec.
  std::vector<PlacedShape> ShapesOf(std::size_t body) const {
    std::vector<PlacedShape> shapes;
    Add(body, shapes);
    return shapes;
  }

  // Returns the colliding parts of the searched body, and of all bodies of the spec that are not
  // loose.
  std::vector<PlacedShape> AllShapes() const {
    std::vector<PlacedShape> shapes;
    Add(search_.root, shapes);
    for (std::size_t i = search_.first_body; i < search_.last_body; ++i) {
      if (i == search_.body || !IsLoose(object_, i)) Add(i, shapes);
    }
    return shapes;
  }

  // Returns the face as a region with the name, site and margin that the spec gives for the
  // searched region. Quadrilaterals with right angles become boxes.
  model::Region RegionOf(const LevelFace& face, std::size_t body) const {
    model::Region region = search_.pattern;
    region.height = face.height;
    Vector2d center = Vector2d::Zero();
    for (const Vector2d& corner : face.corners)
      center += corner / static_cast<double>(face.corners.size());
    model::Pose X_RootR{.p = {0, 0, face.z}};
    if (face.radius) {
      region.type = model::RegionType::kDisc;
      region.half_size.setConstant(*face.radius);
      X_RootR.p.head<2>() = center;
    } else if (const auto box = SidesOf(face.corners)) {
      const auto& [x, y] = *box;
      region.half_size = {x.norm() / 2, y.norm() / 2};
      X_RootR.p.head<2>() = center;
      X_RootR.q = model::FromAxisAngle(Eigen::Vector3d::UnitZ(), std::atan2(x.y(), x.x()));
    } else {
      region.type = model::RegionType::kPolygon;
      region.corners = face.corners;
    }
    region.X_BR = poses_[body].Inverse() * X_RootR;
    CenterOrigin(region);
    return region;
  }

 private:
  // Adds the colliding parts of a body, with poses in the root frame.
  void Add(std::size_t body, std::vector<PlacedShape>& shapes) const {
    const bool is_root = body == search_.root;
    const std::vector<model::Part>& parts = object_.bodies[body].parts;
    const std::size_t last = is_root ? std::min(search_.last_part, parts.size()) : parts.size();
    for (std::size_t i = is_root ? search_.first_part : 0; i < last; ++i) {
      if (parts[i].role == model::Role::kVisual) continue;
      const model::Pose X_RootG = poses_[body] * parts[i].X_BG;
      shapes.push_back(
          {parts[i].shape, X_RootG, model::BoundsOf(parts[i].shape, X_RootG), parts[i].piece_of});
    }
  }

  // Returns the edge vectors of a rectangle, first the edge whose direction is closer to the x
  // axis. Returns nullopt for other polygons.
  static std::optional<std::pair<Vector2d, Vector2d>> SidesOf(
      const std::vector<Vector2d>& corners) {
    if (corners.size() != 4) return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector2d before = corners[i] - corners[(i + 3) % 4];
      const Vector2d after = corners[(i + 1) % 4] - corners[i];
      if (std::abs(before.dot(after)) > 1e-6 * before.norm() * after.norm()) return std::nullopt;
    }
    Vector2d x = corners[1] - corners[0];
    Vector2d y = corners[2] - corners[1];
    if (std::abs(x.x()) * y.norm() < std::abs(y.x()) * x.norm() * (1 - 1e-9)) std::swap(x, y);
    if (x.x() < 0) x = -x;
    return std::pair(x, y);
  }

  const FaceSearch& search_;
  const model::Object& object_;
  std::vector<model::Pose> poses_;  // poses of all bodies in the root frame
};

// Returns the reason why a search finds no region, for messages. `largest` is the largest level
// face, if there is one.
std::string WhyNothing(const FaceSearch& search, const std::optional<LevelFace>& largest) {
  if (!largest) return "no level face that collides";
  const double area = AreaOfFace(*largest);
  if (area >= search.least_area && largest->height >= search.least_height) {
    return fmt::format("its margin of {} m leaves no room on the largest level face, of {:.3g} m^2",
                       expr::NumberText(search.pattern.margin), area);
  }
  std::string text =
      fmt::format("no level face of at least {} m^2 with {} m of free height",
                  expr::NumberText(search.least_area), expr::NumberText(search.least_height));
  text += fmt::format("; the largest has {:.3g} m^2", area);
  if (std::isfinite(largest->height)) text += fmt::format(" and {:.3g} m", largest->height);
  return text;
}

}  // namespace

std::string AddFoundRegions(const FaceSearch& search, model::Object& object) {
  const FaceFinder finder(search, object);
  const std::vector<PlacedShape> all = finder.AllShapes();
  bool has_found = false;
  std::optional<LevelFace> largest;
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    // The search for level faces on a body with `mjcf:` includes all bodies of the MJCF file.
    const bool is_owner = i == search.body;
    if (!is_owner && object.bodies[i].attached != static_cast<int>(search.body)) continue;
    model::Body& body = object.bodies[i];
    int found = 0;
    const std::vector<PlacedShape> own = finder.ShapesOf(i);
    for (const LevelFace& face : FindLevelFaces(own, all, search.least_area, search.least_height)) {
      model::Region region = finder.RegionOf(face, i);
      if (!HasRoomWithin(region)) continue;
      if (!is_owner) region.site = fmt::format("{}_{}", body.name, region.name);
      if (found > 0) {
        region.name += fmt::format("_{}", found);
        region.site += fmt::format("_{}", found);
      }
      ++found;
      AddRegionTo(body, std::move(region));
      has_found = true;
    }
    if (has_found) continue;
    const std::vector<LevelFace> faces = FindLevelFaces(own, all, kAnyArea, kAnyHeight);
    if (!faces.empty() && (!largest || AreaOfFace(faces.front()) > AreaOfFace(*largest)))
      largest = faces.front();
  }
  return has_found ? std::string() : WhyNothing(search, largest);
}

void ReportEmptySearches(const std::vector<EmptySearch>& searches, diag::Findings& findings) {
  for (const EmptySearch& search : searches) {
    findings.Warn(
        diag::Code::kModelNoRegion, search.mark,
        fmt::format("region {} does not exist: {}", Quoted(search.region), search.why_not),
        "search with a smaller `area`, `height` or `margin`, or declare it with its `size`");
  }
}

void CheckLevelRegions(const model::Object& object, diag::SourceMark spec,
                       diag::Findings& findings) {
  std::vector<model::Pose> poses;
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    for (const model::Region& region : object.bodies[i].regions) {
      if (region.mark.file != spec.file) continue;
      if (poses.empty()) poses = model::BodyPoses(object);
      const double angle = model::TiltOf(poses[i] * region.X_BR);
      if (angle <= kLevelAngle) continue;
      findings.Add(diag::Code::kModelNotLevel, region.mark,
                   fmt::format("region '{}' leans by {:.3g} degrees at the start", region.name,
                               angle * 180 / std::numbers::pi),
                   "nothing can stand on it: turn it, or leave it out by `if`");
    }
  }
}

}  // namespace mjforge::assemble
