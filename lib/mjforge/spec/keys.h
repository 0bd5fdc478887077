#pragma once

namespace mjforge::spec {

/// Keys that some stage interprets. kAttribute: written to the MJCF element unchanged.
enum class Key {
  kAttribute,
  // object
  kName,
  kParams,
  kMaterials,
  kParts,
  kMjcf,
  kPlacement,
  kTotalSize,
  // parameters
  kDoc,
  kUnit,
  // every list entry
  kIf,
  kFor,
  // poses
  kPos,
  kQuat,
  kEuler,
  kAxisAngle,
  kXyAxes,
  kZAxis,
  kFromTo,
  kUp,
  // parts
  kType,
  kSize,
  kDensity,
  kMass,
  kMaterial,
  kRole,
  kPolygon,
  kHoles,
  kHeight,
  kRound,
  kRoundCollision,
  kBevel,
  kProfile,
  kWall,
  kAngle,
  kFacets,
  kCrease,
  kPath,
  kRadius,
  kBend,
  kSmooth,
  kClosed,
  kPoints,
  kScale,
  kFile,
  kSpec,
  kFrame,
  kRgba,
  kGroup,
  // joints
  kAxis,
  kRange,
  kLimited,
  // bodies
  kParent,
  kBody,
  // materials, textures
  kBuiltin,
  // expectations
  kThat,
  kGap,
  kTouch,
  kApart,
  kInside,
  kMin,
  kMax,
  // defaults
  kPart,
  kSite,
  kJoint,
  // checks
};

}  // namespace mjforge::spec
