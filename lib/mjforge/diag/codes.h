#pragma once

#include <span>
#include <string_view>

namespace mjforge::diag {

/// Every kind of finding, grouped by what was being done, which the first part of its name also
/// says. docs/errors.md has a chapter for each and tests/golden a case; tests compare them.
enum class Code {
  // Reading a file as YAML.
  kYamlCannotRead,
  kYamlEmpty,
  kYamlNotText,
  kYamlTooLarge,
  kYamlSyntax,
  kYamlTooDeep,
  kYamlDuplicateKey,
  kYamlAlias,
  kYamlTag,
  // Expressions.
  kExprSyntax,
  kExprUnknownName,
  kExprUnknownUnit,
  kExprType,
  kExprNotFinite,
  // The language, checked before any draw.
  kSpecVersion,
  kSpecUnknownKey,
  kSpecMissingKey,
  kSpecWrongType,
  kSpecWrongLength,
  kSpecBadValue,
  kSpecBadName,
  kSpecConflict,
  kSpecDuplicateName,
  kSpecUnknownMaterial,
  kSpecUnknownParameter,
  kSpecDistribution,
  kSpecEmptyRange,
  kSpecCycle,
  kSpecNotFound,
  kSpecImportCycle,
  kSpecUnnamedDraw,
  kSpecBadParent,
  kSpecNotConstant,
  kSpecUnused,
  // Drawing one variant's values.
  kSampleEmptyRange,
  kSampleBadArgument,
  kSampleRejected,
  // Building one variant.
  kModelBadValue,
  kModelBadRotation,
  kModelBadCount,
  kModelTooManyParts,
  kModelBadName,
  kModelDuplicateName,
  kModelNoParts,
  kModelNoMass,
  kModelBadPolygon,
  kModelBadMesh,
  kModelFileNotFound,
  kModelBadTexture,
  kModelUnknownReference,
  // Reading an attached MJCF file.
  kAttachBadInclude,
  kAttachNoBody,
  kAttachNotCarried,
  // Fitting an object to its target.
  kTargetDropped,
  // MuJoCo's verdict.
  kMujocoNotMjcf,
  kMujocoError,
  kMujocoWarning,
  kMujocoMismatch,
  kMujocoSelfCollision,
  // Whether an object behaves.
  kPhysicsUnstable,
  kPhysicsNotAtRest,
  kPhysicsTopples,
  kPhysicsDrifts,
  kPhysicsPenetrates,
  kPhysicsSinks,
  kPhysicsGainsEnergy,
  kPhysicsJointOvershoots,
  kPhysicsJointCollides,
  kPhysicsJointBlocked,
  kPhysicsJointNotBack,
  kPhysicsDensity,
  kPhysicsBulkDensity,
  kPhysicsInertia,
  kPhysicsCenterOfMass,
  kPhysicsOverlap,
  kPhysicsThin,
  kPhysicsSlender,
  kPhysicsLoose,
  kPhysicsFarVisual,
  kPhysicsUnseen,
  // Files written and read back.
  kOutputExists,
  kOutputCannotWrite,
  kOutputBadName,
  kOutputBadManifest,
  kOutputDiffers,
  // Many variants, several processes.
  kBatchWorkerDied,
  kBatchTooSlow,
  kBatchDiffers,
  kBatchMissing,
  kBatchUneven,
  // Pictures and viewers.
  kPictureNoRenderer,
  kPictureNothingVisible,
  kPictureUnknownJoint,
  kPictureBadJointValue,
  kPictureNoViewer,
  kPictureNoDisplay,
  // The page about a batch.
  kReportNoPicture,
};

struct CodeInfo {
  Code code;
  std::string_view name;     // "spec/unknown-key"
  std::string_view meaning;  // one line, for the catalogue
};

/// All codes, in the order of the enumeration.
std::span<const CodeInfo> AllCodes();

std::string_view CodeName(Code code);

/// True for codes that mean "input or output failed" (exit status 3) rather
/// than "the input is wrong" (exit status 1).
bool IsInputOutput(Code code);

}  // namespace mjforge::diag
