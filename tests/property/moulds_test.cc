// A variant from a mould has the bytes of the same variant from the spec: file, record, findings,
// and the object's own numbers.

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "harness/source_folder.h"
#include "harness/temporary_folder.h"
#include "mjforge/forge/forge.h"

namespace mjforge::forge {
namespace {

struct Loaded {
  explicit Loaded(const std::filesystem::path& file) {
    diag::Findings findings;
    spec::LoadOptions options;
    options.search_path = {harness::SourceFolder() / "specs"};
    auto loaded = LoadRecipe(file, options, sources, findings);
    std::string said;
    for (const diag::Finding& finding : findings) said += finding.message + "\n";
    INFO(file << ": " << said);
    REQUIRE(loaded);
    recipe = std::move(*loaded);
  }

  diag::Sources sources;
  Recipe recipe;
};

std::string RecordOf(const Variant& variant) {
  std::string line;
  manifest::AppendRecord(line, variant.record);
  return line;
}

/// What is written of the object now; it follows the text only if all its numbers do.
std::string WrittenAgain(const Variant& variant, const Recipe& recipe, const Options& options) {
  mjcf::Provenance provenance = variant.record;
  if (provenance.name == recipe.spec->name) provenance.name.clear();
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(*variant.object, options.target, provenance, document);
  return document.text;
}

/// Makes the variants both ways; returns how many came from a mould.
int Compare(Loaded& loaded, Options options, std::uint64_t first, std::uint64_t count) {
  Generator generator(loaded.recipe, loaded.sources, options);
  options.moulds = false;
  Generator plain(loaded.recipe, loaded.sources, options);
  Variant variant;
  Variant expected;
  int moulded = 0;
  for (std::uint64_t index = first; index < first + count; ++index) {
    INFO(loaded.recipe.reference << ", target " << mjcf::RulesOf(options.target).name << ", index "
                                 << index);
    generator.Make(index, variant);
    plain.Make(index, expected);
    moulded += variant.mould > 0;
    REQUIRE(RecordOf(variant) == RecordOf(expected));
    if (!expected.ok()) continue;
    REQUIRE(variant.document.text == expected.document.text);
    REQUIRE(variant.document.size_position == expected.document.size_position);
    REQUIRE(variant.document.world_position == expected.document.world_position);
    REQUIRE(variant.document.lift == expected.document.lift);
    REQUIRE(variant.document.assets == expected.document.assets);
    REQUIRE(variant.document.origins == expected.document.origins);
    REQUIRE(WrittenAgain(variant, loaded.recipe, options) == expected.document.text);
  }
  return moulded;
}

Options Seeded(std::uint64_t seed) {
  Options options;
  options.seed = seed;
  options.validation = Validation::kNone;
  return options;
}

std::vector<std::filesystem::path> SpecsBelow(const std::string& folder) {
  std::vector<std::filesystem::path> specs;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(harness::SourceFolder() / folder)) {
    if (entry.path().extension() == ".yaml") specs.push_back(entry.path());
  }
  REQUIRE(specs.size() > 15);
  return specs;
}

bool IsLibrary(const std::filesystem::path& spec) { return spec.filename() == "materials.yaml"; }

TEST_CASE("every bundled spec is the same from moulds, for every target") {
  for (const auto& spec : SpecsBelow("specs")) {
    if (IsLibrary(spec)) continue;
    Loaded loaded(spec);
    for (const mjcf::TargetRules& rules : mjcf::Targets()) {
      Options options = Seeded(3);
      options.target = rules.target;
      INFO(spec << " for " << rules.name);
      CHECK(Compare(loaded, options, 0, 100) > 10);
    }
  }
}

TEST_CASE("every sampler is the same from moulds") {
  for (const auto& spec : SpecsBelow("specs")) {
    if (IsLibrary(spec)) continue;
    Loaded loaded(spec);
    for (const std::string_view name : sample::MethodNames()) {
      Options options = Seeded(11);
      options.sampler = *sample::FindMethod(name);
      options.batch = 40;
      Compare(loaded, options, 60, 40);
    }
  }
}

TEST_CASE("what MuJoCo says is the same of variants from moulds") {
  for (const auto& spec : SpecsBelow("specs")) {
    if (IsLibrary(spec)) continue;
    Loaded loaded(spec);
    Options options = Seeded(4);
    options.validation = Validation::kLoad;
    Compare(loaded, options, 0, 12);
  }
}

TEST_CASE("every golden spec is the same from moulds, for every target") {
  for (const auto& spec : SpecsBelow("tests/golden/good")) {
    if (spec.filename() != "spec.yaml") continue;
    Loaded loaded(spec);
    for (const mjcf::TargetRules& rules : mjcf::Targets()) {
      Options options = Seeded(1);
      options.target = rules.target;
      Compare(loaded, options, 0, 60);
    }
  }
}

// Specs in a folder of their own, with one that they may bring.
class Written {
 public:
  Written() {
    folder_.Write("inner.yaml",
                  "mjforge: 1\n"
                  "name: inner\n"
                  "params: {r: 0.01 .. 0.05, long: {choice: [true, false]}, h: 3 * r,\n"
                  "         what: {choice: [box, sphere]}}\n"
                  "require: ['r + h < 0.17']\n"
                  "joints: none\n"
                  "parts:\n"
                  "  - {name: a, type: sphere, size: r}\n"
                  "  - {name: b, if: long, type: cylinder, size: [r, h],\n"
                  "     pos: [0, 0, {uniform: [h, 2 * h]}]}\n");
  }
  Loaded Load(const std::string& text) const { return Loaded(folder_.Write("spec.yaml", text)); }

