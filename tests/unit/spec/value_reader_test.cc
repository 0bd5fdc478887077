#include <catch2/catch.hpp>

#include "loading.h"

namespace {

using mjforge::expr::Type;

const mjforge::spec::Value& ValueOf(const Loaded& loaded, const std::string& name) {
  const mjforge::spec::Parameter* parameter = loaded.spec->FindParameter(name);
  REQUIRE(parameter != nullptr);
  return parameter->value;
}

}  // namespace

TEST_CASE("a parameter's type is told from its look", "[value]") {
  const Loaded loaded = LoadWithBox(
      "params:\n"
      "  number: 1e-3\n"
      "  hex: 0x10\n"
      "  yes_is_text: yes\n"
      "  truth: true\n"
      "  words: light-wood.png\n"
      "  quoted: 'number'\n"
      "  digits: '12'\n"
      "  sizes: {choice: ['8', m10, '1e1']}\n"
      "  rows: ['1', '2']\n"
      "  sum: number + 2\n"
      "  test: number > 2\n"
      "  vector: [1, number, 3]\n"
      "  copy: vector\n"
      "  range: 1 .. 2\n"
      "  tight: 0..1\n"
      "  shape: {choice: [box, ball], weights: [1, 2]}\n"
      "  coin: {bernoulli: 0.5}\n"
      "  turn: {about: [0, 0, 1]}\n"
      "  colour: {hsv: [0..1, 1, 1]}\n"
      "  label: part_${number}\n");
  REQUIRE(loaded.Report() == Strings{});
  const auto check = [&](const std::string& name, Type type, int components) {
    INFO(name);
    CHECK(ValueOf(loaded, name).type == type);
    CHECK(ValueOf(loaded, name).components == components);
  };
  check("number", Type::kNumber, 1);
  check("hex", Type::kNumber, 1);
  check("yes_is_text", Type::kText, 1);
  check("truth", Type::kBoolean, 1);
  check("words", Type::kText, 1);
  check("quoted", Type::kText, 1);
  check("digits", Type::kText, 1);
  check("sizes", Type::kText, 1);
  check("rows", Type::kText, 1);
  check("sum", Type::kNumber, 1);
  check("test", Type::kBoolean, 1);
  check("vector", Type::kNumber, 3);
  check("copy", Type::kNumber, 3);
  check("range", Type::kNumber, 1);
  check("tight", Type::kNumber, 1);
  check("shape", Type::kText, 1);
  check("coin", Type::kBoolean, 1);
  check("turn", Type::kNumber, 4);
  check("colour", Type::kNumber, 4);
  check("label", Type::kText, 1);
  CHECK(std::get<double>(ValueOf(loaded, "number").form) == 1e-3);
  CHECK(std::get<double>(ValueOf(loaded, "hex").form) == 16);
}

TEST_CASE("a quoted number is not a number", "[value]") {
  CHECK(ReportWithBox("total_size: ['0.3', 1, 1]\n") ==
        Strings{"4:14 spec/wrong-type: expected a number, got the text '0.3' (a quoted number is "
                "text: drop the quotes)"});
}

TEST_CASE("a quoted expression is an expression", "[value]") {
  CHECK(ReportWithBox("params: {a: 1, b: 2}\ntotal_size: [\"max(a, b)\", 1, 1]\n") == Strings{});
}

TEST_CASE("an unquoted comma in a list gets a hint to quote", "[value]") {
  const Strings report = ReportWithBox("params: {a: 1, b: 2}\ntotal_size: [max(a, b), 1, 1]\n");
  REQUIRE(report.size() == 1);
  CHECK(report[0].find("5:17") == 0);
  CHECK(report[0].find("a comma ends an item of a list in brackets; quote the expression: "
                       "[\"max(a, b)\", 0]") != std::string::npos);
}

TEST_CASE("yes and no are text, and said so where a boolean belongs", "[value]") {
  CHECK(ReportWithBox("materials: {m: {texuniform: yes}}\n") ==
        Strings{"4:29 spec/wrong-type: expected true or false, got the text 'yes' (YAML 1.2 writes "
                "booleans as true and false)"});
}

TEST_CASE("infinite and NaN literals are refused", "[value]") {
  CHECK(ReportWithBox("mass: .nan\n") ==
        Strings{"4:7 spec/wrong-type: expected a finite number, got '.nan'"});
  CHECK(ReportWithBox("params: {a: -.inf}\n") ==
        Strings{"4:13 spec/wrong-type: expected a finite number, got '-.inf'"});
}

TEST_CASE("a constant range must not be reversed", "[value]") {
  const std::string text = "is empty: its lower end is above its upper end (swap the two)";
  CHECK(ReportWithBox("params: {a: 3cm .. 2cm}\n") ==
        Strings{"4:13 spec/empty-range: range 0.03 .. 0.02 " + text});
  CHECK(ReportWithBox("params: {a: {uniform: [3, 2]}}\n") ==
        Strings{"4:23 spec/empty-range: range 3 .. 2 " + text});
  CHECK(ReportWithBox("params: {a: {normal: [0, 1], clip: [1, -1]}}\n") ==
        Strings{"4:36 spec/empty-range: range 1 .. -1 " + text});
}

