#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "docs/page.h"
#include "harness/source_folder.h"
#include "harness/temporary_folder.h"
#include "mjforge/forge/forge.h"
#include "yaml_as_json.h"

namespace {

namespace fs = std::filesystem;
using mjforge::docs::ReadSteps;
using mjforge::docs::Step;
using mjforge::harness::TemporaryFolder;

std::string ReadAll(const fs::path& file) {
  std::ifstream stream(file);
  REQUIRE(stream.good());
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// Compares a checked-in file with what the program makes; MJFORGE_UPDATE=1 rewrites it
// and fails all the same, so that an update is never a pass.
void CheckFresh(const fs::path& file, const std::string& made) {
  if (std::getenv("MJFORGE_UPDATE") != nullptr) {
    std::ofstream(file) << made;
    FAIL("rewrote " << file);
  }
  INFO("stale; rewrite it with MJFORGE_UPDATE=1");
  CHECK(ReadAll(file) == made);
}

class Schema {
 public:
  explicit Schema(const std::string& text = mjforge::spec::JsonSchema())
      : json_(nlohmann::json::parse(text)) {
    valijson::SchemaParser parser(valijson::SchemaParser::kDraft7);
    parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(json_), schema_);
  }

  bool Accepts(const nlohmann::json& document, std::string& why_not) {
    valijson::Validator validator(valijson::Validator::kStrongTypes);
    valijson::ValidationResults results;
    const bool valid =
        validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(document), &results);
    valijson::ValidationResults::Error error;
    while (results.popError(error)) {
      for (const std::string& part : error.context) why_not += part;
      why_not += ": " + error.description + "\n";
    }
    return valid;
  }

 private:
  nlohmann::json json_;
  valijson::Schema schema_;
};

std::vector<fs::path> YamlFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  REQUIRE(!files.empty());
  return files;
}

const fs::path kRoot = mjforge::harness::SourceFolder();

}  // namespace

TEST_CASE("the checked-in schema is what the program makes", "[schema]") {
  CheckFresh(kRoot / "schemas/object.schema.json", mjforge::spec::JsonSchema());
}

TEST_CASE("the checked-in reference is what the program makes", "[schema]") {
  CheckFresh(kRoot / "docs/reference.md", mjforge::spec::FieldReference());
}

TEST_CASE("the schema accepts every bundled spec", "[schema]") {
  Schema schema;
  for (const fs::path& file : YamlFiles(kRoot / "specs")) {
    std::string why_not;
    INFO(file);
    const bool accepted = schema.Accepts(YamlAsJson(file.string()), why_not);
    INFO(why_not);
    CHECK(accepted);
  }
}

TEST_CASE("the schema accepts every good golden spec", "[schema]") {
  Schema schema;
  for (const fs::path& file : YamlFiles(kRoot / "tests/golden/good")) {
    std::string why_not;
    INFO(file);
    const bool accepted = schema.Accepts(YamlAsJson(file.string()), why_not);
    INFO(why_not);
    CHECK(accepted);
  }
}

TEST_CASE("the schema rejects structurally bad specs") {
  // Specs whose fault is in an expression, in another file or in a setting.
  const std::set<std::string> accepted = {"spec/missing-key",
                                          "spec/wrong-length",
                                          "spec/bad-value: condim",
                                          "spec/bad-value: setting",
                                          "spec/missing-key: total size",
                                          "spec/missing-key: type",
                                          "spec/wrong-length: weights",
                                          "spec/wrong-type: condition",
                                          "spec/wrong-type: kind of an override",
                                          "spec/wrong-type: kinds of a choice",
                                          "spec/wrong-type: setting",
                                          "spec/wrong-type: yes"};
  const std::set<std::string> codes = {"spec/unknown-key",  "spec/missing-key", "spec/wrong-type",
                                       "spec/wrong-length", "spec/bad-value",   "spec/distribution",
                                       "spec/version"};
  std::vector<Step> steps = ReadSteps(kRoot / "docs/errors.md");
  std::ranges::move(ReadSteps(kRoot / "tests/golden/errors/spec.md"), std::back_inserter(steps));
  Schema schema;
  for (const Step& step : steps) {
    const std::string code = step.chapter.substr(0, step.chapter.find(':'));
    if (step.kind != Step::Kind::kFile || !codes.contains(code)) continue;
    const TemporaryFolder folder;
    folder.Write(step.name, step.text);
    std::string unused;
    INFO(step.chapter << ", " << step.name);
    CHECK(schema.Accepts(YamlAsJson((folder / step.name).string()), unused) ==
          accepted.contains(step.chapter));
  }
}

TEST_CASE("the placement's schema accepts a placement", "[schema]") {
  const std::string yaml =
      "mjforge: 1\nname: scene\njoints: none\nmjcf: {option: {cone: elliptic}}\n"
      "parts: [{name: board, type: box, size: [1, 1, 1]}]\n"
      "bodies:\n"
      "  - {name: ball, joints: free, pos: [0, 0, 5], parts: [{name: b, type: sphere, size: 1}]}\n"
      "  - {name: arm, parent: ball, pos: [3, 0, 0], joints: [{name: h, type: hinge, axis: [0, 0, "
      "1]}],\n"
      "     parts: [{name: a, type: sphere, size: 1}]}\n";
  mjforge::diag::Sources sources;
  mjforge::diag::Findings findings;
  mjforge::forge::Recipe recipe;
  recipe.spec = mjforge::spec::LoadSpecText("scene.yaml", yaml, ".", {}, sources, findings);
  REQUIRE(recipe.spec != nullptr);
  mjforge::forge::Options options;
  options.each = true;
  options.place_seed = 3;
  mjforge::forge::Variant variant;
  mjforge::forge::Generator(recipe, sources, options).Make(0, variant);
  REQUIRE(variant.placement);
  std::string why_not;
  const bool accepted = Schema(mjforge::manifest::PlacementSchema())
                            .Accepts(nlohmann::json::parse(variant.placement->text), why_not);
  INFO(variant.placement->text << why_not);
  CHECK(accepted);
  CHECK(variant.placement->text.find(R"("option":{"cone":"elliptic"})") != std::string::npos);
}

TEST_CASE("the manifest's schema accepts the records of made and of failed variants", "[schema]") {
  Schema schema(mjforge::manifest::ManifestSchema());
  const std::string yaml =
      "mjforge: 1\nname: thing\nparams: {r: -1cm .. 1cm, label: x, v: [1, r], yes: r > 0}\n"
      "parts: [{name: a, type: sphere, size: r}]\n";
  mjforge::diag::Sources sources;
  mjforge::diag::Findings findings;
  mjforge::forge::Recipe recipe;
  recipe.spec = mjforge::spec::LoadSpecText("thing.yaml", yaml, ".", {}, sources, findings);
  REQUIRE(recipe.spec != nullptr);
  recipe.reference = "thing.yaml";
  mjforge::forge::Generator generator(recipe, sources, {});
  mjforge::forge::Variant variant;
  int failed = 0;
  for (std::uint64_t index = 0; index < 20; ++index) {
    generator.Make(index, variant);
    failed += variant.ok() ? 0 : 1;
    std::string line;
    mjforge::manifest::AppendRecord(line, variant.record);
    std::string why_not;
    const bool accepted = schema.Accepts(nlohmann::json::parse(line), why_not);
    INFO(line << why_not);
    CHECK(accepted);
  }
  CHECK(failed > 0);
  CHECK(failed < 20);
  std::string unused;
  CHECK_FALSE(schema.Accepts(nlohmann::json::parse(R"({"file": "a.xml"})"), unused));
}
