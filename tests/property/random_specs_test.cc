// Tests that variants and batches of randomly written specs are pure, over every part type, every
// role, nested specs, free bodies and conditions.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <initializer_list>
#include <random>
#include <set>
#include <string>

#include "batches.h"
#include "harness/effort.h"
#include "purity.h"

namespace mjforge::forge {
namespace {

/// Writes random specs, which may fail in some or all variants.
class SpecAuthor {
 public:
  explicit SpecAuthor(std::uint32_t seed) : random_(seed) {}

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
    const bool has_bodies = OneIn(2);
    if (has_bodies) text += Bodies();
    if (OneIn(6)) {
      text += "expect:\n  - bounds.x > y\n  - mass > c * x\n";
      text += "  - {gap: [first, p0], max: 10 * x}\n  - {apart: [p1, p2]}\n";
    }
    if (has_bodies && OneIn(2)) {
      text += "pose: {j: 0.005, k: {uniform: [0.2, 0.4]}}\n";
      text +=
          Pick({"", "start: zero\n", "start: keyframe\n", "start: {choice: [zero, keyframe]}\n"});
    }
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
    switch (random_() % 9) {
      case 0:
        text += ", type: box, size: [" + Number() + ", " + Number() + ", 0.02]";
        break;
      case 6:
        text += Turned();
        break;
      case 7:
        text += Pointed();
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

  // Returns a shape with convex pieces and drawn sizes.
  std::string Turned() {
    if (OneIn(2)) {
      return ", type: lathe, facets: 6, profile: [[0.01, 0], [" + Number() + ", 0.1], " +
             Pick({"[0.05, 0.2]]", "{for: {i: n}, at: [0.05, 0.2 + i / 10]}]"}) +
             Pick({", wall: 0.005", "", ", angle: '1 + 10 * x'"});
    }
    return ", type: tube, path: [[0, 0, 0], [0.3, 0, " + Number() + "], [0.2, " + Number() +
           ", 0.5]], radius: 0.03" +
           Pick({"", ", bend: 0.05", ", smooth: true", ", wall: 0.01", ", closed: true"});
  }

  std::string Pointed() {
    switch (random_() % 5) {
      case 0:
        return ", type: hull, points: [[0, 0, 0], [0.1, 0, 0], [0, " + Number() +
               ", 0], [0, 0, 0.1]]" + Pick({"", ", round: 0.005"});
      case 1:
        return ", type: mesh, file: tetrahedron.obj, scale: " + Number();
      case 2:
        return ", type: prism, height: " + Number() +
               ", polygon: [[0, 0], [0.6, 0], [0.6, 0.6], [0.2, 0.3], [0, 0.6]]" +
               Pick({"", ", round: 0.01", ", bevel: 0.002",
                     ", holes: [[[0.1, 0.1], [0.2, 0.1], [0.1, '0.1 + x']]]",
                     ", holes: [{axis: x, outlines: [[[0.1, 0], [0.2, 0], [x, 0.002]]]}]"});
      case 3:
        return ", type: box, size: [0.1, 0.1, " + Number() + "], round: 0.005" +
               Pick({"", ", round_collision: false"});
      default:
        return ", type: cylinder, size: [0.1, " + Number() + "], round: 0.005";
    }
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
    if (OneIn(3)) {
      text += "  - {name: loose, joints: free, pos: [1, 0, " + Number() + "],\n     parts: [" +
              "{name: l, type: ellipsoid, size: [0.02, x, y]}]}\n";
    }
    if (OneIn(2)) {
      text += "mjcf:\n  sensor: [{jointpos: {name: angle, joint: j, noise: " + Number() + "}}]\n";
    }
    return text;
  }

  std::mt19937 random_;
};

/// Returns the number of random specs: MJFORGE_RANDOM_SPECS, or a number that takes seconds.
int SpecCount() {
  const char* text = std::getenv("MJFORGE_RANDOM_SPECS");
  return text != nullptr ? std::atoi(text) : harness::Effort(200, 40);
}

/// Returns options that depend on the seed: target, validation, and treatment of invalid variants.
Options OptionsOf(std::uint32_t seed) {
  Options options = Seeded(seed);
  options.target = mjcf::Targets()[seed % mjcf::Targets().size()].target;
  if (seed % 4 == 0) options.validation = Validation::kLoad;
  if (seed % 3 == 1) options.on_invalid = OnInvalid::kSkip;
  // Rare, because an invalid variant is drawn a hundred times.
  if (seed % 16 == 3) options.on_invalid = OnInvalid::kResample;
  return options;
}

TEST_CASE("variants and batches of random specs are pure") {
  const SpecFolder written;
  const auto variants = static_cast<std::uint64_t>(harness::Effort(9, 3));
  std::set<std::string> covered;  // words that occur in specs with valid variants
  int compared = 0;               // batches
  int stopped = 0;                // batches that were stopped before their end
  const int count = SpecCount();
  for (int i = 0; i < count; ++i) {
    const auto seed = static_cast<std::uint32_t>(i);
    const std::string text = SpecAuthor(seed).Spec();
    INFO("seed " << seed << "\n" << text);
    Loaded loaded = written.Load(text);
    const Options options = OptionsOf(seed);
    if (ComparePure(loaded, options, 0, variants) == 0) continue;
    ++compared;
    stopped += batch::CompareBatches(loaded, options, variants, seed % 2 == 1) ? 1 : 0;
    for (const char* word :
         {"type: box",    "type: sphere",    "type: cylinder",  "type: capsule", "type: ellipsoid",
          "type: prism",  "type: lathe",     "type: tube",      "type: hull",    "type: mesh",
          "role: visual", "role: collision", "inner.yaml",      "joints: free",  "if: ",
          "for: ",        "start: zero",     "start: keyframe", "start: {",      "holes: ",
          "round: ",      "closed: "}) {
      if (text.find(word) != std::string::npos) covered.insert(word);
    }
  }
  if (count >= 200) CHECK(covered.size() == 22);
  CHECK(compared > count / 2);
  CHECK(stopped > compared / 2);
}

}  // namespace
}  // namespace mjforge::forge