TEST_CASE("literal values are held against the table's bounds", "[value]") {
  CHECK(ReportWithBox("total_size: [1, 0, 1]\n") ==
        Strings{"4:17 spec/bad-value: total_size 2 is 0; it must be greater than 0"});
  CHECK(ReportWithBox("materials: {m: {rgba: [1, 1, 1, 2]}}\n") ==
        Strings{"4:33 spec/bad-value: rgba 4 is 2; it must be at most 1"});
  CHECK(ReportWithBox("materials: {m: {condim: 2.5}}\n") ==
        Strings{"4:25 spec/bad-value: condim is 2.5; it must be a whole number"});
  CHECK(ReportWithBox("mass: 1 - 1\n") ==
        Strings{"4:7 spec/bad-value: mass is 0; it must be greater than 0"});
}

TEST_CASE("the options and the ends of a draw are held against the bounds, too", "[value]") {
  const auto report = [](const std::string& field) {
    return Load("mjforge: 1\nname: t\nparts:\n- {name: a, type: box, size: [1, 1, 1], " + field +
                "}\n")
        .Report();
  };
  CHECK(report("condim: 2") ==
        Strings{"4:49 spec/bad-value: condim is 2; it must be 1, 3, 4 or 6"});
  CHECK(report("condim: {choice: [1, 2]}") ==
        Strings{"4:62 spec/bad-value: condim is 2; it must be 1, 3, 4 or 6"});
  CHECK(report("density: -5 .. 10") ==
        Strings{"4:50 spec/bad-value: density is -5; it must be at least 0"});
  CHECK(report("density: 0 .. 10") == Strings{});
  CHECK(report("condim: {choice: [1, 3]}") == Strings{});
}

TEST_CASE("a wrong word gets the words and a suggestion", "[value]") {
  CHECK(ReportWithBox("placement: corners\ntotal_size: [1, 1, 1]\n") ==
        Strings{"4:12 spec/bad-value: 'corners' is not one of center, corner (did you mean "
                "'corner'?)"});
}

TEST_CASE("vectors have the length of their slot", "[value]") {
  CHECK(ReportWithBox("total_size: [1, 2]\n") ==
        Strings{"4:13 spec/wrong-length: expected 3 numbers, got 2"});
  CHECK(ReportWithBox("params: {v: [1, 2]}\ntotal_size: v\n") ==
        Strings{"5:13 spec/wrong-length: expected 3 numbers, got 2"});
  CHECK(ReportWithBox("params: {v: [1, 2, 3]}\ntotal_size: v\n") == Strings{});
}

TEST_CASE("a distribution takes its own arguments and options", "[value]") {
  CHECK(ReportWithBox("params: {a: {triangular: [1, 2]}}\n") ==
        Strings{"4:26 spec/distribution: 'triangular' takes 3 numbers (write {triangular: [lo, "
                "mode, hi]})"});
  CHECK(ReportWithBox("params: {a: {unifrom: [1, 2]}}\n") ==
        Strings{"4:14 spec/unknown-key: unknown key 'unifrom' in a distribution (did you mean "
                "'uniform'?)"});
  CHECK(ReportWithBox("params: {a: {uniform: [1, 2], clip: [1, 2]}}\n") ==
        Strings{"4:31 spec/unknown-key: unknown key 'clip' in a distribution"});
  CHECK(ReportWithBox("params: {a: {uniform: [1, 2], normal: [1, 2]}}\n") ==
        Strings{"4:31 spec/conflict: 'normal' together with 'uniform': a value is drawn in only "
                "one way"});
  CHECK(ReportWithBox("params: {a: {choice: [1, 2], weights: [1]}}\n") ==
        Strings{"4:39 spec/wrong-length: 'weights' has 1 numbers; it needs 2 (one weight for each "
                "value)"});
  CHECK(ReportWithBox("params: {a: {choice: [1, box]}}\n") ==
        Strings{"4:26 spec/wrong-type: the values to choose from are of different kinds: a number "
                "and text"});
}

TEST_CASE("an exact choice has weights that are constants", "[value]") {
  CHECK(ReportWithBox("params: {a: {choice: [1, 2], weights: [2 * 3, 1 / 3], exact: true}}\n")
            .empty());
  CHECK(ReportWithBox("params: {n: 2, a: {choice: [1, 2, 3], weights: [1 .. 2, index, n], exact: "
                      "true}, b: {choice: [1, 2], weights: [n, 1], exact: false}}\n") ==
        Strings{"4:49 spec/not-constant: the weights of an exact choice must be constants (without "
                "`exact: true` they may be computed and drawn)",
                "4:57 spec/not-constant: the weights of an exact choice must be constants (without "
                "`exact: true` they may be computed and drawn)",
                "4:64 spec/not-constant: the weights of an exact choice must be constants (without "
                "`exact: true` they may be computed and drawn)"});
}

