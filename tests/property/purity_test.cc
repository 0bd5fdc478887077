// Tests that a variant is a pure function of spec, seed and index: its file and record depend
// neither on the generator nor on earlier variants.

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "harness/effort.h"
#include "harness/source_folder.h"
#include "purity.h"

namespace mjforge::forge {
namespace {

/// Returns the number of valid variants, summed over all targets.
int CompareForTargets(Loaded& loaded, std::uint64_t seed, int count) {
  int valid = 0;
  for (const mjcf::TargetRules& rules : mjcf::Targets()) {
    Options options = Seeded(seed);
    options.target = rules.target;
    valid += ComparePure(loaded, options, 0, static_cast<std::uint64_t>(count));
  }
  return valid;
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

TEST_CASE("every bundled spec is pure for every target") {
  for (const auto& spec : BundledSpecs()) {
    Loaded loaded(spec);
    const int count = CasesOf(spec, 4);
    CHECK(CompareForTargets(loaded, 3, count) >= count);
  }
}

TEST_CASE("every sampler is pure") {
  for (const auto& spec : BundledSpecs()) {
    Loaded loaded(spec);
    for (const std::string_view name : sample::MethodNames()) {
      Options options = Seeded(11);
      options.sampler = *sample::FindMethod(name);
      options.batch = 16;
      ComparePure(loaded, options, 24, CasesOf(spec, 4));
    }
  }
}

TEST_CASE("MuJoCo's verdict is pure") {
  for (const auto& spec : BundledSpecs()) {
    Loaded loaded(spec);
    Options options = Seeded(4);
    options.validation = Validation::kLoad;
    ComparePure(loaded, options, 0, CasesOf(spec, 3));
  }
}

TEST_CASE("every golden spec is pure for every target") {
  for (const auto& spec : SpecsBelow("tests/golden/good")) {
    if (spec.filename() != "spec.yaml") continue;
    Loaded loaded(spec);
    CompareForTargets(loaded, 1, harness::Effort(20));
  }
}

TEST_CASE("many conditions, choices and counts are pure") {
  const SpecFolder written;
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
  CHECK(CompareForTargets(loaded, 9, 100) > 100);
}

TEST_CASE("functions, local values and chosen texts are pure") {
  const SpecFolder written;
  Loaded loaded = written.Load(
      "mjforge: 1\n"
      "name: local\n"
      "functions:\n"
      "  twice(x): 2 * x\n"
      "  shape(i): 'twice(h + i / 100) > 0.25 ? twice(h) / 4 : h / 2'\n"
      "params: {h: 0.1 .. 0.2, n: {integer: [1, 3]}, kind: {choice: [oak, pine]}}\n"
      "parts:\n"
      "  - for: {i: n}\n"
      "    name: p_${i}\n"
      "    let: {gap: 0.1 .. 0.3, wide: gap / 2, big: gap > 0.15, at: [gap, wide, 0],\n"
      "          word: {choice: [dark, light]}}\n"
      "    if: wide > 0.07 or i == 0\n"
      "    type: box\n"
      "    size: [shape(i), wide, 'big ? 0.1 : h']\n"
      "    pos: at\n"
      "    material: \"${kind == 'oak' ? word : 'light'}\"\n"
      "materials: {dark: {rgba: [0, 0, h, 1]}, light: {rgba: [1, 1, 1, 1]}}\n");
  CHECK(CompareForTargets(loaded, 4, 100) > 100);
}

TEST_CASE("lists and records are pure") {
  const SpecFolder written;
  written.Write(
      "inner.yaml",
      "mjforge: 1\n"
      "name: inner\n"
      "params: {w: [1, 2, 3, 4, 5], c: [a, b], s: {choice: [{n: p, l: 0.1}, {n: q, l: 0.2}]}}\n"
      "parts:\n"
      "  - {for: {i: len(w)}, name: 'r_${i}', type: sphere, size: 'w[i] / 10 + s.l'}\n"
      "  - {for: {k: c}, name: 'c_${k}', type: sphere, size: 'sum(w) / 100'}\n");
  Loaded loaded = written.Load(
      "mjforge: 1\n"
      "name: outer\n"
      "params:\n"
      "  n: {integer: [1, 3]}\n"
      "  w: {each: 0.1 .. 0.2, count: n}\n"
      "  o: {shuffle: w}\n"
      "  f: {sample: [1, 2], count: 1}\n"
      "  l: [1, 2, 3, 4, 5]\n"
      "  c: {shuffle: [red, green]}\n"
      "  s: {choice: [{n: p, l: 0.1 .. 0.2, m: [x, y]}, {n: q, l: 0.2, m: [z]}]}\n"
      "parts:\n"
      "  - {for: {i: n}, name: 'p_${i}', type: box, size: ['w[i]', 'o[i]', s.l],\n"
      "     pos: ['sum(w, i)', 'min(w)', 'max(w, 0.15)'], rgba: [\"c[0] == 'red' ? 1 : 0\", 0, 0, "
      "1]}\n"
      "  - {for: {x: f}, name: 'f_${x}', type: sphere, size: x / 10}\n"
      "  - {for: {v: l, k: s.m}, name: 'v_${k}_${v}', type: sphere, size: v * s.l}\n"
      "  - {name: '${c[0]}', type: sphere, size: 0.1}\n"
      "bodies:\n"
      "  - {name: b, spec: inner.yaml, params: {w: w, c: s.m, s: \"${n > 2 ? 'p' : 'q'}\"}}\n"
      "  - {name: d, spec: inner.yaml, params: {w: [s.l, 'w[0]'], c: {shuffle: [a, b]}}}\n"
      "  - {name: e, spec: inner.yaml, params: {w: {each: 1 .. n, count: n}, s.l: s.l}}\n");
  CHECK(CompareForTargets(loaded, 4, 100) > 100);
}

TEST_CASE("shared parameters and materials handed in are pure") {
  const SpecFolder written;
  written.Write(
      "fit.yaml",
      "mjforge: 1\n"
      "params: {gap: 0.01 .. 0.02, k: {choice: [{n: a, h: 0.1 .. 0.2}, {n: b, h: 0.3}]}}\n"
      "require: gap < 0.018\n");
  written.Write("peg.yaml",
                "mjforge: 1\n"
                "name: peg\n"
                "import: fit.yaml\n"
                "parts: [{name: shaft, type: cylinder, size: [0.1 - gap, k.h], material: body}]\n"
                "materials: {body: {rgba: [0.1 .. 1, 0, 0, 1], density: 500 .. 600}}\n");
  Loaded loaded = written.Load(
      "mjforge: 1\n"
      "name: board\n"
      "import: fit.yaml\n"
      "params: {a: 0 .. 1}\n"
      "require: a > 0.5\n"
      "materials: {oak: {rgba: [0, a, 0, 1], density: 700 + a}, pine: {density: {uniform: [1, "
      "2]}}}\n"
      "parts: [{name: plate, type: box, size: [1, gap, k.h], material: pine}]\n"
      "bodies:\n"
      "  - {name: p, spec: peg.yaml}\n"
      "  - {name: q, spec: peg.yaml, params: {gap: gap / 2},\n"
      "     materials: {body: \"${a > 0.7 ? 'oak' : 'pine'}\"}}\n");
  CHECK(CompareForTargets(loaded, 4, 100) > 100);
}

TEST_CASE("failing variants between good ones are pure") {
  const SpecFolder written;
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
    CHECK(ComparePure(loaded, options, 0, 100) > 5);
  }
}

TEST_CASE("what happens to be equal in some variants is shared in those only") {
  const SpecFolder written;
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
  CHECK(CompareForTargets(loaded, 5, 100) > 100);
}

TEST_CASE("what has no value in some variants is pure") {
  const SpecFolder written;
  Loaded loaded = written.Load(
      "mjforge: 1\n"
      "name: pegs\n"
      "params: {lidded: {choice: [true, false]}, a: 0.1 .. 0.2}\n"
      "bodies:\n"
      "  - {name: lid, if: lidded, spec: inner.yaml, params: {r: 0.1 * a}}\n"
      "  - name: base\n"
      "    parts:\n"
      "      - {name: 'peg_${i}', for: {i: 3}, type: sphere, size: 0.01,\n"
      "         pos: [1, i, 'lidded ? lid.top : a * (i + 1)']}\n"
      "  - {name: tip, parts: [{name: t, type: box, size: [0.1, 0.1, lid.r]}]}\n");
  CHECK(ComparePure(loaded, Seeded(6), 0, 100) > 5);
}

TEST_CASE("minus zero and numbers without end are pure") {
  const SpecFolder written;
  Loaded prisms = written.Load(
      "mjforge: 1\n"
      "name: prisms\n"
      "params: {a: {uniform: [-1, 1]}}\n"
      "parts:\n"
      "  - {name: p, type: prism, polygon: [[0 * a, 0], [1, 0], [0, 1]], height: 0.1}\n"
      "  - {name: q, type: prism, polygon: [[0, 0], [1, 0], [0, 1]], height: 0.1, pos: [2, 0, "
      "0]}\n");
  CHECK(ComparePure(prisms, Seeded(1), 0, 100) > 5);
  Loaded far = written.Load(
      "mjforge: 1\n"
      "name: far\n"
      "params: {big: {choice: [1.7e308, 0]}}\n"
      "parts:\n"
      "  - frame: {pos: [0, 0, big]}\n"
      "    parts: [{name: b, type: sphere, size: 0.1, pos: [0, 0, big]}]\n");
  Options options = Seeded(1);
  options.target = mjcf::Target::kScene;
  CHECK(ComparePure(far, options, 0, 100) > 5);
}

}  // namespace
}  // namespace mjforge::forge
