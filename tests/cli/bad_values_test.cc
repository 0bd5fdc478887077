// Tests of specs that are valid YAML with invalid values.

#include "bad_input.h"

namespace mjforge {
namespace {

std::string WithPart(const std::string& part) {
  return "mjforge: 1\nname: crate\nparts:\n  - {" + part + "}\n";
}

std::string WithParameter(const std::string& parameter) {
  return "mjforge: 1\nname: crate\nparams:\n  r: " + parameter +
         "\nparts:\n  - {name: body, type: sphere, size: r}\n";
}

TEST_CASE_METHOD(BadInputTest, "an unknown key is one finding with a suggestion") {
  const auto result = Generate(WithPart("name: body, tpye: box, type: box, size: [1, 1, 1]"));
  CheckOneFinding(result, 1, "spec/unknown-key");
  CHECK(result.err.find("s.yaml:4:") == 0);
  CHECK(result.err.find("did you mean 'type'?") != std::string::npos);
}

TEST_CASE_METHOD(BadInputTest, "a wrong type is one finding") {
  CheckSpec(WithPart("name: body, type: box, size: [1, 1, 1], density: [1, 2]"), "spec/wrong-type");
  CheckSpec("mjforge: 1\nname: crate\nparts: 3\n", "spec/wrong-type");
}

TEST_CASE_METHOD(BadInputTest, "a reversed range is one finding") {
  CheckSpec(WithParameter("0.2 .. 0.1"), "spec/empty-range");
}

TEST_CASE_METHOD(BadInputTest, "a range that is reversed in a variant is one finding") {
  folder().Write("s.yaml",
                 "mjforge: 1\nname: crate\nparams:\n  a: 0.3 .. 0.4\n  r: a .. 0.2\n"
                 "parts:\n  - {name: body, type: sphere, size: r}\n");
  CheckOneFinding(Run({"generate", "s.yaml", "-o", "out"}), 1, "sample/empty-range");
}

TEST_CASE_METHOD(BadInputTest, "sizes of zero, below zero and NaN are one finding each") {
  CheckSpec(WithPart("name: body, type: sphere, size: 0"), "spec/bad-value");
  CheckSpec(WithPart("name: body, type: sphere, size: -1"), "spec/bad-value");
  CheckSpec(WithParameter("-1 .. -0.5"), "model/bad-value");
  CheckSpec(WithParameter("1 - 1"), "model/bad-value");
  CheckSpec(WithParameter("0 / 0"), "expr/not-finite");
  CheckSpec(WithParameter("sqrt(-1)"), "expr/not-finite");
}

TEST_CASE_METHOD(BadInputTest, "a missing material is one finding") {
  CheckSpec(WithPart("name: body, type: box, size: [1, 1, 1], material: oak"),
            "spec/unknown-material");
}

TEST_CASE_METHOD(BadInputTest, "a cycle of parameters is one finding that prints it") {
  const auto result = Generate(
      "mjforge: 1\nname: crate\nparams: {a: b + 1, b: c + 1, c: a + 1}\n"
      "parts: [{name: body, type: sphere, size: a}]\n");
  CheckOneFinding(result, 1, "spec/cycle");
}

TEST_CASE_METHOD(BadInputTest, "a thousand million parts are one finding") {
  CheckSpec(WithPart("name: 'p${i}', type: sphere, size: 1, for: {i: 1e9}"),
            "model/too-many-parts");
  CheckSpec(WithPart("name: 'p${i}_${j}', type: sphere, size: 1, for: {i: 100000, j: 100000}"),
            "model/too-many-parts");
}

TEST_CASE_METHOD(BadInputTest, "names that could leave the folder or break the file are refused") {
  for (const char* name : {"a/b", "../up", "..", "\"a\\\"b\"", "'a b'", "\"a\\nb\"", "'a<b'"}) {
    CheckSpec("mjforge: 1\nname: " + std::string(name) +
                  "\nparts: [{name: body, type: sphere, size: 1}]\n",
              "spec/bad-name");
    CheckSpec(WithPart("name: " + std::string(name) + ", type: sphere, size: 1"), "spec/bad-name");
  }
}

TEST_CASE_METHOD(BadInputTest, "all mistakes of a file are reported in one run, in file order") {
  const auto result = Generate(
      "mjforge: 1\nname: crate\nparts:\n"
      "  - {name: a, type: box, size: [1, 1, 1], colour: red}\n"
      "  - {name: b, type: bux, size: [1, 1, 1]}\n"
      "  - {name: c, type: sphere, size: -1}\n");
  CHECK(result.status == 1);
  CHECK(CountOf(result.err, " error: ") == 3);
  const std::size_t first = result.err.find("s.yaml:4:");
  const std::size_t second = result.err.find("s.yaml:5:");
  const std::size_t third = result.err.find("s.yaml:6:");
  CHECK(first == 0);
  CHECK((first < second && second < third && third != std::string::npos));
}

TEST_CASE_METHOD(BadInputTest, "after fifty findings only their number is said") {
  std::string text = "mjforge: 1\nname: crate\nparts:\n";
  for (int i = 0; i < 60; ++i) {
    text += "  - {name: p" + std::to_string(i) + ", type: sphere, size: -1}\n";
  }
  const auto result = Generate(text);
  CHECK(result.status == 1);
  CHECK(CountOf(result.err, " error: ") == 50);
  CHECK(result.err.ends_with("\nand 10 more\n"));
}

TEST_CASE_METHOD(BadInputTest, "requirements that never hold are one finding") {
  CheckSpec(
      "mjforge: 1\nname: crate\nparams: {r: 0.1 .. 0.2}\nrequire: [r > 1]\n"
      "parts: [{name: body, type: sphere, size: r}]\n",
      "sample/rejected");
}

TEST_CASE_METHOD(BadInputTest, "a setting of an unknown parameter is one finding") {
  folder().Write("s.yaml", WithParameter("0.1 .. 0.2"));
  CheckOneFinding(Run({"generate", "s.yaml", "-o", "out", "--set", "q=1"}), 1,
                  "spec/unknown-parameter");
}

TEST_CASE_METHOD(BadInputTest, "an object that MuJoCo refuses is neither written nor printed") {
  folder().Write("s.yaml",
                 "mjforge: 1\nname: speck\nparts:\n"
                 "  - {name: body, type: sphere, size: 1um, mass: 1e-9}\n");
  CheckOneFinding(Run({"generate", "s.yaml", "-q", "-MD", "-o", "x.xml"}), 1, "mujoco/error");
  CheckOneFinding(Run({"generate", "s.yaml", "-q", "-o", "-"}), 1, "mujoco/error");
  CHECK(folder().Files() == std::vector<std::string>{"s.yaml"});
}

}  // namespace
}  // namespace mjforge
