// The table of part types and the keys that each type takes.

#include "mjforge/spec/shapes.h"

#include <algorithm>
#include <array>

namespace mjforge::spec {
namespace {

constexpr std::array kSize = {Key::kSize};
constexpr std::array kBox = {Key::kHoles, Key::kRound, Key::kRoundCollision, Key::kGrain};
constexpr std::array kRoundCylinder = {Key::kRound, Key::kRoundCollision, Key::kFacets,
                                       Key::kCrease};
constexpr std::array kHowRoundBox = {Key::kRoundCollision};
constexpr std::array kHowRoundCylinder = {Key::kRoundCollision, Key::kFacets, Key::kCrease};
constexpr std::array kHowRoundPrism = {Key::kFacets};
constexpr std::array kPolygon = {Key::kPolygon, Key::kHeight};
constexpr std::array kPrism = {Key::kScale,  Key::kHoles,  Key::kRound, Key::kBevel,
                               Key::kFacets, Key::kCrease, Key::kGrain};
constexpr std::array kProfile = {Key::kProfile};
constexpr std::array kLathe = {Key::kWall, Key::kAngle, Key::kFacets, Key::kCrease};
constexpr std::array kPath = {Key::kPath};
constexpr std::array kTube = {Key::kRadius, Key::kBend,   Key::kSmooth, Key::kClosed,
                              Key::kWall,   Key::kFacets, Key::kCrease};
constexpr std::array kPoints = {Key::kPoints};
constexpr std::array kHull = {Key::kRound, Key::kGrain};
constexpr std::array kFile = {Key::kFile};
constexpr std::array kMesh = {Key::kScale, Key::kInertia};

constexpr std::array kShapes = {
    ShapeInfo{"box", 3, 2, kSize, kBox, kHowRoundBox},
    ShapeInfo{"sphere", 1, 0, kSize},
    ShapeInfo{"cylinder", 2, 1, kSize, kRoundCylinder, kHowRoundCylinder},
    ShapeInfo{"capsule", 2, 1, kSize},
    ShapeInfo{"ellipsoid", 3, 2, kSize},
    ShapeInfo{"prism", 0, 0, kPolygon, kPrism, kHowRoundPrism},
    ShapeInfo{"lathe", 0, 0, kProfile, kLathe},
    ShapeInfo{"tube", 0, 0, kPath, kTube},
    ShapeInfo{"hull", 0, 0, kPoints, kHull},
    ShapeInfo{"mesh", 0, 0, kFile, kMesh},
};

bool IsIn(std::span<const Key> keys, Key key) { return std::ranges::find(keys, key) != keys.end(); }

}  // namespace

bool ShapeInfo::Takes(Key key) const {
  if (key == Key::kFromTo || key == Key::kUp) return sizes_fromto > 0;
  return IsIn(required, key) || IsIn(optional, key);
}

const ShapeInfo* FindShape(std::string_view type) {
  return diag::Find(kShapes, type, &ShapeInfo::type);
}

bool AnyShapeTakes(Key key) {
  static const auto kAnyTakes = [] {
    std::array<bool, static_cast<std::size_t>(Key::kJoint) + 1> takes{};
    for (std::size_t k = 0; k < takes.size(); ++k) {
      takes[k] = std::ranges::any_of(
          kShapes, [&](const ShapeInfo& shape) { return shape.Takes(static_cast<Key>(k)); });
    }
    return takes;
  }();
  return kAnyTakes[static_cast<std::size_t>(key)];
}

}  // namespace mjforge::spec
