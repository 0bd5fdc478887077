// Tests of the grain of textures: how boxes are turned, and how pictures lie on what gets them from
// above.

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {
namespace {

using Eigen::Vector3d;

constexpr std::string_view kWood =
    "materials:\n"
    "  wood: {texture: {type: 2d, builtin: flat, mark: random}, texuniform: true, texrepeat: [20, "
    "4]}\n"
    "  speckled: {texture: {builtin: flat, mark: random}}\n"
    "parts:\n";

// Direction in the part's frame in which streaks run on a box: along its y, on its largest faces.
Vector3d GrainOf(const model::Part& part) { return part.X_BG.q * Vector3d::UnitY(); }

void CheckAxis(const Vector3d& found, int axis) {
  INFO(found.transpose());
  CHECK(std::abs(found[axis]) == Approx(1).epsilon(1e-12));
}

TEST_CASE("a board is turned so that its grain runs along its longest edge") {
  const Assembling thing(std::string(kWood) +
                         "- {name: a, type: box, size: [0.3, 0.2, 0.01], material: wood}\n"
                         "- {name: b, type: box, size: [0.01, 0.2, 0.3], material: wood}\n"
                         "- {name: c, type: box, size: [0.2, 0.01, 0.3], material: wood}\n"
                         "- {name: d, type: box, size: [0.2, 0.3, 0.01], material: wood}\n");
  constexpr std::array kLongest = {0, 2, 2, 1};
  for (std::size_t i = 0; i < kLongest.size(); ++i) {
    const model::Part& part = thing.body().parts[i];
    INFO(part.name);
    CHECK(part.shape.size == Vector3d(0.2, 0.3, 0.01));
    CheckAxis(GrainOf(part), kLongest[i]);
  }
  CHECK(thing.part("thing_d").X_BG.q.coeffs() == Eigen::Quaterniond::Identity().coeffs());
}

TEST_CASE("a post has its grain along z of its frame") {
  const Assembling thing(std::string(kWood) +
                         "- {name: a, type: box, size: [0.3, 0.02, 0.02], material: wood}\n");
  const model::Part& part = thing.part("thing_a");
  CHECK(part.shape.size == Vector3d(0.02, 0.02, 0.3));
  CheckAxis(part.X_BG.q * Vector3d::UnitZ(), 0);
}

TEST_CASE("the spec may name the axis of the grain") {
  const Assembling thing(
      std::string(kWood) +
      "- {name: a, type: box, size: [0.3, 0.2, 0.01], material: wood, grain: y}\n"
      "- {name: b, type: box, size: [0.3, 0.2, 0.01], material: wood, grain: z}\n"
      "- {name: c, type: box, size: [0.3, 0.2, 0.01], material: wood, grain: y, round: 1mm}\n"
      "- {name: d, type: box, size: [0.3, 0.2, 0.01], material: wood, euler: [0, 0, 90deg]}\n");
  CHECK(thing.part("thing_a").shape.size == Vector3d(0.3, 0.2, 0.01));
  CheckAxis(thing.part("thing_b").X_BG.q * Vector3d::UnitZ(), 2);  // end grain
  CheckAxis(GrainOf(thing.part("thing_c")), 1);
  CheckAxis(GrainOf(thing.part("thing_d")), 1);  // the longest edge, turned with the part
  CHECK(OnlyFinding(std::string(kWood) +
                    "- {name: a, type: prism, polygon: [[0, 0], [1, 0], [0, 1]], height: 1, "
                    "material: wood, grain: z}\n") ==
        "7:95 grain of part 'a' is z; that of a prism is along x or y (its texture is laid on from "
        "above)");
}

TEST_CASE("without a texture of type 2d nothing is turned") {
  const Assembling thing(
      std::string(kWood) +
      "- {name: a, type: box, size: [0.3, 0.2, 0.01], material: speckled, grain: y}\n"
      "- {name: b, type: box, size: [0.01, 0.2, 0.3]}\n");
  CHECK(thing.part("thing_a").shape.size == Vector3d(0.3, 0.2, 0.01));
  CHECK(thing.part("thing_b").shape.size == Vector3d(0.01, 0.2, 0.3));
}

TEST_CASE("a picture is turned on a prism that is longer along x") {
  const auto coordinates = [](const std::string& keys) {
    const Assembling thing(
        std::string(kWood) +
        "- {name: a, type: prism, polygon: [[0, 0], [0.4, 0], [0.4, 0.1], [0, 0.1]], "
        "height: 0.1, material: wood" +
        keys + "}\n");
    const auto& texcoords = thing.object().meshes.at(0)->mesh.texcoords;
    Eigen::AlignedBox2d box;
    for (std::size_t i = 0; i < 4; ++i) box.extend(texcoords.at(i));  // of the lower cap
    return Eigen::Vector2d(box.sizes());
  };
  // 20 and 4 repetitions a metre, of which MuJoCo shows half.
  CHECK((coordinates("") - Eigen::Vector2d(1, 0.8)).norm() < 1e-9);
  CHECK((coordinates(", grain: x") - Eigen::Vector2d(1, 0.8)).norm() < 1e-9);
  CHECK((coordinates(", grain: y") - Eigen::Vector2d(4, 0.2)).norm() < 1e-9);
}

}  // namespace
}  // namespace mjforge::assemble
