#include <catch2/catch.hpp>
#include <vector>

#include "mjforge/diag/diag.h"

using namespace mjforge::diag;

namespace {

std::string Closest(std::string_view word, std::vector<std::string_view> candidates) {
  return std::string(ClosestWord(word, candidates).value_or("-"));
}

}  // namespace

TEST_CASE("one slip of the keyboard is forgiven") {
  const std::vector<std::string_view> words = {"radius", "density", "material"};
  CHECK(Closest("radus", words) == "radius");    // a letter left out
  CHECK(Closest("raddius", words) == "radius");  // one too many
  CHECK(Closest("rafius", words) == "radius");   // another letter
  CHECK(Closest("raduis", words) == "radius");   // two swapped
  CHECK(Closest("Radius", words) == "radius");   // only the case
  CHECK(Closest("DENSITY", words) == "density");
  CHECK(Closest("matereal", words) == "material");
}

TEST_CASE("two slips need six letters") {
  CHECK(Closest("raidsu", {"radius"}) == "radius");
  CHECK(Closest("size", {"site"}) == "site");
  CHECK(Closest("size", {"site_x"}) == "-");
  CHECK(Closest("abc", {"axy"}) == "-");
  CHECK(Closest("colour", {"rgba"}) == "-");
}

TEST_CASE("a swap counts once and a swapped pair is not edited again") {
  CHECK(Closest("ca", {"abc"}) == "-");
  CHECK(Closest("otp", {"top"}) == "top");
}

TEST_CASE("short words are forgiven less") {
  CHECK(Closest("mn", {"mm", "cm"}) == "mm");
  CHECK(Closest("xy", {"yx"}) == "yx");
  CHECK(Closest("m", {"mm"}) == "-");
  CHECK(Closest("r", {"s"}) == "-");
  CHECK(Closest("R", {"r"}) == "r");
  CHECK(Closest("ab", {"cd", "abc"}) == "-");
}

TEST_CASE("the nearest wins, of ties that with most equal ends, and then the first") {
  CHECK(Closest("handle_radus", {"handle_rads", "handle_radius"}) == "handle_radius");
  CHECK(Closest("pats", {"path", "parts"}) == "parts");
  CHECK(Closest("handle_raduis", {"handle_rad", "handle_radius"}) == "handle_radius");
  CHECK(Closest("bat", {"cat", "bar"}) == "cat");
  CHECK(Closest("NAME", {"game", "name"}) == "name");
}

TEST_CASE("another word in a long name is no slip") {
  CHECK(Closest("handle_length", {"handle_density"}) == "-");
  CHECK(Closest("start_lower", {"start_upper"}) == "-");
  CHECK(Closest("handel_lenght", {"handle_length"}) == "handle_length");
  CHECK(Closest("friion", {"friction"}) == "friction");
}

TEST_CASE("nothing is suggested for nothing or for a text") {
  CHECK(Closest("", {"a"}) == "-");
  CHECK(Closest("word", {}) == "-");
  CHECK(Closest("word", {""}) == "-");
  CHECK(Closest(std::string(200, 'x'), {std::string(200, 'y').c_str()}) == "-");
}

TEST_CASE("the question is asked only when there is something to suggest") {
  const std::vector<std::string_view> words = {"radius"};
  CHECK(DidYouMean("radus", words) == "did you mean 'radius'?");
  CHECK(DidYouMean("colour", words).empty());
}
