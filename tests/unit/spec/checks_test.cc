#include <algorithm>
#include <catch2/catch.hpp>

#include "loading.h"

using namespace mjforge;

namespace {

std::vector<std::string> KeysOf(const spec::Checks& checks) {
  std::vector<std::string> keys;
  for (const spec::Field& field : checks.fields) keys.emplace_back(field.info->key);
  return keys;
}

}  // namespace

TEST_CASE("checks: holds thresholds and what is silenced", "[checks]") {
  const Loaded loaded = LoadWithBox(
      "params: {r: 1cm}\n"
      "checks: {stable: true, sink: 2mm, aspect: 10 * r / 1mm, density: [1, 2], "
      "silence: {physics/thin: paper}}\n");
  CHECK(loaded.Report().empty());
  REQUIRE(loaded.spec);
  CHECK(KeysOf(loaded.spec->checks) == Strings{"stable", "sink", "aspect", "density"});
  REQUIRE(loaded.spec->checks.silenced.size() == 1);
  CHECK(loaded.spec->checks.silenced[0].code == diag::Code::kPhysicsThin);
  CHECK(loaded.spec->checks.silenced[0].reason == "paper");
}

TEST_CASE("a threshold that is none, out of bounds or drawn is an error", "[checks]") {
  CHECK(ReportWithBox("checks: 3\n") ==
        Strings{"4:9 spec/wrong-type: expected a mapping with checks, got a single value"});
  CHECK(ReportWithBox("checks: {stabel: true}\n") ==
        Strings{"4:10 spec/unknown-key: unknown key 'stabel' in checks (did you mean 'stable'?)"});
  CHECK(ReportWithBox("checks: {settle_time: 0}\n").size() == 1);
  CHECK(ReportWithBox("checks: {sink: 1mm .. 2mm}\n") ==
        Strings{"4:10 spec/bad-value: 'sink' is drawn, but a threshold must be a fixed value (draw "
                "it as a parameter, and use that parameter's name here)"});
}

TEST_CASE("how a joint is driven is fixed, and why it is not is said", "[checks]") {
  CHECK(ReportWithBox("checks: {joints: [{joint: a, skip: ' '}]}\n") ==
        Strings{"4:36 spec/bad-value: no reason is given why it is not driven"});
  CHECK(
      ReportWithBox("checks: {joints: [{joint: a, at: {b: 1 .. 2}}]}\n") ==
      Strings{"4:35 spec/bad-value: 'at' is drawn, but a threshold must be a fixed value (draw it "
              "as a parameter, and use that parameter's name here)"});
}

TEST_CASE("only some findings can be silenced, each with a reason", "[checks]") {
  CHECK(ReportWithBox("checks: {silence: {physics/thinn: x}}\n") ==
        Strings{
            "4:20 spec/unknown-key: 'physics/thinn' is not a finding that can be silenced (did you "
            "mean 'physics/thin'?)"});
  CHECK(ReportWithBox("checks: {silence: {mujoco/error: x}}\n") ==
        Strings{"4:20 spec/unknown-key: 'mujoco/error' is not a finding that can be silenced "
                "(docs/errors.md lists them: physics/... and spec/unused)"});
  CHECK(ReportWithBox("checks: {silence: {physics/thin: ''}}\n") ==
        Strings{"4:34 spec/bad-value: no reason is given why 'physics/thin' does not matter"});
  CHECK(ReportWithBox("checks: {silence: [physics/thin]}\n").size() == 1);
}

TEST_CASE("the setting root.joints takes the place of the joints of the root") {
  const std::string yaml =
      "mjforge: 1\nname: t\njoints: [{name: j, axis: [0, 0, 1]}]\n"
      "parts: [{name: box, type: sphere, size: 1}]\n";
  const Loaded loaded = Load(yaml, {{"root.joints", "free"}, {"root.joints", "none"}});
  CHECK(loaded.Report().empty());
  REQUIRE(loaded.spec);
  CHECK(loaded.spec->root_joints == mjforge::spec::RootJoints::kNone);
  CHECK(loaded.spec->joints.empty());
  CHECK(
      Load(yaml, {{"root.joints", "fee"}}).Report() ==
      Strings{"1:14 spec/bad-value: 'fee' is neither 'free', 'none' nor a list of joints (did you "
              "mean 'free'?)"});
}

TEST_CASE("the setting root.start takes the place of the start") {
  const std::string yaml =
      "mjforge: 1\nname: t\nstart: zero\nparts: [{name: box, type: sphere, size: 1}]\n";
  const Loaded loaded = Load(yaml, {{"root.start", "keyframe"}});
  CHECK(loaded.Report().empty());
  REQUIRE(loaded.spec);
  REQUIRE(loaded.spec->start);
  CHECK(mjforge::spec::LiteralText(loaded.spec->start->value) == "keyframe");
  CHECK(loaded.spec->settings.size() == 1);
  CHECK(Load(yaml, {{"root.start", "zer"}}).Report() ==
        Strings{"1:13 spec/bad-value: 'zer' is not one of zero, keyframe (did you mean 'zero'?)"});
}

TEST_CASE("settings named checks.KEY take the place of a threshold", "[checks]") {
  const std::string yaml =
      "mjforge: 1\nname: t\nchecks: {sink: 2mm}\n"
      "parts: [{name: box, type: sphere, size: 1}]\n";
  const Loaded loaded = Load(yaml, {{"checks.sink", "3mm"}, {"checks.stable", "true"}});
  CHECK(loaded.Report().empty());
  REQUIRE(loaded.spec);
  CHECK(KeysOf(loaded.spec->checks) == Strings{"sink", "stable"});
  CHECK(loaded.spec->settings.size() == 2);
  CHECK(Load(yaml, {{"checks.snik", "3mm"}}).Report() ==
        Strings{"1:14 spec/unknown-key: unknown key 'snik' in checks (did you mean 'sink'?)"});
}

TEST_CASE("a setting checks.KEY of nothing takes away what the spec says", "[checks]") {
  const std::string yaml =
      "mjforge: 1\nname: t\nchecks: {sink: 2mm, grasps: {}}\n"
      "parts: [{name: box, type: sphere, size: 1}]\n";
  const Loaded loaded = Load(yaml, {{"checks.grasps", "null"}});
  CHECK(loaded.Report().empty());
  REQUIRE(loaded.spec);
  CHECK_FALSE(loaded.spec->checks.grasps);
  CHECK(KeysOf(loaded.spec->checks) == Strings{"sink"});
  CHECK(Load(yaml, {{"checks.snik", "null"}}).Report() ==
        Strings{"1:1 spec/unknown-key: unknown key 'snik' in checks (did you mean 'sink'?)"});
}
