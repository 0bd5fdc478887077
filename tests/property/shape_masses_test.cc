// Tests of mass, centre of mass and inertia of every part type, in every role and with every
// rounding: MuJoCo computes the values of the record, and these depend on the solid alone.

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/spec/fields.h"
#include "purity.h"

namespace mjforge::forge {
namespace {

constexpr const char* kConcave = "[[0, 0], [0.6, 0], [0.6, 0.6], [0.2, 0.3], [0, 0.6]]";

/// A solid that a part can have, and the fields that change only how it collides.
struct Solid {
  std::string type;
  std::string fields;
  std::vector<std::string> collision_fields = {""};
};

std::vector<Solid> Solids() {
  const std::vector<std::string> rounded = {"", ", round_collision: false"};
  const std::string concave = std::string("height: 0.2, polygon: ") + kConcave;
  const std::string along_x = "{axis: x, outlines: [[[0.05, -0.02], [0.1, 0], [0.05, 0.02]]]}";
  const std::string bent = "path: [[0, 0, 0], [0.3, 0, 0.2], [0.2, 0.1, 0.5]], radius: 0.03";
  const std::string ring =
      "path: [[0, 0, 0], [0.3, 0, 0], [0.3, 0.3, 0]], radius: 0.02, closed: true";
  const std::string cup = "profile: [[0, 0], [0.2, 0], [0.3, 0.2]]";
  return {{"box", "size: [0.1, 0.2, 0.3]"},
          {"box", "size: [0.1, 0.2, 0.3], round: 0.02", rounded},
          {"box", "size: [0.1, 0.2, 0.3], holes: [" + along_x + ", [[0, 0], [0.05, 0], [0, 0.1]]]"},
          {"sphere", "size: 0.1"},
          {"cylinder", "size: [0.1, 0.2]"},
          {"cylinder", "size: [0.1, 0.2], round: 0.02", rounded},
          {"capsule", "size: [0.1, 0.2]"},
          {"ellipsoid", "size: [0.1, 0.2, 0.3]"},
          {"prism", "height: 0.2, polygon: [[0, 0], [0.5, 0], [0.1, 0.3]]"},
          {"prism", "height: 0.2, polygon: [[0, 0], [0.5, 0], [0.1, 0.3]], round: 0.02"},
          {"prism", concave},
          {"prism", concave + ", round: 0.02"},
          {"prism", concave + ", bevel: 0.01"},
          {"prism", concave + ", holes: [[[0.1, 0.1], [0.2, 0.1], [0.1, 0.2]]]"},
          {"prism", concave + ", holes: [" + along_x +
                        ", {axis: y, outlines: [[[0.2, -0.05], [0.3, -0.05], [0.2, 0.05]]]}]"},
          {"lathe", "profile: [[0, 0], [0.2, 0], [0.2, 0.3], [0, 0.3]]"},
          {"lathe", "profile: [[0.1, 0], [0.2, 0], [0.2, 0.3]]"},
          {"lathe", cup + ", wall: 0.01"},
          {"lathe", cup + ", wall: 0.01, angle: 2"},
          {"tube", "path: [[0, 0, 0], [0.1, 0.2, 0.3]], radius: 0.03"},
          {"tube", "path: [[0, 0, 0, 0.02], [0.1, 0.2, 0.3, 0.04]]"},
          {"tube", bent},
          {"tube", bent + ", bend: 0.05"},
          {"tube", bent + ", smooth: true"},
          {"tube", bent + ", wall: 0.01"},
          {"tube", ring},
          {"hull", "points: [[0, 0, 0], [0.1, 0, 0], [0, 0.2, 0], [0, 0, 0.3]]"},
          {"hull", "points: [[0, 0, 0], [0.1, 0, 0], [0, 0.2, 0], [0, 0, 0.3]], round: 0.01"},
          {"mesh", "file: tetrahedron.obj, scale: 0.2"}};
}

/// Largest differences, relative to mass, length and trace of the inertia. MuJoCo's principal axes
/// (mju_eig3) have errors up to 3e-6.
void CheckSame(const model::MassProperties& a, const model::MassProperties& b) {
  CHECK(a.mass == Approx(b.mass).epsilon(1e-8));
  CHECK((a.p_FCm - b.p_FCm).norm() < 1e-8);
  CHECK((a.I_Cm_F - b.I_Cm_F).norm() < 1e-5 * b.I_Cm_F.trace());
}

/// Returns the only body that has mass, as MuJoCo compiled it.
model::MassProperties Compiled(const Variant& variant) {
  engine::Engine engine;
  REQUIRE_FALSE(engine.SetAssets(variant.document.assets));
  const engine::Loaded loaded = engine.LoadText(variant.document.text);
  INFO(loaded.error);
  REQUIRE(loaded.model);
  model::MassProperties sum;
  for (int body = 1; body < loaded.model->nbody; ++body) {
    if (loaded.model->body_mass[body] < 1e-9) continue;
    REQUIRE(sum.mass == 0);
    sum = compiled::MassOf(*loaded.model, body);
  }
  return sum;
}

/// Makes the part for each target, and compares MuJoCo's values with the record, which it returns.
model::MassProperties CompareForTargets(const SpecFolder& written, const std::string& parts) {
  Loaded loaded = written.Load("mjforge: 1\nname: any\nparts:\n" + parts);
  Variant variant;
  for (const mjcf::TargetRules& rules : mjcf::Targets()) {
    INFO(parts << "target " << rules.name);
    Options options;
    options.target = rules.target;
    Generator(loaded.recipe, loaded.sources, options).Make(0, variant);
    for (const diag::Finding& finding : variant.findings) UNSCOPED_INFO(finding.message);
    REQUIRE(variant.ok());
    CheckSame(Compiled(variant), variant.record.mass_properties);
  }
  return variant.record.mass_properties;
}

TEST_CASE("MuJoCo computes the recorded mass of every shape in every role") {
  const SpecFolder written;
  const std::string place = ", pos: [0.1, 0.2, 0.3], euler: [0.4, 0.5, 0.6]";
  for (const auto& [type, fields, collision_fields] : Solids()) {
    std::vector<model::MassProperties> properties;
    for (const char* role : {"both", "collision", "visual"}) {
      for (const std::string& collision : collision_fields) {
        const std::string part = "  - {name: p, density: 700, type: " + type + ", role: " + role +
                                 place + ", " + fields + collision + "}\n";
        properties.push_back(CompareForTargets(written, part));
        CheckSame(properties.back(), properties.front());
      }
    }
  }
}

TEST_CASE("MuJoCo computes the recorded mass of shapes beside a sphere") {
  const SpecFolder written;
  for (const auto& [type, fields, collision_fields] : Solids()) {
    CompareForTargets(written,
                      "  - {name: s, type: sphere, size: 0.1, pos: [0, 1, 0]}\n"
                      "  - {name: p, mass: 2, role: collision, type: " +
                          type + ", " + fields + collision_fields.back() + "}\n");
  }
}

TEST_CASE("the masses of all part types are compared") {
  std::set<std::string> types;
  for (const Solid& solid : Solids()) types.insert(solid.type);
  const spec::FieldInfo* field = spec::kPartElement.Find(spec::Key::kType);
  REQUIRE(field != nullptr);
  std::set<std::string> words;
  std::istringstream text{std::string(field->words)};
  for (std::string word; text >> word;) words.insert(word);
  CHECK(types == words);
}

}  // namespace
}  // namespace mjforge::forge
