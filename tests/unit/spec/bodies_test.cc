#include <catch2/catch.hpp>

#include "loading.h"

namespace {

constexpr const char* kRod = "parts: [{name: rod, type: sphere, size: 0.1}]";

// The entries of `bodies:` begin at line 4.
Strings ReportBodies(const std::string& entries) {
  return Load("mjforge: 1\nname: t\nbodies:\n" + entries).Report();
}

}  // namespace

TEST_CASE("a body holds parts, a spec or an MJCF file, one of the three", "[bodies]") {
  CHECK(
      ReportBodies(std::string("- {name: a, ") + kRod + ", mjcf: a.xml}\n") ==
      Strings{"4:60 spec/conflict: 'mjcf' together with 'parts': a body has only one of the two"});
  CHECK(ReportBodies("- {name: a, params: {r: 1}}\n- {name: b, body: knob}\n") ==
        Strings{"4:13 spec/conflict: 'params' needs 'spec' in the same entry",
                "5:13 spec/conflict: 'body' needs 'mjcf' in the same entry"});
  CHECK(ReportBodies("- {name: a}\n- {parent: a}\n") ==
        Strings{"5:3 spec/missing-key: body without a 'name'"});
}

TEST_CASE("a spec needs parts or bodies", "[bodies]") {
  CHECK(Load("mjforge: 1\nname: t\n").Report() ==
        Strings{"1:1 spec/missing-key: spec without 'parts' or 'bodies'"});
}

TEST_CASE("parents come first, exist, and form a tree", "[bodies]") {
  CHECK(ReportBodies("- {name: a}\n- {name: b, parent: a}\n- {name: c, parent: t}\n").empty());
  CHECK(ReportBodies("- {name: lid}\n- {name: b, parent: lod}\n") ==
        Strings{"5:21 spec/bad-parent: no body 'lod' (did you mean 'lid'?)"});
  CHECK(ReportBodies("- {name: a, parent: b}\n- {name: b}\n") ==
        Strings{"4:21 spec/bad-parent: body 'b' comes after its child 'a' (put parents "
                "before children)"});
  CHECK(ReportBodies("- {name: a, parent: a}\n") ==
        Strings{"4:21 spec/bad-parent: body 'a' is its own parent"});
  CHECK(ReportBodies("- {name: a, parent: c}\n- {name: b, parent: a}\n- {name: c, parent: b}\n") ==
        Strings{"4:21 spec/bad-parent: the parents of bodies form a circle: a -> c -> b -> a"});
}

TEST_CASE("the second place of a bad parent is a note", "[bodies]") {
  const Loaded loaded = Load("mjforge: 1\nname: t\nbodies:\n- {name: a, parent: b}\n- {name: b}\n");
  REQUIRE(loaded.findings.size() == 1);
  REQUIRE(loaded.findings[0].notes.size() == 1);
  CHECK(loaded.findings[0].notes[0].mark.line == 5);
}

TEST_CASE("names of bodies are their own, and not the root's", "[bodies]") {
  CHECK(ReportBodies("- {name: a}\n- {name: a}\n") ==
        Strings{"5:10 spec/duplicate-name: two bodies are named 'a'"});
  CHECK(ReportBodies("- {name: t}\n") ==
        Strings{"4:10 spec/duplicate-name: body 't' has the name of the object, which its root "
                "body already has (an object has one root; give the body another name)"});
}

TEST_CASE("a body's properties can be used from its own pose on", "[bodies]") {
  const std::string a = std::string("- {name: a, ") + kRod + ", pos: [0, 0, -a.bottom]}\n";
  CHECK(ReportBodies(a + "- {name: b, pos: [a.half_x, a.half_y, a.radius + a.top], mass: a.mass}\n")
            .empty());
  CHECK(ReportBodies("- {name: b, pos: [0, 0, a.top]}\n" + a) ==
        Strings{"4:25 expr/unknown-name: unknown name 'a.top' (did you mean 'b.top'?)"});
  CHECK(ReportBodies(a + "- {name: b, pos: [0, 0, a.tip]}\n") ==
        Strings{"5:25 expr/unknown-name: unknown name 'a.tip' (did you mean 'a.top'?)"});
}

TEST_CASE("a body's joints are a list or one of two words", "[bodies]") {
  CHECK(ReportBodies("- {name: a, joints: none}\n").empty());
  CHECK(ReportBodies("- {name: a, joints: free}\n").empty());
  CHECK(
      ReportBodies("- {name: a, joints: fre}\n") ==
      Strings{"4:21 spec/bad-value: 'fre' is neither 'free', 'none' nor a list of joints (did you "
              "mean 'free'?)"});
}

