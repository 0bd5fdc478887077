// Draws of a spec: pinned values, choices, cycles, errors, rotations, spheres and colours.

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
  CHECK(FirstTen("{uniform: [0.1, 0.25]}") == Pins{0.2050231, 0.1007735, 0.1237945, 0.1724189,
                                                   0.1034763, 0.1305593, 0.2319357, 0.1845887,
                                                   0.161364, 0.133836});
  CHECK(FirstTen("{log_uniform: [0.001, 10]}") == Pins{0.631852, 0.00104864, 0.00431043, 0.0853438,
                                                       0.00123795, 0.00653, 3.298268, 0.180177,
                                                       0.0432886, 0.00798533});
  CHECK(FirstTen("{triangular: [1, 2, 4]}") == Pins{2.658703, 1.124377, 1.689848, 2.238398,
                                                    1.263679, 1.781783, 3.149958, 2.382455,
                                                    2.117066, 1.82263});
  CHECK(FirstTen("{normal: [0.5, 0.1]}") == Pins{0.552484, 0.243485, 0.39999, 0.495685, 0.300782,
                                                 0.417162, 0.617285, 0.516093, 0.477012, 0.424649});
  CHECK(FirstTen("{normal: [0.5, 0.1], clip: [0.6, 0.7]}") ==
        Pins{0.6526033, 0.60029, 0.6093457, 0.6322257, 0.6013103, 0.6121829, 0.6761026, 0.6391645,
             0.6264321, 0.6135902});
  CHECK(FirstTen("{log_normal: [0, 0.5]}") == Pins{1.30007, 0.277322, 0.606499, 0.978658, 0.36932,
                                                   0.660876, 1.79755, 1.08379, 0.891421, 0.686086});
  CHECK(FirstTen("{log_normal: [0, 0.5], clip: [0, 1]}") ==
        Pins{0.824848, 0.246957, 0.494184, 0.704048, 0.321337, 0.52967, 0.927042, 0.749379,
             0.661831, 0.545572});
  CHECK(FirstTen("{beta: [2, 3]}") == Pins{0.508509, 0.0299118, 0.185284, 0.375906, 0.0649544,
                                           0.21467, 0.656421, 0.422881, 0.334282, 0.228234});
  CHECK(FirstTen("{beta: [0.5, 0.5], range: [-1, 1]}") ==
        Pins{0.588176, -0.999869, -0.878372, -0.0540313, -0.997351, -0.802077, 0.92928, 0.199478,
             -0.281725, -0.759235});
  CHECK(FirstTen("{exponential: 4}") == Pins{0.301121, 0.00129248, 0.043181, 0.164828, 0.00586206,
                                             0.0569537, 0.529175, 0.207485, 0.131524, 0.063908});
  CHECK(FirstTen("{exponential: 4, clip: [1, 2]}") == Pins{1.290652, 1.001269, 1.042319, 1.16059,
                                                           1.005753, 1.055785, 1.497787, 1.201633,
                                                           1.128374, 1.062578});
  CHECK(FirstTen("{poisson: 3.5}") == Pins{4, 0, 2, 3, 0, 2, 6, 4, 3, 2});
  CHECK(FirstTen("{poisson: 3.5, clip: [5, 9]}") == Pins{6, 5, 5, 5, 5, 5, 7, 6, 5, 5});
  CHECK(FirstTen("{integer: [-3, 3]}") == Pins{1, -3, -2, 0, -3, -2, 3, 0, -1, -2});
  CHECK(FirstTen("{choice: [1, 2, 3]}") == Pins{3, 1, 1, 2, 1, 1, 3, 2, 2, 1});
}

TEST_CASE("the first ten options of a choice are pinned") {
  Family family = Load("{p: {choice: [a, b, c], weights: [1, 2, 1]}, q: {bernoulli: 0.3}}");
  std::string letters;
  std::string coins;
  for (std::uint64_t index = 0; index < 10; ++index) {
    letters += std::get<std::string>(family.Parameter("p", {.seed = 1, .index = index}));
    coins += std::get<bool>(family.Parameter("q", {.seed = 1, .index = index})) ? '1' : '0';
  }
  CHECK(letters == "baabaacbba");
  CHECK(coins == "0000000100");
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
    return RoundWithin(lo, hi, std::lerp(lo, hi, Uniforms(key, path)[0]));
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
        RoundWithin(lo, lo + 1, std::lerp(lo, lo + 1, Uniforms(key, chosen)[0])));
  const StreamId cycled = Child(Child(Child(params, "q"), "cycle"), std::size_t{1});
  CHECK(family.Number("q", key) == RoundWithin(3, 4, std::lerp(3, 4, Uniforms(key, cycled)[0])));
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
  const double radius = RoundWithin(2, 3, 2 + Uniforms(key, Child(77, "on_sphere"))[0]);
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
