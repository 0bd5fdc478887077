// The table of the fields of a physics result.

#include "mjforge/manifest/result_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <type_traits>

namespace mjforge::manifest {
namespace {

using physics::Result;
using Value = rapidjson::Value;

constexpr JsonMember<Result> kResult[] = {{"dropped", &Result::dropped},
                                          {"at_rest", &Result::at_rest},
                                          {"time", &Result::time},
                                          {"drift", &Result::drift},
                                          {"tilt", &Result::tilt},
                                          {"speed", &Result::speed},
                                          {"penetration", &Result::penetration},
                                          {"sink", &Result::sink},
                                          {"energy_gain", &Result::energy_gain},
                                          {"ncon", &Result::ncon},
                                          {"nefc", &Result::nefc},
                                          {"overlap", &Result::overlap}};

constexpr JsonMember<Result::Joint> kJoint[] = {{"name", &Result::Joint::name},
                                                {"overshoot", &Result::Joint::overshoot},
                                                {"reach", &Result::Joint::reach},
                                                {"penetration", &Result::Joint::penetration},
                                                {"return_error", &Result::Joint::return_error}};

constexpr JsonMember<Result::Equality> kEquality[] = {{"name", &Result::Equality::name},
                                                      {"error", &Result::Equality::error},
                                                      {"share", &Result::Equality::share}};

constexpr JsonMember<Result::Stability> kStability[] = {{"angle", &Result::Stability::angle},
                                                        {"energy", &Result::Stability::energy}};

constexpr JsonMember<Result::Holding> kHolding[] = {{"balls", &Result::Holding::balls},
                                                    {"held", &Result::Holding::held},
                                                    {"emptied", &Result::Holding::emptied}};

constexpr JsonMember<Result::Settling> kSettling[] = {{"bodies", &Result::Settling::bodies},
                                                      {"moved", &Result::Settling::moved},
                                                      {"distance", &Result::Settling::distance},
                                                      {"angle", &Result::Settling::angle}};

constexpr JsonMember<Result::Fitting> kFitting[] = {{"tried", &Result::Fitting::tried},
                                                    {"fit", &Result::Fitting::fit}};

constexpr JsonMember<Result::Grasp> kGrasp[] = {
    {"site", &Result::Grasp::site},   {"body", &Result::Grasp::body},
    {"pos", &Result::Grasp::pos},     {"quat", &Result::Grasp::quat},
    {"width", &Result::Grasp::width}, {"held", &Result::Grasp::held}};

constexpr JsonMember<Result::SimReady> kSimReady[] = {
    {"ground_drop", &Result::SimReady::ground_drop},
    {"slope_drop", &Result::SimReady::slope_drop},
    {"full_range_sweep", &Result::SimReady::full_range_sweep},
    {"self_collision", &Result::SimReady::self_collision}};

// Calls `use` for each list and each object within a physics result, in the order in which they are
// written. Passes the key, the value and the table of the value's members.
template <typename AnyResult, typename Use>
void ForEachPart(AnyResult& result, const Use& use) {
  use("joints", result.joints, kJoint);
  use("equalities", result.equalities, kEquality);
  use("stability", result.stability, kStability);
  use("holds", result.holds, kHolding);
  use("settled", result.settled, kSettling);
  use("fits", result.fits, kFitting);
  use("grasps", result.grasps, kGrasp);
  use("simready", result.simready, kSimReady);
}

template <typename Part>
constexpr bool kIsList = requires(const Part& part) {
  part.empty();
};

}  // namespace

std::string ResultSchema() {
  std::string text = SchemaOf(kResult);
  Result result;
  ForEachPart(result, [&](const char* key, const auto& part, const auto& members) {
    const std::string object =
        fmt::format(R"("type": "object", "properties": {{{}}})", SchemaOf(members));
    text += kIsList<std::remove_cvref_t<decltype(part)>>
                ? fmt::format(R"(, "{}": {{"type": "array", "items": {{{}}}}})", key, object)
                : fmt::format(R"(, "{}": {{{}}})", key, object);
  });
  return text;
}

void PutResult(Json& json, const Result& result) {
  json.Object([&] {
    PutAll(json, result, kResult);
    ForEachPart(result, [&](const std::string_view key, const auto& part, const auto& members) {
      const auto put = [&](const auto& object) { PutAll(json, object, members); };
      if constexpr (kIsList<std::remove_cvref_t<decltype(part)>>) {
        if (!part.empty() || key == "joints") json.Each(key, part, put);
      } else if (part) {
        json.Object(key, [&] { put(*part); });
      }
    });
  });
}

ExpectedKind GetResult(const Value& value, Result& result) {
  bool is_good = GetAll(value, result, kResult) && value.HasMember("joints");
  ForEachPart(result, [&](const char* key, auto& part, const auto& members) {
    if (!is_good || !value.HasMember(key)) return;
    const Value& member = value[key];
    if constexpr (kIsList<std::remove_cvref_t<decltype(part)>>) {
      is_good = member.IsArray() && std::ranges::all_of(member.GetArray(), [&](const Value& item) {
                  return GetAll(item, part.emplace_back(), members);
                });
    } else {
      std::remove_cvref_t<decltype(*part)> read;
      is_good = GetAll(member, read, members);
      part = read;
    }
  });
  return is_good ? ExpectedKind() : "what was measured";
}

}  // namespace mjforge::manifest