TEST_CASE("contact: exclude takes pairs of names", "[bodies]") {
  const std::string bodies = "bodies: [{name: a}, {name: b}]\n";
  const auto report = [&](const std::string& contact) {
    return Load("mjforge: 1\nname: t\n" + bodies + contact).Report();
  };
  CHECK(report("contact: {exclude: [[a, b], {bodies: [a, t], if: 1 > 0}]}\n").empty());
  CHECK(report("contact: {exclude: [[a]]}\n") ==
        Strings{"4:21 spec/wrong-length: expected the names of two bodies: [BODY, BODY]"});
  CHECK(report("contact: {exclude: [{name: x}]}\n") ==
        Strings{"4:21 spec/missing-key: a pair without 'bodies'"});
  CHECK(report("contact: {exlude: []}\n") ==
        Strings{"4:11 spec/unknown-key: unknown key 'exlude' in a contact (did you mean "
                "'exclude'?)"});
}

TEST_CASE("mjcf: takes sections, elements and attributes that MuJoCo knows", "[bodies]") {
  const auto report = [](const std::string& mjcf) {
    return Load("mjforge: 1\nname: t\nbodies: [{name: a}]\nmjcf:\n  " + mjcf + "\n").Report();
  };
  CHECK(
      report("sensor: [{jointpos: {name: q, joint: hinge}}, {for: {i: 2}, clock: {name: 'c${i}'}}]")
          .empty());
  CHECK(report("option: {timestep: 1e-3, flag: {gravity: disable}}").empty());
  CHECK(report("tendon: [{fixed: {name: f, children: [{joint: {joint: a, coef: 1 .. 2}}]}}]")
            .empty());
  CHECK(report("senor: []") == Strings{"5:3 spec/unknown-key: MJCF of MuJoCo 2.2 has no section "
                                       "'senor' (did you mean 'sensor'?)"});
  CHECK(report("worldbody: []") ==
        Strings{"5:3 spec/unknown-key: section 'worldbody' has no place in a spec (use `parts:` "
                "and `bodies:`)"});
  CHECK(report("sensor: [{jointpo: {name: q}}]") ==
        Strings{"5:13 spec/unknown-key: MJCF of MuJoCo 2.2 has no element 'jointpo' in 'sensor' "
                "(did you mean "
                "'jointpos'?)"});
  CHECK(report("sensor: [{jointpos: {name: q, joynt: h}}]") ==
        Strings{"5:33 spec/unknown-key: unknown key 'joynt' in a jointpos (did you mean "
                "'joint'?)"});
  CHECK(report("sensor: [{jointpos: {joint: h}}]") ==
        Strings{"5:23 spec/missing-key: jointpos without a 'name'"});
  CHECK(report("contact: [{exclude: {body1: a, body2: t}}, {pair: {geom1: g, geom2: h, condim: "
               "{choice: [1, 3]}}}]") ==
        Strings{"5:82 spec/unnamed-draw: a draw in a 'pair' element without a name (draws are "
                "keyed by names; give it a 'name')"});
  CHECK(report("option: [1]") ==
        Strings{"5:11 spec/wrong-type: expected a mapping with the attributes of 'option', got a "
                "list"});
  CHECK(report("sensor: [{gyro: {name: a, site: s}, clock: {name: b}}]") ==
        Strings{"5:39 spec/conflict: 'clock' together with 'gyro': one element per entry"});
}

TEST_CASE("a place takes the place of a pose and a parent", "[bodies]") {
  CHECK(ReportBodies(std::string("- {name: a, place: {at: b.top, uv: [0, 0 .. 1], yaw: 3deg}, ") +
                     kRod + "}\n")
            .empty());
  CHECK(
      ReportBodies(std::string("- {name: a, pos: [0, 0, 1], place: {at: top}, ") + kRod + "}\n") ==
      Strings{"4:13 spec/conflict: 'pos' together with 'place': 'place' decides where the body "
              "is"});
  CHECK(ReportBodies("- {name: a, place: {uv: [0, 0]}}\n- {name: b, fewer: true}\n") ==
        Strings{"4:20 spec/missing-key: 'place' without 'at' (A region or a site of an earlier "
                "body: BODY.NAME, or BODY.INNER.NAME for a body inside the spec or file of BODY; "
                "NAME alone is one of the root body.)",
                "5:13 spec/conflict: 'fewer' needs 'place' in the same entry"});
  const Loaded scene = Load(
      "mjforge: 1\nname: t\nfront: [1, 0]\nbodies: [{name: a, place: {at: top, facing: [1, "
      "2]}}]\n");
  CHECK(scene.Report().empty());
  CHECK(scene.spec->has_place);
  CHECK(scene.spec->front);
}