 private:
  harness::TemporaryFolder folder_;
};

TEST_CASE("many conditions, choices and counts are the same from moulds") {
  const Written written;
  Loaded loaded = written.Load(
      "mjforge: 1\n"
      "name: wild\n"
      "params:\n"
      "  a: {choice: [true, false]}\n"
      "  b: {bernoulli: 0.3}\n"
      "  n: {integer: [0, 4]}\n"
      "  kind: {choice: [box, cylinder, ellipsoid], weights: [1, 2, 3]}\n"
      "  t: {cycle: [1, 2, 3]}\n"
      "  size: [0.01 .. 0.1, 0.02, 0.03 .. 0.05]\n"
      "require: ['n > 0 || a', 'size.x > 0.02']\n"
      "parts:\n"
      "  - {name: base, type: box, size: size, quat: random}\n"
      "  - {name: 'row_${i}', for: {i: n}, type: sphere, size: 0.01 * (i + t), pos: [i, 0, t]}\n"
      "  - {name: odd, if: a && kind != 'cylinder', type: '${kind}', size: [0.1, 0.2, 0.3],\n"
      "     role: visual}\n"
      "  - {name: c, if: size.z > 0.04, type: capsule, size: 0.01,\n"
      "     fromto: [0, 0, 0, size.x, 0, {normal: [1, 0.1]}], rgba: {hsv: [0 .. 1, 0.5, 1]}}\n"
      "  - {name: d, if: b, type: box, size: [0.02 * t, 0.1, 0.1],\n"
      "     density: {choice: [100, 200]}}\n");
  for (const mjcf::TargetRules& rules : mjcf::Targets()) {
    Options options = Seeded(9);
    options.target = rules.target;
    CHECK(Compare(loaded, options, 0, 400) > 20);
  }
}

TEST_CASE("failing variants between good ones are the same from moulds") {
  const Written written;
  Loaded loaded = written.Load(
      "mjforge: 1\n"
      "name: unlucky\n"
      "params: {r: -0.02 .. 0.1, x: {integer: [0, 3]}, w: {choice: [1, -1], weights: [5, 1]}}\n"
      "parts:\n"
      "  - {name: a, type: sphere, size: r}\n"
      "  - {name: b, type: box, size: [0.1 / x, 0.1, 0.1], pos: [0, 0, {uniform: [r, 0.08]}]}\n"
      "  - {name: c, type: box, size: [0.1, 0.1, 0.1], rgba: [1, 0, 0, r * 10],\n"
      "     mass: {choice: [1, 2], weights: [w, 2]}}\n");
  for (const OnInvalid on_invalid : {OnInvalid::kFail, OnInvalid::kSkip, OnInvalid::kResample}) {
    Options options = Seeded(2);
    options.on_invalid = on_invalid;
    CHECK(Compare(loaded, options, 0, 300) > 50);
  }
}

TEST_CASE("what happens to be equal in some variants is shared in those only") {
  const Written written;
  Loaded loaded = written.Load(
      "mjforge: 1\n"
      "name: twins\n"
      "params: {h: {integer: [1, 3]}, k: {integer: [1, 3]}, s: {integer: [1, 2]}}\n"
      "materials:\n"
      "  paint: {rgba: [1, 0, 0, 0.25 * h]}\n"
      "parts:\n"
      "  - {name: a, type: prism, polygon: [[0, 0], [1, 0], [0, 1]], height: h, material: paint}\n"
      "  - {name: b, type: prism, polygon: [[0, 0], [1, 0], [0, 1]], height: k, pos: [2, 0, 0]}\n"
      "  - {name: c, type: prism, polygon: [[0, 0], [s, 0], [0, s]], height: 1, pos: [4, 0, 0]}\n"
      "  - {name: d, type: cylinder, size: [h, 1], pos: [8, 0, 0]}\n"
      "  - {name: e, type: cylinder, size: [k, s], pos: [12, 0, 0]}\n");
  for (const mjcf::TargetRules& rules : mjcf::Targets()) {
    Options options = Seeded(5);
    options.target = rules.target;
    CHECK(Compare(loaded, options, 0, 200) > 100);
  }
}

/// Writes specs at random. What they say may well fail in some variants, or in all.
class Author {
 public:
  explicit Author(std::uint32_t seed) : random_(seed) {}

