#include <catch2/catch.hpp>
#include <cmath>

#include "loading.h"
#include "mjforge/sample/distributions.h"

namespace mjforge::sample {
namespace {

using Catch::Matchers::WithinAbs;
using Pins = std::vector<double>;

// The first ten variants of seed 1 of a parameter `p`.
Pins FirstTen(const std::string& draw) {
  Family family = Load("{p: " + draw + "}");
  Pins values;
  for (std::uint64_t index = 0; index < 10; ++index) {
    values.push_back(family.Number("p", {.seed = 1, .index = index}));
  }
  CHECK(family.Report() == Strings{});
  return values;
}

TEST_CASE("the first ten values of each distribution are pinned") {
  CHECK(FirstTen("{uniform: [0.1, 0.25]}") == Pins{0.24227, 0.2415185, 0.1042032, 0.144169,
                                                   0.2401678, 0.1190905, 0.1019597, 0.144632,
                                                   0.1047798, 0.1965487});
  CHECK(FirstTen("{log_uniform: [0.001, 10]}") == Pins{6.221081, 5.94056, 0.00129445, 0.0150605,
                                                       5.467753, 0.00322909, 0.00112787, 0.0154948,
                                                       0.0013411, 0.375519});
  CHECK(FirstTen("{triangular: [1, 2, 4]}") == Pins{3.443941, 3.417541, 1.28994, 1.939883, 3.372874,
                                                    1.617908, 1.197974, 1.944796, 1.309186,
                                                    2.537792});
  CHECK(FirstTen("{normal: [0.5, 0.1]}") == Pins{0.663016, 0.658447, 0.30893, 0.44596, 0.65098,
                                                 0.386061, 0.277571, 0.446853, 0.314594, 0.536825});
  CHECK(FirstTen("{normal: [0.5, 0.1], clip: [0.6, 0.7]}") ==
        Pins{0.6884424, 0.6874444, 0.6015864, 0.618183, 0.685696, 0.6074235, 0.6007365, 0.6183946,
             0.6018061, 0.6467068});
  CHECK(FirstTen("{log_normal: [0, 0.5]}") == Pins{2.25936, 2.20833, 0.384678, 0.763226, 2.12739,
                                                   0.565698, 0.328853, 0.766642, 0.395727,
                                                   1.20217});
  CHECK(FirstTen("{log_normal: [0, 0.5], clip: [0, 1]}") ==
        Pins{0.9682, 0.965159, 0.333374, 0.592032, 0.959712, 0.466509, 0.289094, 0.594013, 0.341965,
             0.793505});
  CHECK(FirstTen("{beta: [2, 3]}") == Pins{0.748669, 0.740086, 0.0717618, 0.269178, 0.725735,
                                           0.16328, 0.048209, 0.270965, 0.0767941, 0.471549});
  CHECK(FirstTen("{beta: [0.5, 0.5], range: [-1, 1]}") ==
        Pins{0.986923, 0.984264, -0.996128, -0.601777, 0.978872, -0.921127, -0.999158, -0.594003,
             -0.994993, 0.436149});
  CHECK(FirstTen("{exponential: 4}") == Pins{0.741381, 0.718188, 0.00710544, 0.0871979, 0.681244,
                                             0.0340322, 0.00328765, 0.0882941, 0.00809601,
                                             0.257966});
  CHECK(FirstTen("{exponential: 4, clip: [1, 2]}") == Pins{1.668756, 1.651521, 1.006973, 1.085294,
                                                           1.623246, 1.033365, 1.003227, 1.086362,
                                                           1.007945, 1.249829});
  CHECK(FirstTen("{poisson: 3.5}") == Pins{7, 7, 0, 2, 6, 1, 0, 2, 1, 4});
  CHECK(FirstTen("{poisson: 3.5, clip: [5, 9]}") == Pins{8, 8, 5, 5, 8, 5, 5, 5, 5, 6});
  CHECK(FirstTen("{integer: [-3, 3]}") == Pins{3, 3, -3, -1, 3, -3, -3, -1, -3, 1});
  CHECK(FirstTen("{choice: [1, 2, 3]}") == Pins{3, 3, 1, 1, 3, 1, 1, 1, 1, 2});
}

TEST_CASE("the first ten options of a choice are pinned") {
  Family family = Load("{p: {choice: [a, b, c], weights: [1, 2, 1]}, q: {bernoulli: 0.3}}");
  std::string letters;
  std::string coins;
  for (std::uint64_t index = 0; index < 10; ++index) {
    letters += std::get<std::string>(family.Parameter("p", {.seed = 1, .index = index}));
    coins += std::get<bool>(family.Parameter("q", {.seed = 1, .index = index})) ? '1' : '0';
  }
  CHECK(letters == "ccabcaabab");
  CHECK(coins == "1000000010");
}

TEST_CASE("lo .. hi is the uniform draw of the same ends") {
  CHECK(FirstTen("0.1 .. 0.25") == FirstTen("{uniform: [0.1, 0.25]}"));
}

TEST_CASE("a range without width gives its end to the last digit") {
  Family family = Load("{a: 0.1234567890123, p: a .. a}");
  CHECK(family.Number("p") == 0.1234567890123);
}

TEST_CASE("the ends of a draw may be draws of their own") {
  Family family = Load("{p: {uniform: [1 .. 2, {uniform: [3, 4]}]}}");
  const DrawKey key = {.seed = 3, .index = 8};
  const StreamId stream = Child(Child(Child(kRootStream, "t"), "params"), "p");
  const auto draw = [&](StreamId path, double lo, double hi) {
    return RoundDraw(std::lerp(lo, hi, Uniforms(key, path)[0]), lo, hi);
  };
  const double lo = draw(Child(stream, "0"), 1, 2);
  const double hi = draw(Child(stream, "1"), 3, 4);
  CHECK(family.Number("p", key) == draw(stream, lo, hi));
}

TEST_CASE("an option's own draws have a stream below the option") {
  Family family = Load("{p: {choice: [1 .. 2, 3 .. 4]}, q: {cycle: [1 .. 2, 3 .. 4]}}");
  const DrawKey key = {.seed = 3, .index = 9};
  const StreamId params = Child(Child(kRootStream, "t"), "params");
  const double u = Uniforms(key, Child(params, "p"))[0];
  const std::size_t option = u < 0.5 ? 0 : 1;
  const double lo = option == 0 ? 1 : 3;
  const StreamId chosen = Child(Child(Child(params, "p"), "choice"), option);
  CHECK(family.Number("p", key) ==
        RoundDraw(std::lerp(lo, lo + 1, Uniforms(key, chosen)[0]), lo, lo + 1));
  const StreamId cycled = Child(Child(Child(params, "q"), "cycle"), std::size_t{1});
  CHECK(family.Number("q", key) == RoundDraw(std::lerp(3, 4, Uniforms(key, cycled)[0]), 3, 4));
}

TEST_CASE("a cycle goes through its values by the variant's index") {
  Family family = Load("{p: {cycle: [10, 20, 30]}}");
  for (std::uint64_t index = 0; index < 7; ++index) {
    CHECK(family.Number("p", {.index = index}) == 10 * static_cast<double>(index % 3 + 1));
  }
}

TEST_CASE("a reversed range is found when it is drawn") {
  CHECK(ReportOf("{a: 0.03, p: a .. 0.02}") ==
        Strings{"3:22 sample/empty-range: range 0.03 .. 0.02 is empty: its lower end is above its "
                "upper end (write the lower end first, or keep the ends apart with min() and "
                "max()) 7/3"});
  CHECK(ReportOf("{a: 3, p: {normal: [0, 1], clip: [a, 2]}}") ==
        Strings{"3:19 sample/empty-range: clip 3 .. 2 is empty: its lower end is above its upper "
                "end (write the lower end first, or keep the ends apart with min() and max()) "
                "7/3"});
}

TEST_CASE("a bad argument is found when it is drawn") {
  CHECK(ReportOf("{a: -1, p: {normal: [0, a]}}") ==
        Strings{"3:20 sample/bad-argument: standard deviation -1 is negative 7/3"});
  CHECK(ReportOf("{a: 300, p: {log_normal: [1000 * a, 1]}}") ==
        Strings{"3:21 sample/bad-argument: 'log_normal' drew a value that is not finite 7/3"});
}

TEST_CASE("bad weights are found when the choice is drawn") {
  CHECK(ReportOf("{a: -1, p: {choice: [1, 2], weights: [3, a]}}") ==
        Strings{"3:50 sample/bad-argument: weight 2 of the choice is -1; it must not be negative "
                "7/3"});
  CHECK(ReportOf("{a: 0, p: {choice: [1, 2], weights: [0, a]}}") ==
        Strings{"3:19 sample/bad-argument: all weights of the choice are 0; one must be positive "
                "7/3"});
  CHECK(ReportOf("{a: 1e308, p: {choice: [1, 2], weights: [a, a]}}") ==
        Strings{"3:23 sample/bad-argument: the sum of the choice's weights is infinite 7/3"});
}

TEST_CASE("quat: random is the rotation of the stream's first three uniforms") {
  Family family = Load("{}", "parts: [{name: b, type: box, size: [1, 1, 1], quat: random}]");
  const DrawKey key = {.seed = 5, .index = 2};
  Evaluator evaluator = family.Evaluator(key);
  Numbers q;
  evaluator.Vector(family.PartValue("quat"), 77, q);
  const auto u = Uniforms(key, 77);
  const auto expected = UniformRotation(u[0], u[1], u[2]);
  REQUIRE(q.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(q[i] == expected[i]);
}

TEST_CASE("a rotation about an axis turns about that axis, of any length") {
  Family family = Load("{}",
                       "parts: [{name: b, type: box, size: [1, 1, 1], "
                       "quat: {about: [0, 3, 4]}}]");
  Evaluator evaluator = family.Evaluator({.seed = 5});
  Numbers q;
  evaluator.Vector(family.PartValue("quat"), 77, q);
  REQUIRE(q.size() == 4);
  CHECK(q[0] > 0);
  CHECK(q[1] == 0);
  CHECK_THAT(q[2] * 4, WithinAbs(q[3] * 3, 1e-15));
  CHECK_THAT(q[0] * q[0] + q[2] * q[2] + q[3] * q[3], WithinAbs(1, 1e-15));
}

TEST_CASE("a rotation about nothing is found") {
  Family family = Load("{z: 0}",
                       "parts: [{name: b, type: box, size: [1, 1, 1], "
                       "quat: {about: [z, 0, z]}}]");
  Evaluator evaluator = family.Evaluator({.seed = 7, .index = 3});
  Numbers q;
  evaluator.Vector(family.PartValue("quat"), 77, q);
  CHECK(family.Report() == Strings{"4:61 sample/bad-argument: the axis to turn about is 0 0 0; it "
                                   "needs a direction 7/3"});
}

TEST_CASE("a point on a sphere has the sphere's radius") {
  Family family = Load("{}",
                       "parts: [{name: b, type: box, size: [1, 1, 1], "
                       "pos: {on_sphere: 2 .. 3}}]");
  const DrawKey key = {.seed = 5};
  Evaluator evaluator = family.Evaluator(key);
  Numbers p;
  evaluator.Vector(family.PartValue("pos"), 77, p);
  REQUIRE(p.size() == 3);
  const double radius = RoundDraw(2 + Uniforms(key, Child(77, "on_sphere"))[0], 2, 3);
  CHECK_THAT(std::hypot(p[0], p[1], p[2]), WithinAbs(radius, 1e-15));
}

TEST_CASE("a sphere of negative radius is found") {
  Family family = Load("{r: -2}",
                       "parts: [{name: b, type: box, size: [1, 1, 1], "
                       "pos: {on_sphere: r}}]");
  Evaluator evaluator = family.Evaluator({.seed = 7, .index = 3});
  Numbers p;
  evaluator.Vector(family.PartValue("pos"), 77, p);
  CHECK(family.Report() == Strings{"4:64 sample/bad-argument: the radius of the sphere is -2; it "
                                   "must not be negative 7/3"});
}

TEST_CASE("a colour of hue, saturation, value is opaque unless it says so") {
  Family family = Load("{a: {hsv: [0, 0.5, 0.8]}, b: {hsv: [0, 0.5, 0.8, 0.25]}}");
  CHECK(std::get<Pins>(family.Parameter("a")) == Pins{0.8, 0.4, 0.4, 1});
  CHECK(std::get<Pins>(family.Parameter("b")) == Pins{0.8, 0.4, 0.4, 0.25});
}

TEST_CASE("a colour out of range is found, each part of it") {
  CHECK(ReportOf("{h: 1.5, c: {hsv: [h, 0.5, -h]}}") ==
        Strings{"3:28 sample/bad-argument: hue is 1.5; it must be between 0 and 1 7/3",
                "3:36 sample/bad-argument: value is -1.5; it must be between 0 and 1 7/3"});
}

}  // namespace
}  // namespace mjforge::sample
