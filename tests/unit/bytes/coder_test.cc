// Tests of the binary encoding of structs.

#include <catch2/catch.hpp>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

struct Inner {
  int number = 0;
  std::string text;
};
struct Outer {
  std::vector<Inner> list;
  std::vector<bool> flags;
  std::optional<Inner> present;
  std::optional<Inner> absent;
  std::variant<double, std::string> either;
  std::string_view view;
};
struct Fields {
  static auto Of(Inner& inner) { return std::tie(inner.number, inner.text); }
  static auto Of(Outer& outer) {
    return std::tie(outer.list, outer.flags, outer.present, outer.absent, outer.either, outer.view);
  }
};

std::string Example() {
  const Outer outer{{{1, "a"}, {2, ""}}, {true, false, true}, Inner{3, "c"}, {}, "word", "seen"};
  return Encode<Fields>(outer);
}

TEST_CASE("a struct is decoded as it was encoded") {
  const std::string bytes = Example() + Encode<Fields>(std::uint8_t{7});
  Decoder<Fields> decoder(bytes);
  const Outer read = decoder.Read<Outer>();
  REQUIRE(read.list.size() == 2);
  CHECK(read.list[0].text == "a");
  CHECK(read.list[1].number == 2);
  CHECK(read.flags == std::vector<bool>{true, false, true});
  CHECK(read.present.value().text == "c");
  CHECK_FALSE(read.absent);
  CHECK(std::get<std::string>(read.either) == "word");
  CHECK(read.view == "seen");
  CHECK(decoder.Read<std::uint8_t>() == 7);
}

TEST_CASE("bytes that are cut short or damaged are refused") {
  const std::string bytes = Example();
  for (std::size_t size = 0; size < bytes.size(); ++size)
    CHECK_THROWS_AS(Decoder<Fields>(bytes.substr(0, size)).Read<Outer>(), std::runtime_error);
  const std::string alternative(1, '\7');
  CHECK_THROWS_AS((Decoder<Fields>(alternative).Read<std::variant<double, int>>()),
                  std::runtime_error);
}

}  // namespace
}  // namespace mjforge::bytes
