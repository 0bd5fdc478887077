#include "mjforge/diag/codes.h"

#include <array>
#include <cstddef>

namespace mjforge::diag {
namespace {

constexpr std::array kCodes = {
    CodeInfo{Code::kYamlCannotRead, "yaml/cannot-read", "a file does not exist or cannot be read"},
    CodeInfo{Code::kYamlEmpty, "yaml/empty", "a file holds no YAML value"},
    CodeInfo{Code::kYamlNotText, "yaml/not-text", "a file is not UTF-8 text"},
    CodeInfo{Code::kYamlTooLarge, "yaml/too-large", "a file is larger than the limit"},
    CodeInfo{Code::kYamlSyntax, "yaml/syntax", "a file is not well-formed YAML"},
    CodeInfo{Code::kYamlTooDeep, "yaml/too-deep", "values are nested deeper than the limit"},
    CodeInfo{Code::kYamlDuplicateKey, "yaml/duplicate-key", "a mapping has the same key twice"},
    CodeInfo{Code::kYamlAlias, "yaml/alias",
             "an alias contains itself or unfolds to more than the limit"},
    CodeInfo{Code::kYamlTag, "yaml/tag", "a value carries a YAML tag"},
    CodeInfo{Code::kExprSyntax, "expr/syntax", "an expression is not well-formed"},
    CodeInfo{Code::kExprUnknownName, "expr/unknown-name",
             "an expression uses a name that is not defined there"},
    CodeInfo{Code::kExprUnknownUnit, "expr/unknown-unit",
             "a number carries a unit that does not exist"},
    CodeInfo{Code::kExprType, "expr/type",
             "an expression mixes numbers, booleans, texts or vectors"},
    CodeInfo{Code::kExprNotFinite, "expr/not-finite", "an expression gives infinity or no number"},
    CodeInfo{Code::kSpecVersion, "spec/version",
             "the format version is missing or is not one this program reads"},
    CodeInfo{Code::kSpecUnknownKey, "spec/unknown-key", "a key is not part of the language there"},
    CodeInfo{Code::kSpecMissingKey, "spec/missing-key", "a required key is missing"},
    CodeInfo{Code::kSpecWrongType, "spec/wrong-type", "a value is of the wrong kind"},
    CodeInfo{Code::kSpecWrongLength, "spec/wrong-length", "a list has too few or too many values"},
    CodeInfo{Code::kSpecBadValue, "spec/bad-value", "a value is outside what its key allows"},
    CodeInfo{Code::kSpecBadName, "spec/bad-name", "a name has characters that names cannot have"},
    CodeInfo{Code::kSpecConflict, "spec/conflict", "two keys exclude each other"},
    CodeInfo{Code::kSpecDuplicateName, "spec/duplicate-name", "two things have the same name"},
    CodeInfo{Code::kSpecUnknownMaterial, "spec/unknown-material", "a material is not defined"},
    CodeInfo{Code::kSpecUnknownParameter, "spec/unknown-parameter",
             "a parameter that is set does not exist"},
    CodeInfo{Code::kSpecDistribution, "spec/distribution",
             "a distribution is unknown or its arguments do not fit"},
    CodeInfo{Code::kSpecEmptyRange, "spec/empty-range", "a range's lower end is above its upper"},
    CodeInfo{Code::kSpecCycle, "spec/cycle", "parameters depend on each other in a circle"},
    CodeInfo{Code::kSpecNotFound, "spec/not-found", "a spec or an imported file is not found"},
    CodeInfo{Code::kSpecImportCycle, "spec/import-cycle", "a spec imports or contains itself"},
    CodeInfo{Code::kSpecUnnamedDraw, "spec/unnamed-draw",
             "a draw is in an entry that needs a name to be reproducible"},
    CodeInfo{Code::kSpecBadParent, "spec/bad-parent",
             "a body hangs on one that does not exist, comes later, or is itself"},
    CodeInfo{Code::kSpecNotConstant, "spec/not-constant",
             "a value that a batch is planned by is computed or drawn"},
    CodeInfo{Code::kSampleEmptyRange, "sample/empty-range",
             "a drawn variant has a range whose lower end is above its upper"},
    CodeInfo{Code::kSampleBadArgument, "sample/bad-argument",
             "a drawn variant gives a distribution an impossible argument"},
    CodeInfo{Code::kSampleRejected, "sample/rejected",
             "no draw met the requirements within the limit of attempts"},
    CodeInfo{Code::kModelBadValue, "model/bad-value",
             "a variant's value is outside what its attribute allows"},
    CodeInfo{Code::kModelBadRotation, "model/bad-rotation",
             "a variant's orientation is not a rotation"},
    CodeInfo{Code::kModelBadCount, "model/bad-count",
             "a repetition's count is not a whole number from 0 up"},
    CodeInfo{Code::kModelTooManyParts, "model/too-many-parts",
             "an object has more parts than the limit"},
    CodeInfo{Code::kModelBadName, "model/bad-name",
             "a composed name has characters that names cannot have"},
    CodeInfo{Code::kModelDuplicateName, "model/duplicate-name",
             "two elements of a variant have the same name"},
    CodeInfo{Code::kModelNoParts, "model/no-parts", "a variant has no parts"},
    CodeInfo{Code::kModelNoMass, "model/no-mass", "a variant that can move has no mass"},
    CodeInfo{Code::kModelBadPolygon, "model/bad-polygon",
             "a prism's polygon is not convex or has no area"},
    CodeInfo{Code::kModelBadMesh, "model/bad-mesh",
             "a mesh file cannot be used as a part of an object"},
    CodeInfo{Code::kModelFileNotFound, "model/file-not-found",
             "a mesh or texture file cannot be read"},
    CodeInfo{Code::kModelBadTexture, "model/bad-texture", "a texture cannot be used"},
    CodeInfo{Code::kModelUnknownReference, "model/unknown-reference",
             "an element names another one that the object does not have"},
    CodeInfo{Code::kAttachBadInclude, "attach/bad-include",
             "an attached file includes one that is missing, broken or open already"},
    CodeInfo{Code::kAttachNoBody, "attach/no-body",
             "an attached file does not have the body asked for"},
    CodeInfo{Code::kAttachNotCarried, "attach/not-carried",
             "something of an attached file or spec cannot be carried over"},
    CodeInfo{Code::kTargetDropped, "target/dropped",
             "the target has no place for something the object has"},
    CodeInfo{Code::kMujocoNotMjcf, "mujoco/not-mjcf", "a file is not MJCF"},
    CodeInfo{Code::kMujocoError, "mujoco/error", "MuJoCo refused the model"},
    CodeInfo{Code::kMujocoWarning, "mujoco/warning", "MuJoCo loaded the model with a warning"},
    CodeInfo{Code::kMujocoMismatch, "mujoco/mismatch",
             "MuJoCo's compiled model differs from the object"},
    CodeInfo{Code::kMujocoSelfCollision, "mujoco/self-collision",
             "two bodies of the object touch at the joints' zero"},
    CodeInfo{Code::kOutputExists, "output/exists",
             "a file of that name exists and was not made by this batch"},
    CodeInfo{Code::kOutputCannotWrite, "output/cannot-write", "a file cannot be written"},
    CodeInfo{Code::kOutputBadName, "output/bad-name", "an output's name cannot be used"},
    CodeInfo{Code::kOutputBadManifest, "output/bad-manifest",
             "a manifest or an object's header cannot be understood"},
    CodeInfo{Code::kOutputDiffers, "output/differs", "an object made again is not the same"},
    CodeInfo{Code::kBatchWorkerDied, "batch/worker-died", "the process that made a variant died"},
    CodeInfo{Code::kBatchTooSlow, "batch/too-slow", "a variant took longer than the time limit"},
    CodeInfo{Code::kBatchDiffers, "batch/differs", "what is there belongs to another batch"},
    CodeInfo{Code::kBatchMissing, "batch/missing", "a part of a batch is missing"},
    CodeInfo{Code::kBatchUneven, "batch/uneven", "draws cannot be spread evenly over the batch"},
    CodeInfo{Code::kPictureNoRenderer, "picture/no-renderer",
             "there is nothing to draw pictures with"},
    CodeInfo{Code::kPictureNothingVisible, "picture/nothing-visible",
             "an object has nothing that the picture could show"},
    CodeInfo{Code::kPictureUnknownJoint, "picture/unknown-joint",
             "a joint that is to be moved does not exist"},
    CodeInfo{Code::kPictureBadJointValue, "picture/bad-joint-value",
             "a joint cannot stand where it is told to"},
    CodeInfo{Code::kPictureNoViewer, "picture/no-viewer", "MuJoCo's viewer is not installed"},
    CodeInfo{Code::kPictureNoDisplay, "picture/no-display", "there is no display for a window"},
    CodeInfo{Code::kReportNoPicture, "report/no-picture", "variants of a report have no picture"},
};

constexpr bool InOrder() {
  for (std::size_t i = 0; i < kCodes.size(); ++i) {
    if (static_cast<std::size_t>(kCodes[i].code) != i) return false;
  }
  return kCodes.size() == static_cast<std::size_t>(Code::kReportNoPicture) + 1;
}
static_assert(InOrder(), "the table must list every code in the order of the enumeration");

}  // namespace

std::span<const CodeInfo> AllCodes() { return kCodes; }

std::string_view CodeName(Code code) { return kCodes[static_cast<std::size_t>(code)].name; }

bool IsInputOutput(Code code) {
  return code == Code::kYamlCannotRead || code == Code::kOutputExists ||
         code == Code::kOutputCannotWrite;
}

}  // namespace mjforge::diag
