#include "mjforge/split/split.h"

#include <catch2/catch.hpp>

#include "harness/spec_object.h"

namespace mjforge::split {
namespace {

using Texts = std::vector<std::string>;

model::Object Scene(const std::string& body) { return harness::ObjectOf(body, "scene"); }

/// Parts of a scene, and the messages of the findings about them.
struct Result {
  std::vector<ScenePart> parts;
  Texts messages;
};
Result SplitOf(const model::Object& scene,
               const SplitOptions& options = {.prefix = true, .root = {}}) {
  Result result;
  diag::Findings findings;
  if (auto parts = Split(scene, options, findings)) result.parts = *std::move(parts);
  for (const diag::Finding& finding : findings) result.messages.push_back(finding.message);
  return result;
}

Texts NamesOf(const Result& result) {
  Texts names;
  for (const ScenePart& part : result.parts) names.push_back(part.object.name);
  return names;
}

constexpr const char* kTable =
    "joints: none\n"
    "bodies:\n"
    "  - {name: table, pos: [1, 0, 0], parts: [{name: table_top, type: box, size: [1, 1, 0.1]}],\n"
    "     sites: [{name: table_site}]}\n"
    "  - name: lid\n"
    "    parent: table\n"
    "    pos: [0, 0, 1]\n"
    "    joints: [{name: table_hinge, type: hinge, axis: [0, 1, 0], start: 90deg}]\n"
    "    parts: [{name: lid, type: box, size: [1, 1, 0.1]}]\n"
    "  - {name: ball, joints: free, pos: [1, 0, 3], parts: [{name: ball, type: sphere, size: "
    "0.1}]}\n";

TEST_CASE("an object begins at each free body and at each child of an empty root") {
  const Result result = SplitOf(Scene(kTable));
  CHECK(result.messages.empty());
  REQUIRE(NamesOf(result) == Texts{"table", "ball"});
  const ScenePart& table = result.parts[0];
  CHECK_FALSE(table.is_free);
  CHECK(table.X_WO.p == Eigen::Vector3d(1, 0, 0));
  CHECK(table.object.bodies[0].X_PB.p == Eigen::Vector3d(0, 0, 0));
  REQUIRE(table.object.bodies.size() == 2);
  CHECK(table.object.bodies[1].X_PB.p == Eigen::Vector3d(0, 0, 1));
  CHECK(table.object.bounds.aabb.max.z() == Approx(2));  // at its start
  CHECK(result.parts[1].is_free);
  CHECK(result.parts[1].X_WO.p == Eigen::Vector3d(1, 0, 3));
}

TEST_CASE("names have the prefix of their object, or none if the host adds it") {
  const model::Object scene = Scene(kTable);
  const Result with = SplitOf(scene);
  CHECK(with.parts[0].object.bodies[0].name == "table");
  CHECK(with.parts[0].object.bodies[0].parts[0].name == "table_top");
  CHECK(with.parts[0].object.bodies[1].name == "table_lid");
  const Result without = SplitOf(scene, {.prefix = false, .root = "object"});
  CHECK(without.parts[0].object.bodies[0].name == "object");
  CHECK(without.parts[0].object.bodies[0].parts[0].name == "top");
  CHECK(without.parts[0].object.bodies[1].joints[0].name == "hinge");
  // robosuite's copy would be `ball_visual`, which has its prefix already.
  CHECK(without.parts[1].object.bodies[0].parts[0].name == "_ball");
}

TEST_CASE("the frame of an object is that of its root at the start") {
  const Result result = SplitOf(
      Scene("joints: none\n"
            "bodies:\n"
            "  - {name: door, joints: [{name: h, type: hinge, pos: [1, 0, 0], start: 180deg}],\n"
            "     parts: [{name: leaf, type: box, size: [1, 0.1, 1]}]}\n"
            "  - {name: ball, joints: free, parts: [{name: ball, type: sphere, size: 0.1}]}\n"));
  REQUIRE(result.parts.size() == 2);
  const ScenePart& door = result.parts[0];
  CHECK(door.X_WO.p.isApprox(Eigen::Vector3d(2, 0, 0)));
  const model::Pose X_OB = model::BodyPoses(door.object)[0];
  CHECK(X_OB.p.norm() < 1e-15);
  CHECK(X_OB.q.angularDistance(Eigen::Quaterniond::Identity()) < 1e-15);
}

TEST_CASE("elements go to the object that they refer to, and those of several are left out") {
  const Result result =
      SplitOf(Scene(std::string(kTable) +
                    "mjcf:\n"
                    "  equality: [{weld: {name: glue, body1: table, body2: ball}}]\n"
                    "  actuator: [{motor: {name: table_motor, joint: table_hinge}}]\n"
                    "  sensor: [{clock: {name: time}}, {framepos: {name: ball_at, objtype: body, "
                    "objname: ball}},\n"
                    "           {actuatorfrc: {name: force, actuator: table_motor}}]\n"
                    "  option: {timestep: 1ms}\n"));
  CHECK(result.messages == Texts{"option belongs to the whole scene: it is only in placement.json",
                                 "weld 'glue' refers to several objects: it is left out",
                                 "clock 'time' belongs to the whole scene: it is left out"});
  const auto sensors = [&](std::size_t part) {
    return model::ElementsOf(result.parts[part].object, "sensor");
  };
  REQUIRE(sensors(0).size() == 1);
  CHECK(sensors(0)[0].name == "table_force");
  CHECK(sensors(0)[0].attributes[0].text == "table_motor");
  REQUIRE(sensors(1).size() == 1);
  CHECK(model::FindAttribute(sensors(1)[0].attributes, "objname")->text == "ball");
  CHECK(model::ElementsOf(result.parts[0].object, "actuator").size() == 1);
  CHECK(model::ElementsOf(result.parts[0].object, "option").empty());
}

TEST_CASE("objects have copies of the assets that they share, under their own names") {
  const Result result = SplitOf(Scene(
      "joints: none\n"
      "materials: {red: {rgba: [1, 0, 0, 1]}}\n"
      "bodies:\n"
      "  - {name: \"ring_${i}\", for: {i: 2}, joints: free, pos: [i, 0, 0], parts: [{material: "
      "red,\n"
      "     name: \"ring_${i}_rim\", type: lathe, profile: [[1cm, 0], [2cm, 0], [2cm, 1cm]]}]}\n"));
  CHECK(result.messages.empty());
  REQUIRE(NamesOf(result) == Texts{"ring_0", "ring_1"});
  const model::Object& ring = result.parts[1].object;
  CHECK(ring.materials.at(0).name == "ring_1_red");
  CHECK(ring.meshes.at(0)->name == "ring_1_rim");
  CHECK(ring.bodies[0].parts[0].shape.mesh == &ring.meshes[0]->mesh);
}

TEST_CASE("a scene of one object, and names that become equal, are findings") {
  CHECK(SplitOf(Scene("parts: [{name: a, type: sphere, size: 1}]\n")).messages ==
        Texts{"'scene' is one object, not a scene of several"});
  const Result result =
      SplitOf(Scene("joints: none\n"
                    "bodies:\n"
                    "  - {name: box, joints: free, parts: [{name: lid, type: sphere, size: 1},\n"
                    "     {name: box_lid, type: sphere, size: 1}]}\n"));
  CHECK(result.messages == Texts{"two parts of 'box' are named 'box_lid' in its own file"});
}

}  // namespace
}  // namespace mjforge::split
