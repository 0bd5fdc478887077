#include "mjforge/spec/slots.h"

#include <array>
#include <cstddef>

namespace mjforge::spec {
namespace {

// In the order of Slot.
constexpr std::array kSlots = {
    SlotInfo{Slot::kNumber, "number", "", "a number"},
    SlotInfo{Slot::kInteger, "whole number", "", "a number"},
    SlotInfo{Slot::kBoolean, "true or false", R"("@is boolean")", "true or false"},
    SlotInfo{Slot::kWord, "", "", "text"},
    SlotInfo{Slot::kText, "text", R"("@is text")", "text"},
    SlotInfo{Slot::kNumbers, "", "", "numbers"},
    SlotInfo{Slot::kPoints, "list of points"},
    SlotInfo{Slot::kOutlines, "list of lists of points",
             R"("type": "array", "items": )"
             R"({"anyOf": [{"@is points"}, {"@is outline_loop"}]})"},
    SlotInfo{Slot::kPlainText, "fixed text"},
    SlotInfo{Slot::kFormat, "1", R"("const": 1)"},
    SlotInfo{Slot::kParameters, "name: parameter", R"("@map parameter")"},
    SlotInfo{Slot::kFunctions, "name(arguments): expression",
             R"("type": "object", "patternProperties": {"^[A-Za-z][A-Za-z0-9_]* *\\(.*\\)$": )"
             R"({"anyOf": [{"type": "number"}, {"@expression"}]}}, "additionalProperties": false)"},
    SlotInfo{Slot::kConditions, "list of conditions",
             R"("anyOf": [{"@is condition"}, {"@list condition"}])"},
    SlotInfo{Slot::kCondition, "condition", R"("@is condition")"},
    SlotInfo{Slot::kLoops, "variable: count or list",
             R"("type": "object", "additionalProperties": )"
             R"({"anyOf": [{"@is number"}, {"@is list"}]})"},
    SlotInfo{Slot::kLocals, "name: value", R"("@map value")"},
    SlotInfo{Slot::kMaterials, "name: material", R"("@map material")"},
    SlotInfo{Slot::kDefaults, "defaults", R"("@is defaults")"},
    SlotInfo{Slot::kImports, "list of files",
             R"("anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}])"},
    SlotInfo{Slot::kParts, "list of parts", R"("@list part")"},
    SlotInfo{Slot::kSites, "list of sites", R"("@list site")"},
    SlotInfo{Slot::kCameras, "list of cameras", R"("@list camera")"},
    SlotInfo{Slot::kLights, "list of lights", R"("@list light")"},
    SlotInfo{Slot::kJoints, "list of joints"},
    SlotInfo{Slot::kPose, "frame", R"("@is frame")"},
    SlotInfo{Slot::kTexture, "texture", R"("@is texture")"},
    SlotInfo{
        Slot::kOverrides, "name: value",
        R"("type": "object", "patternProperties": {"^[A-Za-z][A-Za-z0-9_]*(\\.[A-Za-z][A-Za-z0-9_]*)?$": )"
        R"({"@is value"}}, "additionalProperties": false)"},
    SlotInfo{Slot::kSubstitutes, "name: material's name", R"("@map text")"},
    SlotInfo{Slot::kFields, "keys"},
    SlotInfo{Slot::kBodies, "list of bodies", R"("@list body")"},
    SlotInfo{Slot::kPositions, "joint: position",
             R"("type": "object", "additionalProperties": {"anyOf": [{"@is number"}, )"
             R"({"@list number", "minItems": 4, "maxItems": 4}, {"@is vector_draw"}]})"},
    SlotInfo{Slot::kContact, "contact", R"("@is contacts")"},
    SlotInfo{Slot::kExcludes, "list of pairs",
             R"("type": "array", "items": {"anyOf": [{"@pair"}, {"@is exclude"}]})"},
    SlotInfo{Slot::kBodyPair, "two names", R"("@pair")"},
    SlotInfo{Slot::kExpectations, "list of conditions and expectations",
             R"("type": "array", "items": {"anyOf": [{"@is condition"}, {"@is expectation"}]})"},
    SlotInfo{Slot::kSections, "section: elements"},
    SlotInfo{Slot::kChecks, "checks", R"("@is checks")"},
    SlotInfo{Slot::kHolding, "balls", R"("@is holds")"},
    SlotInfo{Slot::kJointChecks, "list of drives", R"("@list drive")"},
    SlotInfo{Slot::kFittings, "list of fits", R"("@list fit")"},
    SlotInfo{Slot::kGrasping, "jaws", R"("@is grasps")"},
    SlotInfo{Slot::kPartChecks, "list of limits", R"("@list limit")"},
    SlotInfo{Slot::kNames, "name or list of names",
             R"("anyOf": [{"type": "string"}, {"@list text", "minItems": 1}])"},
    SlotInfo{Slot::kSilence, "code: reason"},
    SlotInfo{Slot::kAnything, "any value"},
};

constexpr bool InOrder() {
  for (std::size_t i = 0; i < kSlots.size(); ++i) {
    if (static_cast<std::size_t>(kSlots[i].slot) != i) return false;
  }
  return kSlots.back().slot == Slot::kAnything;
}
static_assert(InOrder());

}  // namespace

const SlotInfo& InfoOf(Slot slot) { return kSlots[static_cast<std::size_t>(slot)]; }

}  // namespace mjforge::spec
