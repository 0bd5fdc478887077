// Tests of places: names, draws, order, bodies without room.

#include <algorithm>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "place_scene.h"

namespace mjforge::assemble {
namespace {

TEST_CASE("a placed body is fixed to the body with the region") {
  const Scene scene(Ball("name: a, place: {at: table.surface, uv: [1, -1], yaw: 90deg}"));
  const model::Body& a = scene.body("a");
  CHECK(a.parent == 1);
  CHECK(a.place_name == "table.surface");
  CHECK(a.X_PB.p.isApprox(Eigen::Vector3d(0.35, -0.25, 0.7)));
  CHECK(scene.placer.tries.size() == 1);
}

TEST_CASE("a free body is released where it was placed") {
  const Scene scene(Ball("name: a, joints: free, place: {at: table.surface, uv: [0, 0]}"));
  CHECK(scene.body("a").parent == -1);
  CHECK(scene.body("a").X_PB.p.isApprox(Eigen::Vector3d(1, 0, 0.7)));
}

TEST_CASE("a body whose own joints start elsewhere stands at its place at the start") {
  const Scene scene(
      Ball("name: a, joints: [{name: slide, type: slide, axis: [1, 0, 0], start: 0.2, ref: 0.1}, "
           "{name: turn, axis: [0, 0, 1], start: 90deg}], place: {at: table.surface, uv: [0, 0], "
           "yaw: 0}"));
  const model::Pose X_TableA = model::StartPose(scene.body("a"));
  CHECK(X_TableA.p.isApprox(Eigen::Vector3d(0, 0, 0.7)));
  CHECK(X_TableA.q.isApprox(Eigen::Quaterniond::Identity()));
}

TEST_CASE("a body hangs by its site at the site of another") {
  const Scene scene(
      "  - {name: a, place: {at: table.hook, by: hole}, sites: [{name: hole, pos: [0, 0, 0.1]}],\n"
      "     parts: [{name: ball, type: sphere, size: 0.05}]}\n");
  CHECK(scene.body("a").X_PB.p.isApprox(Eigen::Vector3d(0, 0.3, 0.5)));
}

TEST_CASE("an entry at the end moves none before it") {
  const std::string two = Ball("name: a, place: {at: table.surface}") +
                          Ball("name: b, place: {at: table.surface, yaw: -5deg .. 5deg}");
  for (std::uint64_t index = 0; index < 20; ++index) {
    const Scene before(two, index);
    const Scene after(two + Ball("name: c, place: {at: table.surface}"), index);
    for (const char* name : {"a", "b"}) {
      CHECK(before.body(name).X_PB.p == after.body(name).X_PB.p);
      CHECK(before.body(name).X_PB.q.coeffs() == after.body(name).X_PB.q.coeffs());
    }
  }
}

TEST_CASE("the seed of places redraws the places alone") {
  const std::string ball =
      "  - {name: a, place: {at: table.surface}, parts: [{name: ball, type: "
      "sphere, size: 0.01 .. 0.05}]}\n";
  const Scene first(ball);
  const Scene second(ball, 0, 7);
  CHECK(first.body("a").parts[0].shape.size == second.body("a").parts[0].shape.size);
  CHECK(first.body("a").X_PB.p != second.body("a").X_PB.p);
  CHECK(second.body("a").X_PB.p == Scene(ball, 0, 7).body("a").X_PB.p);
}

TEST_CASE("a body faces a body, a point or a direction") {
  const auto facing = [](const std::string& what) {
    const Scene scene(Ball("name: a, place: {at: table.surface, facing: " + what + "}"));
    CHECK_FALSE(scene.assembling.failed());
    return scene.placer.tries.at(0);
  };
  CHECK(facing("table").facing == Eigen::Vector2d(1, 0));
  CHECK(facing("thing").facing == Eigen::Vector2d(0, 0));
  CHECK(facing("[0.1, 2]").facing == Eigen::Vector2d(0.1, 2));
  CHECK(facing("[0, 2, 0]").direction == Eigen::Vector2d(0, 2));
  CHECK(facing("{choice: [table]}").facing == Eigen::Vector2d(1, 0));
}

TEST_CASE("every try has draws of its own") {
  const Scene scene(
      Ball("name: a, place: {at: table.surface}") +
      Ball("name: b, place: {at: table.surface, uv: [-0.1 .. 0.1, -0.1 .. 0.1], facing: a}") +
      Ball("name: c, place: {at: table.surface, uv: [-0.2 .. 0.2, -0.2 .. 0.2], lying: any}"));
  std::set<double> drawn;
  for (const model::PlaceTry& where : scene.placer.tries) drawn.insert(where.uv[0]);
  CHECK(scene.placer.tries.size() > 3);
  CHECK(drawn.size() == scene.placer.tries.size());
}

TEST_CASE("bodies that find no room are left out if the spec allows it") {
  const std::string many =
      "  - {name: \"a_${i}\", for: {i: 60}, fewer: true, place: {at: table.surface},\n"
      "     parts: [{name: \"ball_${i}\", type: sphere, size: 0.05}]}\n"
      "  - {name: last, place: {at: table.hook}, parts: [{name: last, type: sphere, size: 1}]}\n";
  const Scene scene(many);
  const model::Object& object = scene.assembling.object();
  CHECK(object.left_out.size() > 10);
  CHECK(object.left_out.size() < 50);
  CHECK(object.bodies.size() == 63 - object.left_out.size());
  CHECK(object.bodies.back().place_name == "table.hook");
  for (const model::Body& body : object.bodies) {
    CHECK(body.parent < static_cast<int>(&body - object.bodies.data()));
    CHECK(std::ranges::find(object.left_out, body.name) == object.left_out.end());
  }
}

TEST_CASE("what is beside a body that was left out is left out, too") {
  const std::string two =
      "  - {name: b, fewer: true, place: {at: table.surface, uv: [0, 0]}, parts: [{name: p, type: "
      "sphere, size: 1}]}\n"
      "  - {name: c, fewer: true, place: {at: table.surface, beside: {body: b, side: left}}, "
      "parts: [{name: q, type: sphere, size: 1}]}\n";
  const Scene scene(Ball("name: a, place: {at: table.surface, uv: [0, 0]}") + two);
  CHECK(scene.assembling.object().left_out == std::vector<std::string>{"thing_b", "thing_c"});
}

TEST_CASE("a nested spec places its own bodies") {
  const TemporaryFolder folder;
  folder.Write("tray.yaml",
               "mjforge: 1\nname: tray\nfront: [1, 0]\n"
               "regions: [{name: surface, type: box, size: [0.2, 0.2]}]\n"
               "parts: [{name: board, type: box, size: [0.2, 0.2, 0.01]}]\n"
               "bodies: [{name: cup, place: {at: surface, uv: [1, 1]}, "
               "parts: [{name: cup, type: sphere, size: 0.02}]}]\n");
  DiscPlacer placer;
  const Assembling scene(std::string(kTable) +
                             "  - {name: tray, spec: tray.yaml, place: {at: table.surface, uv: [0, "
                             "0], yaw: 0}}\n" +
                             Ball("name: b, place: {at: tray.surface, uv: [-1, 0]}"),
                         1, 0, folder.path(), {}, &placer);
  const std::vector<model::Body>& bodies = scene.object().bodies;
  REQUIRE(bodies.size() == 5);
  CHECK(bodies[2].name == "thing_tray");
  CHECK(bodies[2].front == Approx(1.5707963));
  CHECK(bodies[3].parent == 2);
  CHECK(bodies[3].X_PB.p.isApprox(Eigen::Vector3d(0.15, 0.15, 0)));
  CHECK(bodies[3].place_name == "tray.surface");
  CHECK(bodies[4].parent == 2);
}

TEST_CASE("findings of places") {
  const auto finding = [](const std::string& bodies) { return Scene(bodies).finding(); };
  CHECK(finding(Ball("name: a, place: {at: tabel.surface}")) ==
        "10:27 place of body 'a': no body 'tabel' (did you mean 'table'?)");
  CHECK(finding(Ball("name: a, place: {at: table.surfce}")) ==
        "10:27 place of body 'a': body 'table' has no region and no site 'surfce' (did you mean "
        "'surface'?)");
  CHECK(finding(Ball("name: a, place: {at: table.x}")) ==
        "10:27 place of body 'a': body 'table' has no region and no site 'x' (it has hook, "
        "surface)");
  CHECK(finding(Ball("name: a, place: {at: table}")) ==
        "10:27 place of body 'a': 'table' is a body, not a region or a site (such as table.hook)");
  CHECK(finding(Ball("name: a, place: {at: table.surface, facing: b}") +
                Ball("name: b, place: {at: table.surface}")) ==
        "10:50 body 'a' is placed before 'b' (write the entry of 'b' before that of 'a')");
  CHECK(finding(Ball("name: a, place: {at: table.surface, lying: upsidedown}")) ==
        "10:49 lying of body 'a' is 'upsidedown', in which the body is not stable (did you mean "
        "'upside_down'?)");
  CHECK(finding(Ball("name: a, place: {at: table.hook, uv: [0, 0]}")) ==
        "10:43 uv of body 'a' has no meaning at a site, which decides the pose");
  CHECK(finding(Ball("name: a, place: {at: table.surface, facing: [0, 0, 1]}")) ==
        "10:50 facing of body 'a' has no horizontal direction");
  CHECK(finding(Ball("name: a, place: {at: table.hook, by: hole}")) ==
        "10:43 place of body 'a': body 'a' has no region and no site 'hole' (give it one with "
        "`sites:`)");
  CHECK(finding(Ball("name: a, place: {at: table.surface, facing: a}")) ==
        "10:50 body 'a' faces itself");
  CHECK(finding(Ball("name: a, place: {at: table.surface, beside: {body: a, side: left}}")) ==
        "10:57 body 'a' is placed beside itself");
  CHECK(finding(Ball("name: a, place: {at: table.surface, uv: [0, 0], facing: table}")) ==
        "10:62 facing of body 'a' is the point at which the body stands (turn it by `yaw`)");
}

TEST_CASE("bodies of one entry name earlier ones") {
  const Scene scene(
      "  - {name: \"a_${i}\", for: {i: 2}, place: {at: table.surface, facing: \"a_${i + 1}\"},\n"
      "     parts: [{name: \"ball_${i}\", type: sphere, size: 0.05}]}\n");
  CHECK(scene.finding() ==
        "10:70 body 'a_0' is placed before 'a_1' (bodies of one entry find their places in the "
        "order of `for`: name an earlier one)");
  CHECK(scene.assembling.raw_findings()[0].notes.empty());
}

TEST_CASE("the reason is given if a variant lacks what its spec declares") {
  const std::string shelf =
      "  - {name: shelf, parts: [{name: s, type: sphere, size: 1}], sites: [{name: nail, if: "
      "false}],\n"
      "     regions: [{name: up, if: 1 > 2, size: [1, 1]}, {name: flat, type: auto},\n"
      "       {name: 'slot_${i}', for: {i: 0}, size: [1, 1]}, {name: here, size: [1, 1]}]}\n"
      "  - {name: lid, if: false, parts: [{name: l, type: sphere, size: 1}]}\n";
  const auto finding = [&](const std::string& at) {
    const Scene scene(shelf + Ball("name: a, place: {at: " + at + "}"));
    const auto& notes = scene.assembling.raw_findings()[0].notes;
    return scene.finding() +
           (notes.empty() ? "" : " | " + std::to_string(notes[0].mark.line) + notes[0].message);
  };
  const std::string no = "14:27 place of body 'a': body 'shelf' has no region and no site ";
  const std::string left_out = " (its `if` or `for` leaves it out in this variant)";
  CHECK(finding("shelf.up") == no + "'up'" + left_out + " | 11'up' is here");
  CHECK(finding("shelf.nail") == no + "'nail'" + left_out + " | 10'nail' is here");
  CHECK(finding("shelf.slot_0") == no + "'slot_0'" + left_out + " | 12'slot_0' is here");
  const std::string nothing =
      " (no level face was found: `area`, `height` or `margin` is too large, or nothing collides)";
  CHECK(finding("shelf.flat") == no + "'flat'" + nothing + " | 11'flat' is here");
  CHECK(finding("shelf.down") == no + "'down' (it has here)");
  CHECK(finding("lid.top") ==
        "14:27 place of body 'a': no body 'lid'" + left_out + " | 13'lid' is here");
}

TEST_CASE("what only leads to an inner body is no place") {
  const TemporaryFolder folder;
  folder.Write("desk.yaml",
               "mjforge: 1\nname: desk\nparts: [{name: top, type: sphere, size: 1}]\n"
               "bodies: [{name: drawer, parts: [{name: d, type: sphere, size: 1}],\n"
               "          regions: [{name: inside, if: false, size: [1, 1]}, {name: back, size: "
               "[1, 1]}]}]\n");
  const auto finding = [&](const std::string& at) {
    DiscPlacer placer;
    const Assembling scene(
        "bodies:\n  - {name: desk, spec: desk.yaml}\n" + Ball("name: a, place: {at: " + at + "}"),
        1, 0, folder.path(), {}, &placer);
    return scene.findings().at(0);
  };
  CHECK(finding("desk.drawer") ==
        "5:27 place of body 'a': 'desk.drawer' is a body, not a region or a site (such as "
        "desk.drawer.back)");
  CHECK(finding("desk.drawer.inside") ==
        "5:27 place of body 'a': body 'desk.drawer' has no region and no site 'inside' (its `if` "
        "or `for` leaves it out in this variant)");
}

TEST_CASE("a place at a faulty region is no second finding") {
  DiscPlacer placer;
  const Assembling scene(
      "bodies:\n"
      "  - {name: desk, regions: [{name: top, size: [a, 1]}], parts: [{name: d, type: sphere, "
      "size: "
      "1}]}\n" +
          Ball("name: b, place: {at: desk.top}") + "params: {a: -2 .. -1}\n",
      1, 0, {}, {}, &placer);
  CHECK(scene.findings() ==
        std::vector<std::string>{"4:47 size 1 of region 'top' is -1.032142; it must be greater "
                                 "than 0 (it is the value of 'a')"});
}

TEST_CASE("a name of a body that was left out is reported with the reason") {
  const auto finding = [](const std::string& entry) {
    const Scene scene(Ball("name: a, place: {at: table.surface, uv: [0, 0]}") +
                      Ball("name: b, fewer: true, place: {at: table.surface, uv: [0, 0]}") + entry);
    return scene.assembling.findings().at(0);
  };
  CHECK(finding("  - {name: c, parent: b, parts: [{name: q, type: sphere, size: 1}]}\n") ==
        "12:23 body 'c': its parent 'b' was left out, because there was no room for it (in place "
        "of `parent:`, `place:` at it and `fewer: true` leave out this one, too)");
  const std::string why = " (body 'b' found no room, and was left out (`fewer: true`))";
  CHECK(finding("contact: {exclude: [[a, b]]}\n") ==
        "12:25 body2 of exclude is 'b', but the object has no body of that name" + why);
  CHECK(finding("mjcf: {sensor: [{framepos: {name: s, objtype: site, objname: b_grip}}]}\n") ==
        "12:62 objname of framepos 's' is 'b_grip', but the object has no site of that name" + why);
  CHECK(finding("expect: [{apart: [a, b]}]\n") ==
        "12:22 the object has no body and no part 'b'" + why);
  CHECK(finding("pose: [{joint: b_joint0, velocity: [0, 0, 0, 0, 0, 1]}]\n") ==
        "12:8 pose: the object has no joint 'b_joint0'" + why);
}

TEST_CASE("entries of one pile agree on its order and time") {
  const auto findings = [](const std::string& first, const std::string& second) {
    const Scene scene(
        Ball("name: a, joints: free, place: {at: table.surface, pile: " + first + "}") +
        Ball("name: b, joints: free, place: {at: table.surface, pile: " + second + "}"));
    return scene.assembling.findings();
  };
  CHECK(findings("{time: 2s}", "{}").empty());
  CHECK(findings("{time: 2s, order: listed}", "{order: listed, time: 2s}").empty());
  const std::string hint = " here than where it begins (give it to the first entry of the pile)";
  CHECK(findings("{}", "{time: 5s}") ==
        std::vector<std::string>{"11:36 the pile in 'table.surface' has another `time`" + hint});
  CHECK(findings("{time: 2s}", "{order: listed}") ==
        std::vector<std::string>{"11:36 the pile in 'table.surface' has another `order`" + hint});
}

TEST_CASE("places that lead back to themselves are reported") {
  const std::string boxes =
      "  - {name: a, place: {at: b.top}, regions: [{name: top, type: disc, size: 1}], parts: "
      "[{name: p, type: sphere, size: 1}]}\n"
      "  - {name: b, place: {at: a.top}, regions: [{name: top, type: disc, size: 1}], parts: "
      "[{name: q, type: sphere, size: 1}]}\n"
      "  - {name: c, place: {at: c.top}, regions: [{name: top, type: disc, size: 1}], parts: "
      "[{name: r, type: sphere, size: 1}]}\n";
  CHECK(Scene(boxes).finding() ==
        "10:27 the places of bodies form a circle: a -> b -> a\n"
        "12:27 the places of bodies form a circle: c -> c");
  const auto beside = [](const std::string& name, const std::string& other) {
    return "  - {name: " + name + ", place: {at: table.surface, beside: {body: " + other +
           ", side: left}}, parts: [{name: p_" + name + ", type: sphere, size: 1}]}\n";
  };
  CHECK(Scene(beside("a", "b") + beside("b", "c") + beside("c", "a"))
            .finding()
            .find("the places of bodies form a circle: a -> b -> c -> a") != std::string::npos);
}

TEST_CASE("a tilted body with `regions: auto` is said to be tilted") {
  CHECK(
      Scene("  - {name: low, regions: auto, euler: [90, 0, 0], parts: [{name: slab, type: box, "
            "size: [1, "
            "1, 0.1]}]}\n"
            "  - {name: a, place: {at: low.surface}, parts: [{name: p, type: sphere, size: 1}]}\n")
          .finding()
          .find("no level face was found: 'low' is tilted by 116.6 degrees at the start") !=
      std::string::npos);
}

TEST_CASE("a body without room is reported with the sizes and what is in the way") {
  const std::string bodies = Ball("name: a, place: {at: table.surface, uv: [0, 0]}") +
                             Ball("name: b, place: {at: table.surface, uv: [0, 0], clear: 2cm}");
  CHECK(Scene(bodies).finding() ==
        "11:27 no room for body 'b' at its `uv` in 'table.surface', 80 x 60 cm: it needs 10 x 10 "
        "cm and 2 cm around it ('a' is in the way; make room, or leave out what finds none with "
        "`fewer: true`)");
  CHECK(Scene(Ball("name: a, place: {at: table.surface, uv: [0, 0]}") +
              Ball("name: b, place: {at: table.surface, beside: {body: a, side: right, gap: 1cm}}"))
            .finding() ==
        "11:27 no room for body 'b' beside 'a' at 'table.surface', 80 x 60 cm: it needs 10 x 10 cm "
        "('a' is in the way; make room, or leave out what finds none with `fewer: true`)");
}

}  // namespace
}  // namespace mjforge::assemble