  std::string Spec() {
    std::string text =
        "mjforge: 1\n"
        "name: any\n"
        "params:\n"
        "  x: 0.02 .. 0.06\n"
        "  y: {choice: [0.01, 0.03, x]}\n"
        "  n: {integer: [1, 3]}\n"
        "  on: {bernoulli: 0.7}\n"
        "  kind: {choice: [box, ellipsoid]}\n"
        "  v: [x, 0.03, 0.02 .. 0.05]\n"
        "  c: 0.04\n";
    if (OneIn(3)) text += Pick({"require: [x + y > 0.04]\n", "require: [n > 1 || on]\n"});
    if (OneIn(4)) text += "placement: corner\ntotal_size: [1, 1, " + Number() + "]\n";
    if (OneIn(4)) text += "mass: " + Number() + "\n";
    text += "materials:\n  m: {density: 10000 * x, rgba: [1, " + Number() + ", 0.5, 1]}\n";
    text += "  k: {friction: [" + Number() + "]}\n";
    text += "parts:\n  - {name: first, type: sphere, size: 0.05}\n";
    for (int i = 0; i < 4; ++i) text += Part("p" + std::to_string(i), "  ");
    if (OneIn(2)) text += Bodies();
    return text;
  }

 private:
  bool OneIn(int n) { return random_() % static_cast<std::uint32_t>(n) == 0; }

  std::string Pick(std::initializer_list<const char*> from) {
    return from.begin()[random_() % from.size()];
  }

  std::string Number() {
    return Pick({"0.03", "x", "y", "c", "'0.5 * x + 0.01'", "v.z", "{uniform: [0.01, 0.04]}",
                 "{uniform: [0.01, x]}", "{choice: [0.02, 0.05]}", "'max(x, y)'",
                 "'x > 0.04 ? 0.02 : 0.05'", "{normal: [0.05, 0.03]}", "'0.01 * n'",
                 "{log_uniform: [0.01, v.z]}", "'x * x / (y - c)'"});
  }

