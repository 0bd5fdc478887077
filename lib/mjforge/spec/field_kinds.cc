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
    FieldKindInfo{FieldKind::kStructure, ""},
    FieldKindInfo{FieldKind::kJoints, "list of joints"},
    FieldKindInfo{FieldKind::kFields, "keys"},
    FieldKindInfo{FieldKind::kSections, "section: elements"},
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
