// The table of the kinds of values that fields take (FieldKind).

#include "mjforge/spec/field_kinds.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>

namespace mjforge::spec {
namespace {

// Rows of the table in the order of FieldKind, one per kind.
constexpr std::array kFieldKinds = {
    FieldKindInfo{FieldKind::kNumber, "number", "", "a number"},
    FieldKindInfo{FieldKind::kInteger, "whole number", "", "a number"},
    FieldKindInfo{FieldKind::kBoolean, "true or false", R"("@is boolean")", "true or false"},
    FieldKindInfo{FieldKind::kWord, "", "", "text"},
    FieldKindInfo{FieldKind::kText, "text", R"("@is text")", "text"},
    FieldKindInfo{FieldKind::kNumbers, "", "", "numbers"},
    FieldKindInfo{FieldKind::kPoints, "list of points"},
    FieldKindInfo{FieldKind::kOutlines, "list of outlines",
                  R"("type": "array", "items": )"
                  R"({"anyOf": [{"@is points"}, {"@is outline_loop"}, {"@is axis_outlines"}]})"},
    FieldKindInfo{FieldKind::kPosition, "number or 4 numbers", R"("@is position")"},
    FieldKindInfo{FieldKind::kPlainText, "fixed text"},
    FieldKindInfo{FieldKind::kFormat, "1", R"("const": 1)"},
    FieldKindInfo{FieldKind::kParameters, "name: parameter", R"("@map parameter")"},
    FieldKindInfo{
        FieldKind::kFunctions, "name(arguments): expression",
        R"("type": "object", "patternProperties": {"^[A-Za-z][A-Za-z0-9_]* *\\(.*\\)$": )"
        R"({"anyOf": [{"type": "number"}, {"@expression"}]}}, "additionalProperties": false)"},
    FieldKindInfo{FieldKind::kConditions, "list of conditions",
                  R"("anyOf": [{"@is condition"}, {"@list condition"}])"},
    FieldKindInfo{FieldKind::kCondition, "condition", R"("@is condition")"},
    FieldKindInfo{FieldKind::kLoops, "variable: count or list",
                  R"("type": "object", "additionalProperties": )"
                  R"({"anyOf": [{"@is number"}, {"@is list"}]})"},
    FieldKindInfo{FieldKind::kLocals, "name: value", R"("@map value")"},
    FieldKindInfo{FieldKind::kMaterials, "name: material", R"("@map material")"},
    FieldKindInfo{FieldKind::kDefaults, "defaults", R"("@is defaults")"},
    FieldKindInfo{
        FieldKind::kImports, "list of files",
        R"("anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}}])"},
    FieldKindInfo{FieldKind::kParts, "list of parts", R"("@list part")"},
    FieldKindInfo{FieldKind::kSites, "list of sites", R"("@list site")"},
    FieldKindInfo{FieldKind::kRegions, "`auto`, or list of regions",
                  R"("anyOf": [{"const": "auto"}, {"@list region"}])"},
    FieldKindInfo{FieldKind::kCameras, "list of cameras", R"("@list camera")"},
    FieldKindInfo{FieldKind::kLights, "list of lights", R"("@list light")"},
    FieldKindInfo{FieldKind::kJoints, "list of joints"},
    FieldKindInfo{FieldKind::kScrew, "thread", R"("@is screw")"},
    FieldKindInfo{FieldKind::kCouple, "coupling", R"("@is couple")"},
    FieldKindInfo{FieldKind::kChain, "links", R"("@is chain")"},
    FieldKindInfo{FieldKind::kPose, "frame", R"("@is frame")"},
    FieldKindInfo{FieldKind::kTexture, "texture", R"("@is texture")"},
    FieldKindInfo{
        FieldKind::kOverrides, "name: value",
        R"("type": "object", "patternProperties": {"^[A-Za-z][A-Za-z0-9_]*(\\.[A-Za-z][A-Za-z0-9_]*)?$": )"
        R"({"@is value"}}, "additionalProperties": false)"},
    FieldKindInfo{FieldKind::kSubstitutes, "name: material's name", R"("@map text")"},
    FieldKindInfo{FieldKind::kFields, "keys"},
    FieldKindInfo{FieldKind::kBodies, "list of bodies", R"("@list body")"},
    FieldKindInfo{FieldKind::kPlace, "place", R"("@is place")"},
    FieldKindInfo{FieldKind::kBeside, "side of a body", R"("@is beside")"},
    FieldKindInfo{FieldKind::kPile, "order and time", R"("@is pile")"},
    FieldKindInfo{FieldKind::kFacing, "name, or 2 or 3 numbers",
                  R"("anyOf": [{"@is text"}, {"@list number", "minItems": 2, "maxItems": 3}, )"
                  R"({"@is vector_draw"}])"},
    FieldKindInfo{FieldKind::kPositions, "joint: position", R"("@is positions")"},
    FieldKindInfo{FieldKind::kStarts, "joint: position, or list of starts",
                  R"("anyOf": [{"@is positions"}, {"@list start"}])"},
    FieldKindInfo{FieldKind::kContact, "contact", R"("@is contacts")"},
    FieldKindInfo{FieldKind::kExcludes, "list of pairs",
                  R"("type": "array", "items": {"anyOf": [{"@pair"}, {"@is exclude"}]})"},
    FieldKindInfo{FieldKind::kBodyPair, "two names", R"("@pair")"},
    FieldKindInfo{
        FieldKind::kExpectations, "list of conditions and expectations",
        R"("type": "array", "items": {"anyOf": [{"@is condition"}, {"@is expectation"}]})"},
    FieldKindInfo{FieldKind::kSections, "section: elements"},
    FieldKindInfo{FieldKind::kChecks, "checks", R"("@is checks")"},
    FieldKindInfo{FieldKind::kView, "view", R"("@is view")"},
    FieldKindInfo{FieldKind::kHolding, "balls", R"("@is holds")"},
    FieldKindInfo{FieldKind::kSettling, "limits", R"("@is settled")"},
    FieldKindInfo{FieldKind::kJointChecks, "list of drives", R"("@list drive")"},
    FieldKindInfo{FieldKind::kFittings, "list of fits", R"("@list fit")"},
    FieldKindInfo{FieldKind::kGrasping, "jaws", R"("@is grasps")"},
    FieldKindInfo{FieldKind::kPartChecks, "list of limits", R"("@list limit")"},
    FieldKindInfo{FieldKind::kNames, "name or list of names",
                  R"("anyOf": [{"type": "string"}, {"@list text", "minItems": 1}])"},
    FieldKindInfo{FieldKind::kSilence, "code: reason"},
    FieldKindInfo{FieldKind::kAnything, "any value"},
};

// The table must have a row for each kind, in order, because InfoOf() uses a kind as an index of
// the table.
static_assert(kFieldKinds.size() == static_cast<std::size_t>(FieldKind::kAnything) + 1 &&
              std::ranges::adjacent_find(kFieldKinds, std::greater_equal(), &FieldKindInfo::kind) ==
                  kFieldKinds.end());

}  // namespace

const FieldKindInfo& InfoOf(FieldKind kind) { return kFieldKinds[static_cast<std::size_t>(kind)]; }

}  // namespace mjforge::spec
