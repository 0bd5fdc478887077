// Reader of declared regions, on which other bodies can stand, and their sites.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/pose_reader.h"
#include "mjforge/assemble/regions.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

// Half the thickness of a region's site, m.
constexpr double kHalfThickness = 0.0005;

// Ratio of the area of a polygon's convex hull to the square of the diagonal of its bounding box;
// with a smaller ratio, the corners are on a line.
constexpr double kLeastAreaRatio = 1e-9;

// Returns the key that specifies the extent of a region of this type.
Key ExtentKey(std::string_view type) { return type == "polygon" ? Key::kPolygon : Key::kSize; }

// Reports keys that have no meaning for the region's type. Returns true if there are any.
bool HasStrayRegionKeys(FieldReader& reader, const spec::Entry& entry, std::string_view type) {
  const bool is_auto = type == "auto";
  bool stray = false;
  for (const spec::Field& field : entry.fields) {
    const Key id = field.info->id;
    const bool is_extent = id == Key::kSize || id == Key::kPolygon;
    const bool is_common =
        id == Key::kType || id == Key::kHeight || id == Key::kMargin || id == Key::kClear;
    const bool fits = is_common || (id == Key::kArea ? is_auto
                                    : is_extent      ? !is_auto && id == ExtentKey(type)
                                                     : !is_auto);
    if (fits) continue;
    reader.Report(Code::kModelBadValue, field,
                  fmt::format("has no meaning for a region of type {}", type));
    stray = true;
  }
  return stray;
}

// Returns the index of a corner at which a counter-clockwise polygon is not convex. Returns nullopt
// if the polygon is convex.
std::optional<std::size_t> ConcaveCorner(const std::vector<Eigen::Vector2d>& corners) {
  constexpr double kStraight = 1e-9;  // rad; corners on an edge may deviate from it by rounding
  const std::size_t n = corners.size();
  double turned = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d before = corners[i] - corners[(i + n - 1) % n];
    const Eigen::Vector2d after = corners[(i + 1) % n] - corners[i];
    const double turn =
        std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
    if (!(turn > -kStraight && turn < std::numbers::pi - kStraight)) return i;
    turned += turn;
  }
  // Rejects star polygons (pentagrams): they also turn left at each corner, but by more than 360
  // degrees in all.
  if (turned > 3 * std::numbers::pi) return 0;
  return std::nullopt;
}

bool ReadPolygon(FieldReader& reader, const spec::Field& field, model::Region& region) {
  const std::optional<sample::PointList> points = reader.Points(field);
  if (!points) return false;
  std::vector<Eigen::Vector2d>& corners = region.corners;
  for (std::size_t i = 0; i + 1 < points->numbers.size(); i += 2)
    corners.emplace_back(points->numbers[i], points->numbers[i + 1]);
  if (corners.size() < 3)
    return reader.Report(Code::kModelBadValue, field, "has fewer than three corners");
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    if (corners[i] != corners[next]) continue;
    return reader.Report(Code::kModelBadValue, field,
                         fmt::format("has the same point at corners {} and {}", i + 1, next + 1),
                         "the last corner is connected to the first");
  }
  const double diagonal = solid::BoxAround(corners).sizes().norm();
  if (solid::AreaOf(solid::ConvexPolygonOf(corners)) <= kLeastAreaRatio * diagonal * diagonal)
    return reader.Report(Code::kModelBadValue, field, "has no area: its corners are on a line");
  const bool is_reversed = solid::AreaOf(corners) < 0;
  if (is_reversed) std::ranges::reverse(corners);
  const std::optional<std::size_t> concave = ConcaveCorner(corners);
  if (concave) {
    const std::size_t corner = is_reversed ? corners.size() - *concave : *concave + 1;
    return reader.Report(Code::kModelBadValue, field,
                         fmt::format("is not convex at its corner {}", corner),
                         "divide it into convex regions");
  }
  return true;
}

bool ReadExtent(FieldReader& reader, const spec::Entry& entry, std::string_view type,
                model::Region& region) {
  const Key key = ExtentKey(type);
  const spec::Field* field = entry.Find(key);
  if (field == nullptr)
    return reader.ReportElement(Code::kSpecMissingKey, entry.mark,
                                fmt::format("has no '{}'", spec::kRegionElement.Find(key)->key));
  if (type == "polygon") {
    region.type = model::RegionType::kPolygon;
    return ReadPolygon(reader, *field, region);
  }
  if (type == "disc") {
    region.type = model::RegionType::kDisc;
    const auto radius = reader.Vector<1>(*field);
    if (radius) region.half_size.setConstant((*radius)(0));
    return radius.has_value();
  }
  return reader.ReadOptional(entry, key, &FieldReader::Vector<2>, region.half_size);
}

}  // namespace

std::string TiltText(double tilt) {
  return fmt::format("tilted by {} degrees at the start",
                     expr::NumberText(std::round(tilt * 1800 / std::numbers::pi) / 10));
}

