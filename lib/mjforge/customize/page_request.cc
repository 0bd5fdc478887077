// Reads the JSON requests that the page of `mjforge customize` sends: types and ranges of the
// members, and conversion of settings to YAML.

#include "mjforge/customize/page_request.h"

#include <fmt/format.h>
#include <rapidjson/document.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mjforge/customize/settings_text.h"
#include "mjforge/expr/expr.h"
#include "mjforge/manifest/manifest.h"
#include "mjforge/output/output.h"

namespace mjforge::customize {
namespace {

using Json = rapidjson::Value;

constexpr std::size_t kMostSettings = 10'000;
constexpr double kMostZoom = 1000;

std::string_view TextOf(const Json& value) { return {value.GetString(), value.GetStringLength()}; }

const Json* Find(const Json& object, const char* key) {
  const auto found = object.FindMember(key);
  return found == object.MemberEnd() ? nullptr : &found->value;
}

// Reads members of one request, and keeps the reason of the first failure. Functions leave `out`
// unchanged if the member is missing.
class Reader {
 public:
  Reader(const Json& root, std::string& why_not) : root_(root), why_not_(why_not) {}

  void Text(const char* key, std::string& out) {
    if (const Json* value = Member(key, &Json::IsString, "a text")) out = TextOf(*value);
  }

  void Whole(const char* key, std::uint64_t& out) {
    const Json* value = Member(key, &Json::IsString, "a text of digits");
    if (value == nullptr) return;
    const std::optional<std::uint64_t> number = output::ReadIndex(TextOf(*value));
    if (!number) return Fail(key, "a whole number up to 2^64 - 1");
    out = *number;
  }

  void Flag(const char* key, bool& out) {
    if (const Json* value = Member(key, &Json::IsBool, "true or false")) out = value->GetBool();
  }

  template <typename Number>
  void Bounded(const char* key, double least, double most, Number& out) {
    const Json* value = Find(root_, key);
    if (value == nullptr) return;
    const double number = value->IsNumber() ? value->GetDouble() : NAN;
    if (!(number >= least && number <= most))
      return Fail(key, fmt::format("a number from {} to {}", least, most));
    out = static_cast<Number>(number);
  }

  /// Reads a word and converts it by `find`, which returns nullopt for invalid words. `wanted`
  /// describes the valid words in the error message.
  template <typename T>
  void Word(const char* key, std::optional<T> (*find)(std::string_view), std::string_view wanted,
            T& out) {
    std::string word;
    Text(key, word);
    if (word.empty()) return;
    const std::optional<T> found = find(word);
    if (!found) return Fail(key, wanted);
    out = *found;
  }

  void Settings(std::vector<spec::Setting>& out, std::vector<std::size_t>& values) {
    const Json* list = Member("settings", &Json::IsArray, "a list");
    if (list == nullptr) return;
    if (list->Size() > kMostSettings) return Fail("settings", "a list");
    for (const Json& item : list->GetArray()) {
      const Json* name = item.IsObject() ? Find(item, "name") : nullptr;
      const Json* value = item.IsObject() ? Find(item, "value") : nullptr;
      if (name == nullptr || !name->IsString() || value == nullptr)
        return Fail("settings", "a list of objects with `name` and `value`");
      std::string text;
      if (value->IsString()) {
        values.push_back(out.size());
        text = TextOf(*value);
      } else if (!Flow(*value, text)) {
        return Fail("settings", "a list of values");
      }
      out.push_back({std::string(TextOf(*name)), std::move(text), std::string(kSettingOrigin)});
    }
  }

  void Joints(std::vector<std::pair<std::string, double>>& out) {
    const Json* joints = Member("joints", &Json::IsObject, "an object");
    if (joints == nullptr) return;
    for (const auto& member : joints->GetObject()) {
      if (!member.value.IsNumber()) return Fail("joints", "an object of numbers");
      out.emplace_back(TextOf(member.name), member.value.GetDouble());
    }
  }

 private:
  // Returns a member of the request; null if the member is missing, or after a failure if its type
  // is wrong.
  const Json* Member(const char* key, bool (Json::*has_type)() const, std::string_view wanted) {
    const Json* value = Find(root_, key);
    if (value == nullptr || (value->*has_type)()) return value;
    Fail(key, wanted);
    return nullptr;
  }

  void Fail(const char* key, std::string_view wanted) {
    if (why_not_.empty()) why_not_ = fmt::format("'{}' is not {}", key, wanted);
  }

  // Appends a JSON value to `out` as YAML flow text. An object {"yaml": "..."} already contains the
  // YAML text. Returns false for values that no parameter can have.
  static bool Flow(const Json& value, std::string& out) {
    if (value.IsNumber()) {
      out += expr::ExactNumberText(value.GetDouble());
    } else if (value.IsBool()) {
      out += value.GetBool() ? "true" : "false";
    } else if (value.IsString()) {
      out += QuoteForYaml(TextOf(value));
    } else if (value.IsArray()) {
      out += '[';
      for (const Json& item : value.GetArray()) {
        if (item.IsArray()) return false;
        if (!out.ends_with('[')) out += ", ";
        std::string expression;
        if (!Flow(item, item.IsObject() ? expression : out)) return false;
        // Quotes the text of an object, an expression, because an unquoted comma would end the item
        // of the YAML flow sequence.
        if (item.IsObject()) out += QuoteForYaml(expression);
      }
      out += ']';
    } else {
      const Json* yaml = value.IsObject() ? Find(value, "yaml") : nullptr;
      if (yaml == nullptr || !yaml->IsString()) return false;
      out += TextOf(*yaml);
    }
    return true;
  }

  const Json& root_;
  std::string& why_not_;
};

}  // namespace

std::optional<Request> ReadRequest(std::string_view json, std::string& why_not) {
  rapidjson::Document root;
  constexpr unsigned kFlags =
      rapidjson::kParseFullPrecisionFlag | rapidjson::kParseValidateEncodingFlag;
  if (diag::IsNestedTooDeep(json) || root.Parse<kFlags>(json.data(), json.size()).HasParseError() ||
      !root.IsObject())
    return diag::Refuse(why_not, "the request is not a JSON object");
  Request request;
  Reader reader(root, why_not);
  reader.Text("action", request.action);
  reader.Text("name", request.name);
  reader.Whole("revision", request.revision);
  reader.Whole("seed", request.seed);
  reader.Whole("index", request.index);
  reader.Whole("count", request.count);
  reader.Flag("nine", request.nine);
  reader.Word("pose", manifest::Find<BasePose>, "view, start or zero", request.pose);
  reader.Settings(request.settings, request.values);
  reader.Joints(request.joints);
  picture::Options& picture = request.picture;
  reader.Flag("quick", picture.quick);
  reader.Bounded("width", picture::kMinSize, 2048, picture.width);
  reader.Bounded("height", picture::kMinSize, 2048, picture.height);
  reader.Bounded("azimuth", -1e4, 1e4, picture.view.azimuth);
  reader.Bounded("elevation", -90, 90, picture.view.elevation);
  reader.Bounded("zoom", 1 / kMostZoom, kMostZoom, picture.view.zoom);
  reader.Bounded("x", 0, 1, request.x);
  reader.Bounded("y", 0, 1, request.y);
  reader.Word("layer", picture::ParseLayer, "the name of a layer", picture.layer);
  if (!why_not.empty()) return std::nullopt;
  return request;
}

}  // namespace mjforge::customize
