#include "mjforge/manifest/physics_json.h"

#include <cmath>

namespace mjforge::manifest {
namespace {

using physics::Result;

// One member: what it is called and where it is, of one of three kinds.
template <typename Of>
struct Member {
  const char* key;
  double Of::*number = nullptr;
  int Of::*whole = nullptr;
  bool Of::*flag = nullptr;
};

constexpr Member<Result> kMembers[] = {
    {.key = "dropped", .flag = &Result::dropped},
    {.key = "at_rest", .flag = &Result::at_rest},
    {.key = "time", .number = &Result::time},
    {.key = "drift", .number = &Result::drift},
    {.key = "tilt", .number = &Result::tilt},
    {.key = "speed", .number = &Result::speed},
    {.key = "penetration", .number = &Result::penetration},
    {.key = "sink", .number = &Result::sink},
    {.key = "energy_gain", .number = &Result::energy_gain},
    {.key = "ncon", .whole = &Result::ncon},
    {.key = "nefc", .whole = &Result::nefc},
    {.key = "overlap", .number = &Result::overlap},
};

constexpr Member<Result::Joint> kJointMembers[] = {
    {.key = "overshoot", .number = &Result::Joint::overshoot},
    {.key = "reach", .number = &Result::Joint::reach},
    {.key = "penetration", .number = &Result::Joint::penetration},
    {.key = "return_error", .number = &Result::Joint::return_error},
};

template <typename Of, std::size_t n>
void Write(JsonText& json, const Of& of, const Member<Of> (&members)[n]) {
  for (const Member<Of>& member : members) {
    json.Key(member.key);
    if (member.number != nullptr) {
      json.Number(of.*member.number);
    } else if (member.whole != nullptr) {
      json.Whole(static_cast<std::uint64_t>(of.*member.whole));
    } else {
      json.Bool(of.*member.flag);
    }
  }
}

// What a number can become that JSON has no word for: it was not finite.
bool ReadNumber(const rapidjson::Value& value, double& number) {
  if (value.IsNull()) number = std::nan("");
  if (value.IsNumber()) number = value.GetDouble();
  return value.IsNumber() || value.IsNull();
}

template <typename Of, std::size_t n>
bool Read(const rapidjson::Value& object, Of& of, const Member<Of> (&members)[n]) {
  for (const Member<Of>& member : members) {
    const auto found = object.FindMember(member.key);
    if (found == object.MemberEnd()) return false;
    const rapidjson::Value& value = found->value;
    if (member.number != nullptr) {
      if (!ReadNumber(value, of.*member.number)) return false;
    } else if (member.whole != nullptr) {
      if (!value.IsInt()) return false;
      of.*member.whole = value.GetInt();
    } else {
      if (!value.IsBool()) return false;
      of.*member.flag = value.GetBool();
    }
  }
  return true;
}

}  // namespace

void WritePhysics(JsonText& json, const Result& result) {
  json.StartObject();
  Write(json, result, kMembers);
  json.Key("joints");
  json.StartArray();
  for (const Result::Joint& joint : result.joints) {
    json.StartObject();
    json.Key("name");
    json.String(joint.name);
    Write(json, joint, kJointMembers);
    json.EndObject();
  }
  json.EndArray();
  json.EndObject();
}

std::string PhysicsJson(const Result& result) {
  std::string text;
  JsonText json(text);
  WritePhysics(json, result);
  return text;
}

std::optional<Result> ReadPhysics(const rapidjson::Value& value) {
  Result result;
  if (!value.IsObject() || !Read(value, result, kMembers)) return std::nullopt;
  const auto joints = value.FindMember("joints");
  if (joints == value.MemberEnd() || !joints->value.IsArray()) return std::nullopt;
  for (const rapidjson::Value& item : joints->value.GetArray()) {
    Result::Joint& joint = result.joints.emplace_back();
    if (!item.IsObject() || !Read(item, joint, kJointMembers)) return std::nullopt;
    const auto name = item.FindMember("name");
    if (name == item.MemberEnd() || !name->value.IsString()) return std::nullopt;
    joint.name = name->value.GetString();
  }
  return result;
}

}  // namespace mjforge::manifest
