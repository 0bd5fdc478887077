#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "mjforge/diag/diag.h"

using namespace mjforge::diag;

TEST_CASE("a full finding is one JSON object in a fixed order of keys") {
  Sources sources;
  sources.Add("mug.yaml", "a: 1\nb: 2\n");
  Findings findings;
  Finding& finding = findings.Add(Code::kModelBadValue, {1, 2, 3}, "bad \"x\"", "mend it");
  finding.notes.push_back({{1, 1, 1}, "see"});
  findings.SetVariant(18446744073709551615u, 12);
  CHECK(RenderJson(findings[0], sources) ==
        R"({"severity":"error","code":"model/bad-value","file":"mug.yaml","line":2,"column":3,)"
        R"("message":"bad \"x\"","hint":"mend it","seed":18446744073709551615,"index":12,)"
        R"("notes":[{"file":"mug.yaml","line":1,"column":1,"message":"see"}]})");
}

TEST_CASE("what a finding does not have is left out of its JSON") {
  Sources sources;
  Findings findings;
  findings.Warn(Code::kMujocoWarning, {}, "slow");
  CHECK(RenderJson(findings[0], sources) ==
        R"({"severity":"warning","code":"mujoco/warning","message":"slow","notes":[]})");
}

TEST_CASE("JSON of broken text is valid JSON") {
  Sources sources;
  sources.Add("\xff.yaml", "a: 1\n");
  Findings findings;
  // A lone byte, a cut character, an overlong form, a surrogate, past the last
  // plane, control characters, and text that is in order.
  findings.Add(
      Code::kYamlNotText, {1, 1, 1},
      "\xff \xe2\x82 \xc0\x80 \xed\xa0\x80 \xf4\x90\x80\x80 \x01\n Größe \xf0\x9f\x94\xa8");
  const nlohmann::json json = nlohmann::json::parse(RenderJson(findings[0], sources));
  const std::string bad = "\uFFFD";
  CHECK(json["file"] == bad + ".yaml");
  CHECK(json["message"] == bad + " " + bad + bad + " " + bad + bad + " " + bad + bad + bad + " " +
                               bad + bad + bad + bad + " \x01\n Größe \xf0\x9f\x94\xa8");
}
