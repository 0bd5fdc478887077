#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <boost/container/small_vector.hpp>

#include "mjforge/spec/spec.h"

namespace mjforge::model {

/// The fields of one entry by key, and the defaults for those it leaves out. A default is ignored
/// if the entry says the same thing in another way (mass and density; pos, orientations and
/// fromto).
class FieldSet {
 public:
  using Attributes = boost::container::small_vector<const spec::Field*, 8>;

  FieldSet(std::span<const spec::Field> own, std::span<const spec::Field> defaults);

  /// The entry's own field.
  const spec::Field* Own(spec::Key id) const { return At(own_fields_, own_[Position(id)]); }
  /// The default, if it is not ignored.
  const spec::Field* Default(spec::Key id) const {
    return At(default_fields_, defaults_[Position(id)]);
  }
  const spec::Field* operator[](spec::Key id) const { return Own(id) ? Own(id) : Default(id); }

  /// Fields that are written unchanged.
  const Attributes& own_attributes() const { return own_attributes_; }
  const Attributes& default_attributes() const { return default_attributes_; }

 private:
  static std::size_t Position(spec::Key id) { return static_cast<std::size_t>(id); }
  static constexpr std::size_t kKeys = static_cast<std::size_t>(spec::Key::kCount);
  // One more than the position among the fields, 0 for none: a set is made for
  // every entry of every variant, so it is small.
  using ById = std::array<std::uint16_t, kKeys>;

  static const spec::Field* At(std::span<const spec::Field> fields, std::uint16_t place) {
    return place == 0 ? nullptr : &fields[place - 1U];
  }
  static void Sort(std::span<const spec::Field> fields, ById& by_id, Attributes& attributes);

  std::span<const spec::Field> own_fields_;
  std::span<const spec::Field> default_fields_;
  ById own_{};
  ById defaults_{};
  Attributes own_attributes_;
  Attributes default_attributes_;
};

}  // namespace mjforge::model
