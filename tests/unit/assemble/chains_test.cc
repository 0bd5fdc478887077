// Tests of `chain:`: links, their joints, names and draws.

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {

TEST_CASE("a chain is a row of links, each at the end of the one before") {
  const Assembling thing(
      "parts: [{name: hook, type: sphere, size: 1cm}]\n"
      "bodies:\n"
      "- {name: rope, pos: [1, 0, 0], chain: {links: 3, length: 60cm, range: 1, damping: 0.1},\n"
      "   parts: [{name: link, type: sphere, size: 1cm}], sites: [{name: middle}]}\n");
  const std::vector<model::Body>& bodies = thing.object().bodies;
  REQUIRE(bodies.size() == 4);
  for (int i = 0; i < 3; ++i) {
    const model::Body& link = bodies[static_cast<std::size_t>(i) + 1];
    CHECK(link.name == fmt::format("thing_rope_{}", i));
    CHECK(link.parent == i);
    CHECK(link.X_PB.p.isApprox(i == 0 ? Eigen::Vector3d(1, 0, 0) : Eigen::Vector3d(0, 0, -0.2)));
    CHECK(link.parts[0].name == link.name + "_link");
    CHECK(link.sites[0].name == link.name + "_middle");
    REQUIRE(link.joints.size() == 1);
    CHECK(link.joints[0].name == link.name);
    CHECK(link.joints[0].type == "ball");
    CHECK(link.joints[0].range == Eigen::Vector2d(0, 1));
    CHECK(model::FindAttribute(link.joints[0].attributes, "damping") != nullptr);
  }
}

TEST_CASE("the first link of a chain has the entry's own joints, the others hinges") {
  const auto joints = [](const std::string& own, std::size_t link) {
    const Assembling thing(
        "parts: [{name: hook, type: sphere, size: 1cm}]\n"
        "bodies:\n- {name: rope, chain: {links: 2, length: 1m, joint: hinges, range: 10deg},\n"
        "   parts: [{name: link, type: sphere, size: 1cm}]" +
        own + "}\n");
    std::vector<std::string> names;
    for (const model::Joint& joint : thing.object().bodies[link].joints)
      names.push_back(fmt::format("{} {}", joint.type, joint.name));
    return names;
  };
  using Names = std::vector<std::string>;
  CHECK(joints("", 1) == Names{"hinge thing_rope_0_x", "hinge thing_rope_0_y"});
  CHECK(joints(", joints: none", 1).empty());
  CHECK(joints(", joints: free", 1) == Names{"free thing_rope_0_joint0"});
  CHECK(joints(", joints: [{name: slide, type: slide}]", 1) == Names{"slide thing_slide"});
  CHECK(joints(", joints: free", 2) == Names{"hinge thing_rope_1_x", "hinge thing_rope_1_y"});
}

TEST_CASE("a camera of a link looks at bodies by their own names") {
  const Assembling thing(
      "parts: [{name: hook, type: sphere, size: 1cm}]\n"
      "bodies:\n"
      "- {name: post, parts: [{name: post, type: sphere, size: 1cm}]}\n"
      "- {name: rope, chain: {links: 1, length: 1m}, cameras: [{name: eye, target: post}],\n"
      "   parts: [{name: link, type: sphere, size: 1cm}]}\n");
  const model::Element& camera = thing.object().bodies[2].elements.at(0);
  CHECK(camera.name == "thing_rope_0_eye");
  CHECK(model::FindAttribute(camera.attributes, "target")->text == "thing_post");
}

TEST_CASE("links of a chain draw their own values") {
  const Assembling thing(
      "joints: none\nbodies:\n- {name: rope, chain: {links: 2, length: 1m},\n"
      "   parts: [{name: link, type: sphere, size: 1cm .. 2cm}]}\n");
  CHECK(thing.object().bodies[1].parts[0].shape.size !=
        thing.object().bodies[2].parts[0].shape.size);
}

TEST_CASE("links that there cannot be are refused") {
  const auto finding = [](const std::string& chain) {
    return OnlyFinding("bodies:\n- {name: rope, chain: {" + chain +
                       "}, parts: [{name: link, type: sphere, size: 1}]}\n");
  };
  CHECK(finding("links: sqrt(2.25), length: 1") == "4:31 links is 1.5; it must be a whole number");
  CHECK(
      finding("links: 2, length: 1, joint: \"${'bal'}\"") ==
      "4:52 joint of body 'rope' is 'bal'; it must be one of ball, hinges (did you mean 'ball'?)");
}

}  // namespace mjforge::assemble
