#include "mjforge/mjcf/targets.h"

#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "mjforge/mjcf/section_writers.h"

namespace mjforge::mjcf {
namespace {

TEST_CASE("a target is found by its name, and each name is another one") {
  std::set<std::string_view> names;
  for (const TargetRules& rules : Targets()) {
    CHECK(FindTarget(rules.name) == rules.target);
    CHECK(&RulesOf(rules.target) == &rules);
    CHECK_FALSE(rules.doc.empty());
    names.insert(rules.name);
  }
  CHECK(names == std::set<std::string_view>{"mujoco", "scene", "robosuite", "robocasa", "mjx"});
  CHECK_FALSE(FindTarget("robot"));
  CHECK_FALSE(FindTarget(""));
}

TEST_CASE("geoms are in the groups their reader tells them by") {
  struct Row {
    Target target;
    std::string collision;
    std::string visual;
    int sphere_sizes;
  };
  const Row rows[] = {{Target::kMujoco, " group=\"3\"", " group=\"2\"", 1},
                      {Target::kScene, " group=\"3\"", " group=\"2\"", 1},
                      {Target::kRobosuite, " group=\"0\"", " group=\"1\"", 1},
                      {Target::kRobocasa, " group=\"0\"", " group=\"1\"", 3},
                      {Target::kMjx, " group=\"3\"", " group=\"2\"", 1}};
  REQUIRE(std::size(rows) == Targets().size());
  for (const Row& row : rows) {
    CAPTURE(RulesOf(row.target).name);
    const TargetRules& rules = RulesOf(row.target);
    CHECK(GroupAttribute(rules.collision_group) == row.collision);
    CHECK(GroupAttribute(rules.visual_group) == row.visual);
    CHECK(rules.sphere_sizes == row.sphere_sizes);
  }
}

TEST_CASE("a host that adds the prefix names the root body and its free joint") {
  for (const TargetRules& rules : Targets()) {
    CAPTURE(rules.name);
    const bool is_hosted = rules.target == Target::kRobosuite || rules.target == Target::kRobocasa;
    CHECK(rules.has_prefix == !is_hosted);
    CHECK(rules.root == (is_hosted ? "object" : ""));
    CHECK(rules.has_free_joint == !is_hosted);
    CHECK(rules.has_outer_body == is_hosted);
    CHECK(rules.supports_sections == !is_hosted);
  }
}

}  // namespace
}  // namespace mjforge::mjcf
