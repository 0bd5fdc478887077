// Tests that an object means the same with its start as zero configuration as with a keyframe.

#include <string>

#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "harness/random.h"
#include "harness/source_folder.h"
#include "harness/temporary_folder.h"
#include "start_states.h"

namespace mjforge::forge {
namespace {

const std::filesystem::path kSource = harness::SourceFolder();

// Compares one variant; returns the number of compared numbers.
int Compare(const std::filesystem::path& file, std::uint64_t index, double tolerance = 1e-9) {
  INFO(file << ", variant " << index);
  const StartForm keyframe(file, "keyframe", index);
  const StartForm zero(file, "zero", index);
  REQUIRE(keyframe.model);
  REQUIRE(zero.model);
  INFO(zero.variant.document.text);
  return CompareStartForms(*keyframe.model, *zero.model, tolerance);
}

TEST_CASE("a start at zero keeps poses, forces and constraints of difficult mechanisms") {
  for (const char* name :
       {"hinges", "slides", "balls", "equalities", "welds", "tendons", "actuators", "views"}) {
    const auto file = kSource / "tests/property/start_states" / (std::string(name) + ".yaml");
    CHECK(Compare(file, 0) > 1000);
  }
}

// Writes mechanisms whose bodies, joints, start positions and equalities are random.
class MechanismAuthor {
 public:
  explicit MechanismAuthor(unsigned seed) : random_(seed) {}

  std::string Spec() {
    text_ = "mjforge: 1\nname: any\n";
    if (random_.Integer(2) == 0) text_ += "joints: none\n";
    text_ += "parts: [{name: base, type: sphere, size: 2cm, mass: 1, role: visual}]\nbodies:\n";
    const int bodies = 2 + random_.Integer(4);
    for (int i = 0; i < bodies; ++i) AddBody(i);
    text_ += (pose_.empty() ? "pose: {" : pose_) + "}\nmjcf:\n  equality:\n";
    for (int i = 0; i + 1 < scalars_; ++i) {
      text_ += "    - {joint: {active: false, name: e" + std::to_string(i) + ", joint1: s" +
               std::to_string(i) + ", joint2: s" + std::to_string(i + 1) + ", polycoef: [" +
               Number(1) + ", " + Number(1) + ", " + Number(1) + ", " + Number(1) + ", " +
               Number(1) + "]}}\n";
    }
    for (const char* tag : {"weld", "connect"}) {
      text_ += "    - {" + std::string(tag) + ": {active: false, name: " + tag +
               ", body1: b0, body2: b" + std::to_string(bodies - 1) + ", anchor: " + Vector(0.1) +
               "}}\n";
    }
    text_ += "  tendon:\n    - {spatial: {name: rope, stiffness: 3, children: [";
    for (int i = 0; i < bodies; ++i)
      text_ += std::string(i > 0 ? ", " : "") + "{site: {site: t" + std::to_string(i) + "}}";
    return text_ + "]}}\n";
  }

 private:
  std::string Number(double size) { return std::to_string(random_.Uniform(-size, size)); }
  std::string Vector(double size) {
    return "[" + Number(size) + ", " + Number(size) + ", " + Number(size) + "]";
  }

  void AddBody(int i) {
    const std::string id = std::to_string(i);
    text_ += "  - name: b" + id + "\n";
    if (i > 0 && random_.Integer(4) > 0)
      text_ += "    parent: b" + std::to_string(random_.Integer(i)) + "\n";
    text_ += "    pos: " + Vector(0.3) + "\n    euler: " + Vector(2) + "\n    joints:\n";
    const int joints = 1 + random_.Integer(3);
    for (int k = 0; k < joints; ++k) AddScalar();
    if (random_.Integer(3) == 0) AddBall(id);
    text_ +=
        "    parts: [{name: p" + id + ", type: box, size: [3cm, 2cm, 1cm], pos: " + Vector(0.1) +
        ", mass: 0.3, role: visual}]\n    sites: [{name: t" + id + ", pos: " + Vector(0.2) + "}]\n";
  }

  void AddScalar() {
    const std::string name = "s" + std::to_string(scalars_++);
    text_ += "      - {name: " + name + ", type: " + (random_.Integer(3) > 0 ? "hinge" : "slide") +
             ", axis: " + Vector(1) + ", pos: " + Vector(0.1) + ", ref: " + Number(0.5) +
             ", stiffness: 2, springref: " + Number(1) + ", range: [-1, 1.5]}\n";
    if (random_.Integer(4) > 0) AddPosition(name, Number(1));
  }

  void AddBall(const std::string& id) {
    text_ += "      - {name: ball" + id + ", type: ball, pos: " + Vector(0.1) + "}\n";
    AddPosition("ball" + id, "[1, " + Number(1) + ", " + Number(1) + ", " + Number(1) + "]");
  }

  void AddPosition(const std::string& joint, const std::string& value) {
    pose_ += (pose_.empty() ? "pose: {" : ", ") + joint + ": " + value;
  }

  harness::Random random_;
  std::string text_;
  std::string pose_;
  int scalars_ = 0;
};

TEST_CASE("a start at zero keeps poses, forces and constraints of random mechanisms") {
  const harness::TemporaryFolder folder;
  const int count = harness::Effort(50);
  for (int i = 0; i < count; ++i) {
    const std::string text = MechanismAuthor(static_cast<unsigned>(i)).Spec();
    if (text.find("pose: {}") != std::string::npos) continue;
    INFO(text);
    // The ten digits of numbers in files are not enough for 1e-9 at the end of every chain.
    CHECK(Compare(folder.Write("spec.yaml", text), 0, 5e-9) > 1000);
  }
}

TEST_CASE("a start at zero keeps poses, forces and constraints of bundled objects") {
  for (const char* name : {"containers/cardboard_box", "electronics/laptop", "appliances/fridge",
                           "appliances/dishwasher", "appliances/oven"}) {
    for (int i = 0; i < harness::Effort(3, 1); ++i) {
      const auto file = kSource / "specs" / (std::string(name) + ".yaml");
      CHECK(Compare(file, static_cast<std::uint64_t>(i)) > 1000);
    }
  }
}

}  // namespace
}  // namespace mjforge::forge
