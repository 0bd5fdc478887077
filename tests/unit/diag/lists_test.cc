#include <catch2/catch.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"

using namespace mjforge::diag;

namespace {

using Named = std::pair<std::string, int>;

std::vector<Named> Letters() { return {{"a", 1}, {"b", 2}, {"b", 3}}; }

}  // namespace

TEST_CASE("an item is found by its key, the first one if several have it") {
  std::vector<Named> letters = Letters();
  Named* found = Find(letters, "b", &Named::first);
  REQUIRE(found == &letters[1]);
  found->second = 7;
  CHECK(letters[1].second == 7);
  CHECK(Find(letters, "c", &Named::first) == nullptr);
  CHECK(Find(std::span<const Named>(), "a", &Named::first) == nullptr);
}

TEST_CASE("an item is found by a condition") {
  const std::vector<Named> letters = Letters();
  CHECK(FindIf(letters, [](const Named& one) { return one.second > 1; }) == &letters[1]);
  CHECK(FindIf(letters, [](const Named& one) { return one.second > 3; }) == nullptr);
}

TEST_CASE("a list is mapped to the values of its items") {
  CHECK(Mapped<int>(Letters(), &Named::second) == std::vector{1, 2, 3});
  CHECK(Mapped<std::string>(Letters(), [](const Named& one) { return one.first + '!'; }) ==
        std::vector<std::string>{"a!", "b!", "b!"});
  CHECK(Mapped<int>(std::vector<Named>(), &Named::second).empty());
}

TEST_CASE("texts are joined with a separator between them") {
  CHECK(Joined(Letters(), ", ", &Named::first) == "a, b, b");
  CHECK(Joined(std::vector<Named>(), ", ", &Named::first).empty());
}

TEST_CASE("a text is cut at a separator, which neither piece keeps") {
  std::string_view text = "a,,b";
  CHECK(CutAt(',', text) == "a");
  CHECK(text == ",b");
  CHECK(CutAt(',', text).empty());
  CHECK(CutAt(',', text) == "b");
  CHECK(text.empty());
  CHECK(CutAt(',', text).empty());
}

TEST_CASE("a count agrees with its noun") {
  CHECK(Counted(1, "number") == "1 number");
  CHECK(Counted(0, "number") == "0 numbers");
  CHECK(Counted(1, "body", "bodies") == "1 body");
  CHECK(Counted(2, "body", "bodies") == "2 bodies");
}

TEST_CASE("a refusal has a reason and no value") {
  std::string why_not;
  const std::optional<int> refused = Refuse(why_not, "it is too small");
  CHECK(!refused);
  CHECK(why_not == "it is too small");
}
