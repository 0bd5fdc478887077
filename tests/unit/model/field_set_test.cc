#include "mjforge/model/field_set.h"

#include <catch2/catch.hpp>

namespace mjforge::model {
namespace {

using spec::Key;

spec::Field FieldOf(std::string_view key) {
  spec::Field field;
  field.info = spec::PartElement().Find(key);
  REQUIRE(field.info != nullptr);
  return field;
}

std::vector<spec::Field> FieldsOf(std::initializer_list<std::string_view> keys) {
  std::vector<spec::Field> fields;
  for (const std::string_view key : keys) fields.push_back(FieldOf(key));
  return fields;
}

TEST_CASE("an entry's own field wins over the default") {
  const std::vector<spec::Field> own = FieldsOf({"size"});
  const std::vector<spec::Field> defaults = FieldsOf({"size", "type"});
  const FieldSet fields(own, defaults);
  CHECK(fields[Key::kSize] == &own[0]);
  CHECK(fields[Key::kType] == &defaults[1]);
  CHECK(fields[Key::kRole] == nullptr);
}

TEST_CASE("a default density does not count beside an own mass") {
  const std::vector<spec::Field> own = FieldsOf({"mass"});
  const std::vector<spec::Field> defaults = FieldsOf({"density"});
  CHECK(FieldSet(own, defaults)[Key::kDensity] == nullptr);
}

TEST_CASE("a default orientation does not count beside an own one") {
  const std::vector<spec::Field> own = FieldsOf({"euler"});
  const std::vector<spec::Field> defaults = FieldsOf({"quat", "pos"});
  const FieldSet fields(own, defaults);
  CHECK(fields[Key::kQuat] == nullptr);
  CHECK(fields[Key::kPos] == &defaults[1]);
}

TEST_CASE("a default pose does not count beside an own fromto, nor the reverse") {
  const std::vector<spec::Field> fromto = FieldsOf({"fromto"});
  const std::vector<spec::Field> pose = FieldsOf({"pos", "zaxis"});
  CHECK(FieldSet(fromto, pose)[Key::kPos] == nullptr);
  CHECK(FieldSet(fromto, pose)[Key::kZAxis] == nullptr);
  CHECK(FieldSet(pose, fromto)[Key::kFromTo] == nullptr);
}

TEST_CASE("a set has room for every key") {
  const std::vector<spec::Field> defaults = FieldsOf({"type"});
  for (const spec::ElementInfo* element : spec::AllElements()) {
    for (const spec::FieldInfo& info : element->fields) {
      if (info.id == Key::kAttribute) continue;
      INFO(element->name << "." << info.key);
      std::vector<spec::Field> own(1);
      own[0].info = &info;
      const FieldSet fields(own, defaults);
      CHECK(fields.Own(info.id) == own.data());
      CHECK_FALSE(fields.Default(Key::kAttribute));
    }
  }
}

TEST_CASE("attributes are the fields that are written as they are") {
  const std::vector<spec::Field> own = FieldsOf({"size", "friction", "rgba"});
  const std::vector<spec::Field> defaults = FieldsOf({"rgba", "margin"});
  const FieldSet fields(own, defaults);
  CHECK(fields.own_attributes().size() == 2);
  CHECK(fields.default_attributes().size() == 2);
}

}  // namespace
}  // namespace mjforge::model
