// The keys of the language that the code refers to.

#pragma once

namespace mjforge::spec {

/// Keys that the code asks for. kAttribute is any other key; values of such keys are written to the
/// MJCF element unchanged.
enum class Key {
  kAttribute,
  // Object.
  kName,
  kParams,
  kMaterials,
  kParts,
  kMjcf,
  kPlacement,
  kStart,
  kTotalSize,
  // Parameters.
  kDoc,
  kUnit,
  kSection,
  // List entries.
  kIf,
  kFor,
  // Poses.
  kPos,
  kQuat,
  kEuler,
  kAxisAngle,
  kXyAxes,
  kZAxis,
  kFromTo,
  kUp,
  // Parts.
  kType,
  kSize,
  kDensity,
  kMass,
  kMaterial,
  kRole,
  kGrain,
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
  kInertia,
  kFile,
  kSpec,
  kFrame,
  kRgba,
  kGroup,
  // Joints.
  kAxis,
  kRange,
  kLimited,
  kDetent,
  kLead,
  kTurns,
  kRatio,
  kPolycoef,
  kLinks,
  kLength,
  // Start states.
  kValue,
  kVelocity,
  kCtrl,
  kAct,
  // Regions.
  kArea,
  kMargin,
  kClear,
  kWalls,
  // Bodies.
  kParent,
  kBody,
  kFewer,
  kFront,
  // Places.
  kAt,
  kUv,
  kBy,
  kSide,
  kYaw,
  kFacing,
  kLying,
  kOverhang,
  kPile,
  kOrder,
  kTime,
  // Materials and textures.
  kBuiltin,
  // Expectations.
  kThat,
  kGap,
  kTouch,
  kApart,
  kInside,
  kMin,
  kMax,
  // Defaults.
  kPart,
  kSite,
  kJoint,
};

}  // namespace mjforge::spec