void CenterOrigin(model::Region& region) {
  if (region.type != model::RegionType::kPolygon) return;
  const Eigen::AlignedBox2d box = solid::BoxAround(region.corners);
  for (Eigen::Vector2d& corner : region.corners) corner -= box.center();
  region.half_size = box.sizes() / 2;
  region.X_BR.p += region.X_BR.q * Eigen::Vector3d(box.center().x(), box.center().y(), 0);
}

bool HasRoomWithin(const model::Region& region) {
  if (region.margin == 0) return true;
  if (region.type != model::RegionType::kPolygon)
    return region.margin < region.half_size.minCoeff();
  std::vector<Eigen::Vector2d> rest = region.corners;
  for (std::size_t i = 0; i < region.corners.size(); ++i) {
    const Eigen::Vector2d normal = solid::OutwardNormal(region.corners, i);
    rest = solid::Clipped(rest, normal, normal.dot(region.corners[i]) - region.margin);
  }
  constexpr double kStraight = 1e-9;  // sine of an angle; a corner with a smaller turn is left out
  return solid::AreaOf(solid::ConvexPolygonOf(std::move(rest), kStraight)) > 0;
}

void AddRegionTo(model::Body& body, model::Region region) {
  model::Site& site = body.sites.emplace_back();
  site.name = region.site;
  site.mark = region.mark;
  site.X_BS = region.X_BR;
  const Eigen::Vector2d half = region.half_size;
  if (region.type == model::RegionType::kDisc) {
    site.type = model::GeomType::kCylinder;
    site.size = {half.x(), kHalfThickness, 0};
  } else {
    site.type = model::GeomType::kBox;
    site.size = {half.x(), half.y(), kHalfThickness};
  }
  site.attributes.push_back({.name = "group", .numbers = {model::kRegionGroup}});
  body.regions.push_back(std::move(region));
}

void Assembly::AddRegions(Scope& scope, const std::vector<spec::Entry>& entries,
                          std::string_view owner, sample::StreamId regions) {
  for (const spec::Entry& entry : entries) {
    repetition_.Expand(entry, scope.values, regions, body().regions.size(),
                       [&] { AddRegion(scope, entry, owner, regions); });
  }
}

void Assembly::AddRegion(Scope& scope, const spec::Entry& entry, std::string_view owner,
                         sample::StreamId regions) {
  const std::optional<std::string> name = ReadName(scope, entry, regions, findings_);
  if (!name) return;
  FieldReader reader(scope.values, findings_, "region", *name,
                     sample::Child(regions, std::string_view(*name)));
  std::string type = "box";
  if (!reader.ReadOptional(entry, Key::kType, &FieldReader::Word, type) ||
      HasStrayRegionKeys(reader, entry, type))
    return;
  model::Region region;
  region.name = *name;
  region.site = fmt::format("{}{}{}", scope.prefix, owner, *name);
  region.mark = entry.mark;
  bool good = reader.ReadOptional(entry, Key::kMargin, &FieldReader::Number, region.margin);
  good &= reader.ReadOptional(entry, Key::kClear, &FieldReader::Number, region.clear);
  if (type == "auto") {
    FaceSearch search;
    search.body = current_body_;
    region.height = search.least_height;
    good &= reader.ReadOptional(entry, Key::kHeight, &FieldReader::Number, region.height);
    good &= reader.ReadOptional(entry, Key::kArea, &FieldReader::Number, search.least_area);
    search.least_height = region.height;
    search.pattern = std::move(region);
    if (good) face_searches_.push_back(std::move(search));
    return;
  }
  good &= reader.ReadOptional(entry, Key::kHeight, &FieldReader::Number, region.height);
  good &= reader.ReadOptional(entry, Key::kWalls, &FieldReader::Boolean, region.has_walls);
  good &= ReadExtent(reader, entry, type, region);
  const std::optional<model::Pose> pose = ReadPose(reader, entry);
  if (!good || !pose) return;
  region.X_BR = scope.X_BS * *pose;
  CenterOrigin(region);
  if (HasRoomWithin(region)) return AddRegionTo(body(), std::move(region));
  reader.Report(Code::kModelBadValue, *entry.Find(Key::kMargin), "leaves no room in the region");
}

void Assembly::SearchFaces(std::size_t first) {
  for (std::size_t i = first; i < face_searches_.size(); ++i) {
    const model::Region& region = face_searches_[i].pattern;
    std::string why_not = AddFoundRegions(face_searches_[i], object_);
    // Does not report searches of nested specs, which may have faces only for some parameters.
    if (!why_not.empty() && region.mark.file == spec_->mark.file)
      empty_searches_.push_back({region.name, region.mark, std::move(why_not)});
  }
  face_searches_.resize(first);
}

}  // namespace mjforge::assemble
