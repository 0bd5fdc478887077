#include "mjforge/diag/json.h"

#include <catch2/catch.hpp>
#include <limits>
#include <vector>

namespace mjforge::diag {
namespace {

void Spell(std::string& out, double number) { out += std::to_string(number).substr(0, 4); }

TEST_CASE("JSON is written as it comes") {
  Json json(Spell, "[1]\n");
  json.StartObject();
  json.Member("text", "a");
  json.Member("flag", true);
  json.Member("whole", std::numeric_limits<std::uint64_t>::max());
  json.Member("number", 0.25);
  json.Member("none", std::numeric_limits<double>::infinity());
  json.Member("list", std::vector<double>{1.5, 2});
  json.Member("held", std::variant<double, std::string>("b"));
  json.Key("empty");
  json.StartArray();
  json.EndArray();
  json.Key("raw");
  json.Raw("{}");
  json.EndObject();
  CHECK(json.Take() ==
        "[1]\n{\"text\":\"a\",\"flag\":true,\"whole\":18446744073709551615,\"number\":0.25,"
        "\"none\":null,\"list\":[1.50,2.00],\"held\":\"b\",\"empty\":[],\"raw\":{}}");
}

TEST_CASE("texts are escaped where JSON wants it") {
  Json json(Spell);
  json.Value(std::string("\"\\/\b\f\n\r\t\x01\x1f\x7f\0\xc3\xa9", 14));
  CHECK(json.Take() == R"("\"\\/\b\f\n\r\t\u0001\u001F\u007F\u0000)"
                       "\xc3\xa9\"");
}

TEST_CASE("characters that control a terminal are escaped, and others are not") {
  Json json(Spell);
  json.Value("\xc2\x9b\xe2\x80\xae\xd8\x9c \xc2\xb0\xe2\x82\xac\xd8\xa7\xc2");
  CHECK(json.Take() == "\"\\u009B\\u202E\\u061C \xc2\xb0\xe2\x82\xac\xd8\xa7\xc2\"");
}

TEST_CASE("JSON that is nested too deep is told before it is read") {
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') +
           std::string(static_cast<std::size_t>(depth), ']');
  };
  CHECK_FALSE(IsNestedTooDeep(nested(kMaxJsonDepth)));
  CHECK(IsNestedTooDeep(nested(kMaxJsonDepth + 1)));
  CHECK(IsNestedTooDeep(std::string(200'000, '{')));
  CHECK_FALSE(IsNestedTooDeep(R"({"a":")" + std::string(100, '[') + R"(\"[[[[[[[[[["})"));
  CHECK_FALSE(IsNestedTooDeep("[" + std::string(1000, ' ') + "[],[],[]]"));
}

}  // namespace
}  // namespace mjforge::diag