  std::string Place() {
    const std::string pos = Pick({"v", "{on_sphere: 0.3}", "[0, 0, 0.1]"});
    return ", pos: " + (OneIn(2) ? pos : "[" + Number() + ", 0, " + Number() + "]") +
           Pick({"", "", ", quat: random", ", euler: [0, x, y]", ", quat: [1, 0, 0, 0]",
                 ", axisangle: [0, 0, 1, '10 * x']", ", zaxis: [0, x, 1]",
                 ", quat: {about: [0, 0, 1]}", ", xyaxes: [1, 0, 0, 0, 1, y]"});
  }

  std::string Part(const std::string& name, const std::string& indent) {
    std::string text = indent + "- {name: " + name;
    if (OneIn(3))
      text += Pick({", if: on", ", if: x > 0.03", ", if: kind == 'box'", ", if: y < x"});
    switch (random_() % 7) {
      case 0:
        text += ", type: box, size: [" + Number() + ", " + Number() + ", 0.02]";
        break;
      case 1:
        text += ", type: '${kind}', size: v";
        break;
      case 2:
        text += ", type: cylinder, size: " + Number() + ", fromto: [0, 0, 0, 0, " + Number() +
                ", 0.2]" + Look();
        return text + "}\n";
      case 3:
        text += ", type: prism, polygon: [[0, 0], [" + Number() + ", 0], [0.01, " + Number() +
                "]], height: " + Number() + ", scale: " + Number();
        break;
      case 4:
        text += ", spec: inner.yaml, params: {r: " + Number() + "}" + Place();
        return text + "}\n";
      case 5:
        text = indent + "- {name: '" + name + "_${i}', for: {i: n}, type: capsule, size: [" +
               Number() + ", '0.01 * (i + 1)']";
        break;
      default:
        text += ", type: sphere, size: " + Number();
    }
    return text + Place() + Look() + "}\n";
  }

  std::string Look() {
    std::string text = Pick({"", ", material: m", ", material: k", ", density: '20000 * y'",
                             ", mass: x", ", role: visual", ", role: collision"});
    if (OneIn(3)) text += ", rgba: {hsv: [" + Number() + ", 0.5, 1]}";
    if (OneIn(3)) text += ", margin: {choice: [0, 0.001]}, condim: {choice: [3, 4]}";
    return text;
  }

  std::string Bodies() {
    std::string text =
        "bodies:\n"
        "  - name: arm\n"
        "    pos: [0, 0, " +
        Number() +
        "]\n"
        "    parts:\n" +
        Part("q", "      ") +
        "      - {name: end, type: sphere, size: 0.02}\n"
        "    joints:\n"
        "      - {name: j, type: hinge, axis: [0, " +
        Number() + ", 1], range: [0, " + Number() + "], damping: " + Number() +
        "}\n"
        "    sites: [{name: s, size: " +
        Number() + ", pos: [0, 0, " + Number() +
        "]}]\n"
        "  - {name: hand, parent: arm, pos: [0, 0, 'arm.top + arm.half_x'], mass: " +
        Number() +
        ",\n     parts: [{name: f, type: box, size: [0.01, 0.01, arm.radius]}],\n"
        "     joints: [{name: k, type: slide, range: [" +
        Number() + ", 0.5]}]}\n";
    if (OneIn(2)) text += "  - {name: more, spec: inner.yaml, params: {r: " + Number() + "}}\n";
    if (OneIn(2)) {
      text += "mjcf:\n  sensor: [{jointpos: {name: angle, joint: j, noise: " + Number() + "}}]\n";
    }
    return text;
  }

  std::mt19937 random_;
};

TEST_CASE("random specs are the same from moulds") {
  const Written written;
  int moulded = 0;
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    const std::string text = Author(seed).Spec();
    INFO(text);
    Loaded loaded = written.Load(text);
    Options options = Seeded(seed);
    options.target = mjcf::Targets()[seed % mjcf::Targets().size()].target;
    if (seed % 3 == 0) options.on_invalid = OnInvalid::kResample;
    moulded += Compare(loaded, options, 0, 40);
  }
  CHECK(moulded > 1000);
}

}  // namespace
}  // namespace mjforge::forge
