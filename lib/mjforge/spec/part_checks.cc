// Checks of the fields of a part against its type.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/context.h"
#include "mjforge/spec/shapes.h"

namespace mjforge::spec {
namespace {

using diag::Code;

void CheckSizes(const Entry& part, const ShapeInfo& shape, Context& context) {
  const Field* size = part.Find(Key::kSize);
  const Field* fromto = part.Find(Key::kFromTo);
  if (fromto != nullptr && shape.sizes_fromto == 0) {
    context.findings.Add(Code::kSpecConflict, fromto->mark,
                         fmt::format("'fromto' has no meaning for a {}", shape.type));
    return;
  }
  const Field* up = part.Find(Key::kUp);
  if (up != nullptr && fromto == nullptr) {
    context.findings.Add(Code::kSpecConflict, up->mark, "'up' needs 'fromto' in the same entry",
                         "give the orientation by `xyaxes`, `euler` or `quat`");
  }
  if (size == nullptr) return;
  if (shape.sizes == 0) {
    if (!size->is_default) {
      context.findings.Add(Code::kSpecConflict, size->mark,
                           fmt::format("'size' has no meaning for a {}", shape.type));
    }
    return;
  }
  // Skips draws of vectors, because their options may differ in length. The length of the drawn
  // option is checked for each variant.
  const bool exact = !std::holds_alternative<Draw>(size->value.form) || size->value.components == 1;
  const int wanted = fromto != nullptr ? shape.sizes_fromto : shape.sizes;
  if (exact && size->value.components != 0 && size->value.components != wanted) {
    context.findings.Add(
        Code::kSpecWrongLength, size->value.mark,
        fmt::format("a {}{} has {}, got {}", shape.type, fromto != nullptr ? " with 'fromto'" : "",
                    diag::Counted(static_cast<std::uint64_t>(wanted), "size"),
                    size->value.components));
  }
}

}  // namespace

void CheckPart(const Entry& part, Context& context) {
  const Field* type = part.Find(Key::kType);
  if (type == nullptr) {
    context.findings.Add(Code::kSpecMissingKey, part.mark, "part without a 'type'");
    return;
  }
  const auto word = LiteralText(type->value);
  if (!word) return;
  const ShapeInfo* shape = FindShape(*word);
  if (shape == nullptr) return;  // unknown type, already reported
  for (const Key id : shape->required) {
    if (part.Find(id) != nullptr) continue;
    context.findings.Add(Code::kSpecMissingKey, part.mark,
                         fmt::format("{} without '{}'", shape->type, kPartElement.Find(id)->key));
  }
  const bool is_round = part.Find(Key::kRound) != nullptr;
  for (const Field& field : part.fields) {
    const Key id = field.info->id;
    const bool has_own_words = id == Key::kSize || id == Key::kFromTo || id == Key::kUp;
    if (field.is_default || has_own_words || !AnyShapeTakes(id)) continue;
    const bool needs_round =
        std::ranges::find(shape->optional_if_round, id) != shape->optional_if_round.end();
    if (shape->Takes(id) && (!needs_round || is_round)) continue;
    context.findings.Add(Code::kSpecConflict, field.mark,
                         fmt::format("'{}' has no meaning for a {}{}", field.info->key, shape->type,
                                     needs_round ? " without 'round'" : ""));
  }
  CheckSizes(part, *shape, context);
}

}  // namespace mjforge::spec
