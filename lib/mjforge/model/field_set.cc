#include "mjforge/model/field_set.h"

#include <algorithm>

namespace mjforge::model {
namespace {

using spec::Key;

constexpr std::array kOrientations = {Key::kQuat, Key::kEuler, Key::kAxisAngle, Key::kXyAxes,
                                      Key::kZAxis};

}  // namespace

FieldSet::FieldSet(std::span<const spec::Field> own, std::span<const spec::Field> defaults)
    : own_fields_(own), default_fields_(defaults) {
  Sort(own, own_, own_attributes_);
  if (defaults.empty()) return;
  Sort(defaults, defaults_, default_attributes_);
  const auto drop = [this](Key id) { defaults_[Position(id)] = 0; };
  if (Own(Key::kMass) || Own(Key::kDensity)) {
    drop(Key::kMass);
    drop(Key::kDensity);
  }
  const bool turned = std::ranges::any_of(kOrientations, [this](Key id) { return Own(id); });
  if (turned || Own(Key::kFromTo)) std::ranges::for_each(kOrientations, drop);
  if (Own(Key::kFromTo)) drop(Key::kPos);
  if (turned || Own(Key::kPos)) drop(Key::kFromTo);
}

void FieldSet::Sort(std::span<const spec::Field> fields, ById& by_id, Attributes& attributes) {
  for (const spec::Field& field : fields) {
    const Key id = field.info->id;
    by_id[Position(id)] = static_cast<std::uint16_t>(&field - fields.data() + 1);
    if (id == Key::kAttribute || id == Key::kRgba || id == Key::kGroup) {
      attributes.push_back(&field);
    }
  }
}

}  // namespace mjforge::model
