// Identifiers of the keys of the spec language that the code interprets.

#pragma once

namespace mjforge::spec {

/// Keys that the code interprets. kAttribute stands for all other keys: MJCF attributes whose
/// values are written under the same name, and keys that readers find by their text.
enum class Key {
  kAttribute,
  // Keys of objects.
  kName,
  kParams,
  kMaterials,
  kParts,
  kMjcf,
  kPlacement,
  kStart,
  kTotalSize,
  // Keys of parameters.
  kDoc,
  kUnit,
  kSection,
  // Keys of list entries.
  kIf,
  kFor,
  // Keys of poses.
  kPos,
  kQuat,
  kEuler,
  kAxisAngle,
  kXyAxes,
  kZAxis,
  kFromTo,
  kUp,
  // Keys of parts.
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
  // Keys of joints, couplings and chains.
  kAxis,
  kRange,
  kLimited,
  kDetent,
  kScrew,
  kCouple,
  kLead,
  kTurns,
  kRatio,
  kPolycoef,
  kLinks,
  kLength,
  // Keys of start states: `pose:`.
  kValue,
  kVelocity,
  kCtrl,
  kAct,
  // Keys of regions.
  kArea,
  kMargin,
  kClear,
  kWalls,
  // Keys of bodies and objects.
  kParent,
  kBody,
  kFewer,
  kFront,
  // Keys of places: `place:`, `beside:` and `pile:`.
  kAt,
  kUv,
  kBy,
  kSide,
  kYaw,
  kFacing,
  kLying,
  kOverhang,
  kOrder,
  kTime,
  // Keys of materials and textures.
  kBuiltin,
  // Keys of expectations: `expect:`.
  kThat,
  kGap,
  kTouch,
  kApart,
  kInside,
  kMin,
  kMax,
  // Keys of `defaults:`.
  kPart,
  kSite,
  kJoint,
};

}  // namespace mjforge::spec
