// Conversion of the values of records and seals to JSON (Put) and back (Get).

#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <type_traits>
#include <variant>

#include <rapidjson/document.h>

#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {

using diag::Json;
/// Result of reading a value: empty on success, otherwise the kind of value that the member must
/// have, such as "a text".
using ExpectedKind = std::string_view;

template <typename T>
using Members = std::vector<std::pair<std::string, T>>;

template <typename T>
void Put(Json& json, const T& value) {
  if constexpr (std::is_enum_v<T>) {
    json.Value(NameOf(value));
  } else {
    json.Value(value);
  }
}

template <typename T>
void Put(Json& json, const Members<T>& members) {
  json.Object([&] { json.Members(members); });
}

// Rows and columns of the elements of an inertia matrix, in the order of MJCF's fullinertia.
inline constexpr std::array<std::pair<int, int>, 6> kInertia = {
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

inline void Put(Json& json, const Eigen::Matrix3d& inertia) {
  json.List(kInertia, [&](const auto& at) { json.Value(inertia(at.first, at.second)); });
}

inline void Put(Json& json, const model::Box3& box) {
  json.Object([&] {
    json.Member("min", box.min);
    json.Member("max", box.max);
  });
}

inline ExpectedKind Get(const rapidjson::Value& value, std::string& text) {
  if (!value.IsString()) return "a text";
  text.assign(value.GetString(), value.GetStringLength());
  return {};
}

template <typename T>
void Put(Json& json, const std::optional<T>& value) {
  json.Value(*value);
}

template <std::integral T>
ExpectedKind Get(const rapidjson::Value& value, T& number) {
  if (!value.Is<T>()) return std::is_same_v<T, bool> ? "true or false" : "a whole number";
  number = value.Get<T>();
  return {};
}

template <typename T>
ExpectedKind Get(const rapidjson::Value& value, std::optional<T>& out) {
  return Get(value, out.emplace());
}

// Reads a number. Null is read as NaN, because numbers that are not finite are written as null.
inline ExpectedKind Get(const rapidjson::Value& value, double& number) {
  if (!value.IsNumber() && !value.IsNull()) return "a number";
  number = value.IsNull() ? std::nan("") : value.GetDouble();
  return {};
}

template <typename Enum>
requires std::is_enum_v<Enum> ExpectedKind Get(const rapidjson::Value& value, Enum& word) {
  const std::optional<Enum> found = value.IsString() ? Find<Enum>(value.GetString()) : std::nullopt;
  if (!found) return "a word that is known here";
  word = *found;
  return {};
}

template <typename T>
ExpectedKind Get(const rapidjson::Value& value, std::vector<T>& list) {
  if (!value.IsArray()) return "a list";
  for (const rapidjson::Value& item : value.GetArray()) {
    T element = {};
    if (const ExpectedKind kind = Get(item, element); !kind.empty()) return "a list of its kind";
    list.push_back(std::move(element));
  }
  return {};
}

inline ExpectedKind Get(const rapidjson::Value& value, sample::ParameterValue& parameter) {
  if (value.IsString()) return Get(value, parameter.emplace<std::string>());
  if (value.IsBool()) return Get(value, parameter.emplace<bool>());
  if (value.IsArray() && !value.Empty() && value[0].IsString())
    return Get(value, parameter.emplace<std::vector<std::string>>());
  if (value.IsArray() && !value.Empty() && value[0].IsBool())
    return Get(value, parameter.emplace<std::vector<bool>>());
  if (value.IsArray()) return Get(value, parameter.emplace<std::vector<double>>());
  return Get(value, parameter.emplace<double>());
}

template <typename T>
ExpectedKind Get(const rapidjson::Value& value, Members<T>& members) {
  if (!value.IsObject()) return "an object";
  for (const auto& [name, item] : value.GetObject()) {
    auto& member = members.emplace_back(name.GetString(), T());
    if (const ExpectedKind kind = Get(item, member.second); !kind.empty())
      return "an object of its kind";
  }
  return {};
}

inline ExpectedKind Get(const rapidjson::Value& value, Eigen::Vector3d& point) {
  std::vector<double> numbers;
  if (!Get(value, numbers).empty() || numbers.size() != 3) return "a point";
  point = Eigen::Map<const Eigen::Vector3d>(numbers.data());
  return {};
}

inline ExpectedKind Get(const rapidjson::Value& value, Eigen::Matrix3d& inertia) {
  std::vector<double> numbers;
  if (!Get(value, numbers).empty() || numbers.size() != kInertia.size()) return "an inertia";
  for (std::size_t i = 0; i < kInertia.size(); ++i) {
    const auto& [row, column] = kInertia[i];
    inertia(row, column) = inertia(column, row) = numbers[i];
  }
  return {};
}

/// Reads the member `key` of `object`. Returns false if the member is missing or has another kind.
template <typename T>
bool GetMember(const rapidjson::Value& object, const char* key, T& member) {
  return object.IsObject() && object.HasMember(key) && Get(object[key], member).empty();
}

inline ExpectedKind Get(const rapidjson::Value& value, model::Box3& box) {
  return GetMember(value, "min", box.min) && GetMember(value, "max", box.max) ? "" : "a box";
}

/// Key of a JSON member, and the C++ member that stores the value.
template <typename Of>
struct JsonMember {
  const char* key;
  std::variant<double Of::*, int Of::*, bool Of::*, std::string Of::*, Eigen::Vector3d Of::*,
               std::vector<double> Of::*, std::uint64_t Of::*>
      at;
};

template <typename Of, std::size_t n>
void PutAll(Json& json, const Of& of, const JsonMember<Of> (&members)[n]) {
  for (const JsonMember<Of>& member : members)
    std::visit([&](auto at) { json.Member(member.key, of.*at); }, member.at);
}

/// Reads all members that a table lists from a JSON object. Returns false if a member is missing or
/// has another kind.
template <typename Of, std::size_t n>
bool GetAll(const rapidjson::Value& object, Of& of, const JsonMember<Of> (&members)[n]) {
  return std::ranges::all_of(members, [&](const JsonMember<Of>& member) {
    return std::visit([&](auto at) { return GetMember(object, member.key, of.*at); }, member.at);
  });
}

/// Returns the text of `properties` in a JSON Schema for the members that a table lists.
template <typename Of, std::size_t n>
std::string SchemaOf(const JsonMember<Of> (&members)[n]) {
  // JSON types, in the order of the alternatives of JsonMember::at.
  constexpr std::array kTypes = {R"(["number", "null"])", R"("integer")", R"("boolean")",
                                 R"("string")",           R"("array")",   R"("array")",
                                 R"("integer")"};
  return diag::Joined(members, ", ", [&](const JsonMember<Of>& member) {
    return fmt::format(R"("{}": {{"type": {}}})", member.key, kTypes[member.at.index()]);
  });
}

}  // namespace mjforge::manifest
