// Evaluation of numbers, texts, vectors and points, and the reports of failures.

#include <catch2/catch.hpp>
#include <set>

#include "loading.h"

namespace mjforge::sample {
namespace {

using Vector = std::vector<double>;

TEST_CASE("literals, expressions and other parameters are numbers") {
  Family family = Load("{a: 0.3, b: 2 * a + 10mm, c: b, d: index + 1}");
  CHECK(family.Number("a") == 0.3);
  CHECK(family.Number("b") == Approx(0.61).epsilon(1e-15));
  CHECK(family.Number("c") == family.Number("b"));
  CHECK(family.Number("d", {.index = 41}) == 42);
}

TEST_CASE("booleans are literals, comparisons, coins and choices") {
  Family family = Load("{a: true, b: 2 < 1, c: {bernoulli: 1}, d: {choice: [false]}, e: a}");
  CHECK(std::get<bool>(family.Parameter("a")));
  CHECK_FALSE(std::get<bool>(family.Parameter("b")));
  CHECK(std::get<bool>(family.Parameter("c")));
  CHECK_FALSE(std::get<bool>(family.Parameter("d")));
  CHECK(std::get<bool>(family.Parameter("e")));
}

TEST_CASE("text is a literal, a choice, or another text parameter") {
  Family family = Load("{a: box, b: {choice: [sphere]}, c: {cycle: [x, y]}, d: a}");
  CHECK(std::get<std::string>(family.Parameter("a")) == "box");
  CHECK(std::get<std::string>(family.Parameter("b")) == "sphere");
  CHECK(std::get<std::string>(family.Parameter("c", {.index = 1})) == "y");
  CHECK(std::get<std::string>(family.Parameter("d")) == "box");
}

TEST_CASE("text compares with a quoted literal") {
  Family family = Load("{shape: {cycle: [box, ball]}, n: \"shape == 'ball' ? 2 : 1\"}");
  CHECK(family.Number("n", {.index = 0}) == 1);
  CHECK(family.Number("n", {.index = 1}) == 2);
}

TEST_CASE("text interpolates numbers, booleans and texts") {
  Family family =
      Load("{k: 3, r: 0.1, w: oak, t: true, s: \"${w}_${k + 1}_${r / 3}_${t}_${k > 5}\"}");
  CHECK(std::get<std::string>(family.Parameter("s")) == "oak_4_0.03333333333_true_false");
}

TEST_CASE("a vector is a list, another vector, or chosen whole") {
  Family family =
      Load("{a: [1, 2, 3 * 2], b: a, c: {choice: [[7, 8]]}, d: {cycle: [[1, 2], [3, 4]]}}");
  CHECK(std::get<Vector>(family.Parameter("a")) == Vector{1, 2, 6});
  CHECK(std::get<Vector>(family.Parameter("b")) == Vector{1, 2, 6});
  CHECK(std::get<Vector>(family.Parameter("c")) == Vector{7, 8});
  CHECK(std::get<Vector>(family.Parameter("d", {.index = 3})) == Vector{3, 4});
}

TEST_CASE("a vector's components are read by name") {
  Family family = Load("{a: [1, 2, 4, 8], s: a.x + 10 * a.y + 100 * a.z + 1000 * a.w}");
  CHECK(family.Number("s") == 8421);
}

TEST_CASE("the items of a vector draw from streams of their own") {
  Family family = Load("{v: [0 .. 1, 5, 0 .. 1]}");
  const DrawKey key = {.seed = 2, .index = 6};
  const StreamId stream = Child(Child(Child(kRootStream, "t"), "params"), "v");
  const auto v = std::get<Vector>(family.Parameter("v", key));
  CHECK(v == Vector{RoundWithin(0, 1, Uniforms(key, Child(stream, "0"))[0]), 5,
                    RoundWithin(0, 1, Uniforms(key, Child(stream, "2"))[0])});
}

TEST_CASE("points are given one after the other, each with its own streams") {
  Family family = Load("{p: [4, 5]}",
                       "parts: [{name: b, type: prism, height: 1, "
                       "polygon: [[0, 1], p, [0 .. 1, 3]]}]");
  const DrawKey key = {.seed = 2};
  Evaluator evaluator = family.Evaluator(key);
  const PointList made = evaluator.Points(family.PartValue("polygon"), 50).value();
  const Vector points(made.numbers.begin(), made.numbers.end());
  const double drawn =
      RoundWithin(0, 1, Uniforms(key, Child(Child(50, std::size_t{2}), std::size_t{0}))[0]);
  CHECK(points == Vector{0, 1, 4, 5, drawn, 3});
}

PointList Path(const std::string& points) {
  Family made = Load("{n: 2}", "parts: [{name: b, type: tube, path: [" + points + "]}]");
  const DrawKey key = {.seed = 2};
  Evaluator evaluator = made.Evaluator(key);
  return evaluator.Points(made.PartValue("path"), 50).value();
}

TEST_CASE("arcs in space turn about an axis") {
  for (const std::size_t axis : {0, 1, 2}) {
    const PointList made = Path(
        "{arc: [[1, 2, 3], 2, 0, 90deg], axis: " + std::string(1, "xyz"[axis]) + ", steps: 2}");
    REQUIRE(made.per_point == 3);
    REQUIRE(made.numbers.size() == 9);
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = M_PI / 4 * double(k);
      std::array<double, 3> p = {1, 2, 3};
      p[(axis + 1) % 3] += 2 * std::cos(angle);
      p[(axis + 2) % 3] += 2 * std::sin(angle);
      for (std::size_t i = 0; i < 3; ++i) CHECK(made.numbers[3 * k + i] == Approx(p[i]));
    }
  }
  const PointList about_z = Path("{arc: [[0, 0, n, 5], 1, 0, 180deg], steps: 1}");
  CHECK(about_z.per_point == 4);
  CHECK(about_z.numbers[2] == 2);
  CHECK(about_z.numbers[7] == 5);
}

TEST_CASE("arcs go through three points, by the shortest way that meets all") {
  // In the plane y = z, with the middle at y = z = 1/4.
  const double s = std::sqrt(0.5);
  const PointList half = Path("{arc: [[0, 0, 0, 1], [1, 1, 1, 2], [2, 0, 0, 4]], steps: 4}");
  REQUIRE(half.per_point == 4);
  REQUIRE(half.numbers.size() == 20);
  const double v = 0.25 * std::sqrt(2);
  const double radius = std::sqrt(1 + v * v);
  for (std::size_t k = 0; k < 5; ++k) {
    const double* p = &half.numbers[4 * k];
    CHECK(p[1] == Approx(p[2]).margin(1e-12));
    const double across = p[1] / s - v;
    CHECK(std::sqrt((p[0] - 1) * (p[0] - 1) + across * across) == Approx(radius));
  }
  CHECK(half.numbers[0] == 0);
  CHECK(half.numbers[8] == Approx(1));
  CHECK(half.numbers[9] == Approx(1));
  CHECK(half.numbers[7] == Approx(1.5));
  CHECK(half.numbers[11] == Approx(2));
  CHECK(half.numbers[15] == Approx(3));
  CHECK(half.numbers[16] == 2);
  const PointList most = Path("{arc: [[1, 0, 0], [-1, 0, 0], [0, -1, 0]], steps: 3}");
  CHECK(most.numbers[3] == Approx(0).margin(1e-12));
  CHECK(most.numbers[4] == Approx(1));
  CHECK(most.numbers[6] == Approx(-1));
}

TEST_CASE("three points on a line are on no arc") {
  for (const char* points : {"[0, 0, 0], [1, 1, 1], [3, 3, 3]", "[0, 0, 0], [0, 0, 0], [1, 0, 0]",
                             "[0, 0, 0], [1, 0, 0], [0, 0, 0]"}) {
    Family made = Load(
        "{n: 2}", "parts: [{name: b, type: tube, path: [{arc: [" + std::string(points) + "]}]}]");
    const DrawKey key = {.seed = 2};
    Evaluator evaluator = made.Evaluator(key);
    CHECK_FALSE(evaluator.Points(made.PartValue("path"), 50));
  }
}

TEST_CASE("points are repeated, and lie on arcs, each with its place in the spec") {
  Family drawn = Load("{n: 2}",
                      "parts: [{name: b, type: lathe, profile: [[1, 0], "
                      "{for: {i: n, j: [5, 6]}, at: [i + 1, {uniform: [j, j + 1]}]}, "
                      "{arc: [[n, 0], 1, 0, 90deg], steps: n}]}]");
  const DrawKey key = {.seed = 2};
  Evaluator evaluator = drawn.Evaluator(key);
  const PointList made = evaluator.Points(drawn.PartValue("profile"), 50).value();
  REQUIRE(made.numbers.size() == 2 * (1 + 4 + 3));
  REQUIRE(made.marks.size() == 8);
  std::set<double> seen;
  for (std::size_t k = 0; k < 4; ++k) {
    const double i = k < 2 ? 0 : 1;
    const double j = k % 2 == 0 ? 5 : 6;
    CHECK(made.numbers[2 + 2 * k] == i + 1);
    const double y = made.numbers[3 + 2 * k];
    CHECK(y > j);
    CHECK(y < j + 1);
    CHECK(seen.insert(y - j).second);
    CHECK(made.marks[1 + k].column == made.marks[1].column);
  }
  CHECK(made.numbers[10] == 3);
  CHECK(made.numbers[12] == Approx(2 + std::sqrt(0.5)));
  CHECK(made.numbers[15] == Approx(1));
  CHECK(made.marks[0].column < made.marks[1].column);
  CHECK(made.marks[4].column < made.marks[5].column);
}

TEST_CASE("a vector replaces what was in the numbers before") {
  Family family = Load("{}");
  Evaluator evaluator = family.Evaluator();
  Numbers numbers = {9, 9, 9, 9};
  evaluator.Vector(family.PartValue("size"), 1, numbers);
  CHECK(Vector(numbers.begin(), numbers.end()) == Vector{1, 1, 1});
}

TEST_CASE("an expression that is not finite is found with its inputs' values") {
  CHECK(ReportOf("{a: 1, b: 0, p: a / b}") ==
        Strings{"3:25 expr/not-finite: expression 'a / b' is infinite: a = 1, b = 0 7/3"});
  CHECK(ReportOf("{a: -2.5, p: sqrt(a)}") ==
        Strings{"3:22 expr/not-finite: expression 'sqrt(a)' is not a number: a = -2.5 7/3"});
}

TEST_CASE("the inputs of a failed expression leave out texts and name booleans") {
  CHECK(ReportOf("{t: box, f: true, v: [1, 0], p: \"t == 'box' && f ? v.x / v.y : 0\"}") ==
        Strings{"3:41 expr/not-finite: expression 't == 'box' && f ? v.x / v.y : 0' is infinite: "
                "f = true, v.x = 1, v.y = 0 7/3"});
}

TEST_CASE("what follows from a failed value is not found again") {
  CHECK(
      ReportOf("{a: 0, p: 1 / a, q: 2 * p, r: q .. 5, s: {choice: [1, 2], weights: [q, 1]}, "
               "v: [p, q], c: {hsv: [p, 1, 1]}, t: \"n_${q}\", n: {normal: [0, 1], clip: [p, 3]}}",
               "require: [q > 1]") ==
      Strings{"3:19 expr/not-finite: expression '1 / a' is infinite: a = 0 7/3"});
}

TEST_CASE("a text, a truth or a list of a failed value has no value") {
  Family family = Load(
      "{a: 0, p: 1 / a, t: \"n_${p}\", u: t, b: p > 1, c: b, w: {choice: [x, y], weights: [p, 1]}, "
      "l: {each: p, count: 5}, s: {shuffle: l}, n: sum(s)}");
  Evaluator evaluator = family.Evaluator({.seed = 7, .index = 3});
  for (const spec::Parameter& parameter : family.spec->parameters) {
    INFO(parameter.name);
    CHECK(evaluator.Any(parameter.value, 1).has_value() == (parameter.name == "a"));
  }
  family.findings.Unique();
  CHECK(family.Report() ==
        Strings{"3:19 expr/not-finite: expression '1 / a' is infinite: a = 0 7/3"});
}

TEST_CASE("values that do not depend on a failed one are still computed") {
  Family family = Load("{a: 0, p: 1 / a, l: {each: 2, count: 3}, n: sum(l), t: \"n_${n}\"}");
  Evaluator evaluator = family.Evaluator();
  CHECK(evaluator.Any(family.spec->parameters[4].value, 1) == ParameterValue(std::string("n_6")));
  CHECK(family.findings.size() == 1);
}

TEST_CASE("a vector that was never set is found where it is used") {
  Family family = Load("{v: [1, 2], u: v}");
  Evaluator evaluator = family.Evaluator({.seed = 7, .index = 3});
  evaluator.SetVariable(family.spec->parameters[0].slot, kFailedNumber);
  CHECK_FALSE(evaluator.Any(family.spec->parameters[1].value, 1));
  CHECK(family.Report() ==
        Strings{"3:24 expr/not-finite: 'v' has no value in this variant (it was left out by "
                "'if' or 'fewer', or is placed later) 7/3"});
}

TEST_CASE("independent failures are all found") {
  Family family = Load("{a: 0, p: 1 / a, q: 2 / a}");
  CHECK(Sample(*family.spec, {}, kRootStream, {}, family.findings) == std::nullopt);
  CHECK(family.Report() ==
        Strings{"3:19 expr/not-finite: expression '1 / a' is infinite: a = 0 0/0",
                "3:29 expr/not-finite: expression '2 / a' is infinite: a = 0 0/0"});
}

TEST_CASE("Any returns a value of the type of the spec's value") {
  Family family = Load("{a: 2, b: 1 < 2, c: box, d: [1, 2], e: d}");
  Evaluator evaluator = family.Evaluator();
  const auto any = [&](std::size_t i) {
    return evaluator.Any(family.spec->parameters[i].value, 1);
  };
  CHECK(any(0) == ParameterValue(2.0));
  CHECK(any(1) == ParameterValue(true));
  CHECK(any(2) == ParameterValue(std::string("box")));
  CHECK(any(3) == ParameterValue(Vector{1, 2}));
  CHECK(any(4) == ParameterValue(Vector{1, 2}));
}

TEST_CASE("a value of another kind than asked for is found, not guessed") {
  Family family = Load("{}", "parts: [{name: b, type: box, size: [1, 1, 1], quat: random}]");
  Evaluator evaluator = family.Evaluator();
  CHECK(std::isnan(evaluator.Number(family.PartValue("quat"), 1)));
  CHECK_FALSE(evaluator.Points(family.PartValue("quat"), 1));
  CHECK(evaluator.failed());
  CHECK(family.Report() == Strings{"4:53 sample/bad-argument: this value is not a number 0/0",
                                   "4:53 sample/bad-argument: this value is not a list of points "
                                   "0/0"});
}

}  // namespace
}  // namespace mjforge::sample