TEST_CASE("'exact' is true or false and stands beside 'choice'", "[value]") {
  CHECK(ReportWithBox("params: {a: {choice: [1, 2], exact: maybe}}\n") ==
        Strings{"4:37 spec/wrong-type: expected true or false, got 'maybe'"});
  CHECK(ReportWithBox("params: {a: {cycle: [1, 2], exact: true}}\n") ==
        Strings{"4:29 spec/unknown-key: unknown key 'exact' in a distribution ('exact' is only "
                "allowed with 'choice')"});
  CHECK(ReportWithBox("params: {a: {choice: [1, 2], exakt: true}}\n") ==
        Strings{"4:30 spec/unknown-key: unknown key 'exakt' in a distribution (did you mean "
                "'exact'?)"});
}

TEST_CASE("draws of a kind that does not fit the slot are refused", "[value]") {
  CHECK(ReportWithBox("mass: {bernoulli: 0.5}\n") ==
        Strings{"4:7 spec/wrong-type: expected a number, but 'bernoulli' draws true or false"});
  CHECK(ReportWithBox("total_size: {about: [0, 0, 1]}\n") ==
        Strings{"4:21 spec/wrong-type: 'about' draws 4 numbers, but 3 are expected here"});
}

TEST_CASE("four numbers are not always a colour or a quaternion", "[value]") {
  const auto with = [](const std::string& field) {
    return ReportWithBox("sites: [{name: s, " + field + "}]\n");
  };
  CHECK(with("rgba: {hsv: [1, 1, 1]}") == Strings{});
  CHECK(with("quat: {about: [0, 0, 1]}") == Strings{});
  CHECK(with("quat: {hsv: [1, 1, 1]}") ==
        Strings{"4:31 spec/wrong-type: 'quat' is not a colour ('hsv' makes red, green, blue and "
                "opacity, as for 'rgba')"});
  CHECK(with("rgba: {choice: [[1, 0, 0, 1], {about: [0, 0, 1]}]}").size() == 1);
  const std::string turned =
      " spec/wrong-type: 'axisangle' is not a quaternion (a random rotation is a quaternion, as "
      "for "
      "'quat')";
  CHECK(with("axisangle: random") == Strings{"4:30" + turned});
  CHECK(with("axisangle: {about: [0, 0, 1]}") == Strings{"4:38" + turned});
}

TEST_CASE("an error in an expression points into the expression", "[value]") {
  CHECK(ReportWithBox("params: {radius: 1}\nmass: 2 * radus\n")
            .at(0)
            .find("5:11 expr/unknown-name") == 0);
  CHECK(ReportWithBox("params: {radius: 1}\nmass: \"2 * radus\"\n")
            .at(0)
            .find("5:12 expr/unknown-name") == 0);
  CHECK(ReportWithBox("params: {radius: 1}\nmass: 1 .. 2 * radus\n")
            .at(0)
            .find("5:16 expr/unknown-name") == 0);
}

TEST_CASE("one mistake is one finding", "[value]") {
  CHECK(ReportWithBox("total_size: {a: 1}\n") ==
        Strings{"4:14 spec/unknown-key: unknown key 'a' in a distribution (the distributions are "
                "uniform, log_uniform, triangular, normal, log_normal, beta, exponential, poisson, "
                "integer, bernoulli, choice, cycle)"});
  CHECK(
      Load("mjforge: 1\nname: t\nparts: [{name: a, type: box, size: {a: 1}}]\n").Report().size() ==
      1);
  CHECK(Load("mjforge: 1\nname: t\nparts: [{name: a, type: box, size: radus}]\n").Report().size() ==
        1);
}

TEST_CASE("settings are kept as YAML that reads back the same", "[value]") {
  const std::string yaml =
      "mjforge: 1\nname: t\nparams: {a: 1, b: 2, s: x}\n"
      "parts: [{name: p, type: sphere, size: a}]\n";
  for (const std::string text :
       {"b * 2", "b .. 2 * b", "\"max(1, b)\"", "{choice: [1, 2 * b]}", "-3", "1e-3"}) {
    const Loaded first = Load(yaml, {{.name = "a", .text = text}});
    REQUIRE(first.spec != nullptr);
    const std::string kept = first.spec->settings.at(0).second;
    const Loaded second = Load(yaml, {{.name = "a", .text = kept}});
    REQUIRE(second.spec != nullptr);
    CHECK(second.spec->settings.at(0).second == kept);
    CHECK(second.spec->parameters[0].value.form.index() ==
          first.spec->parameters[0].value.form.index());
  }
}
