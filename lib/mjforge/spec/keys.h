#pragma once

namespace mjforge::spec {

/// Keys that some stage interprets. kAttribute: written to the MJCF element unchanged.
enum class Key {
  kAttribute,
  // object
  kFormat,
  kName,
  kDescription,
  kImport,
  kParams,
  kFunctions,
  kRequire,
  kMaterials,
  kDefaults,
  kParts,
  kSites,
  kCameras,
  kLights,
  kJoints,
  kBodies,
  kPose,
  kContact,
  kMjcf,
  kExpect,
  kPlacement,
  kTotalSize,
  kChecks,
  // parameters
  kValue,
  kDoc,
  kUnit,
  // every list entry
  kIf,
  kFor,
  kLet,
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
  kHeight,
  kProfile,
  kWall,
  kAngle,
  kFacets,
  kCrease,
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
  kExclude,
  // materials, textures
  kTexture,
  kBuiltin,
  // expectations
  kThat,
  kGap,
  kTouch,
  kApart,
  kInside,
  kMin,
  kMax,
  kAt,
  // defaults
  kPart,
  kSite,
  kJoint,
  // checks
  kSilence,
};

}  // namespace mjforge::spec
