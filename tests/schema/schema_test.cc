#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "mjforge/spec/spec.h"
#include "yaml_as_json.h"

namespace {

namespace fs = std::filesystem;

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
  Schema() : json_(nlohmann::json::parse(mjforge::spec::JsonSchema())) {
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

const fs::path kRoot = MJFORGE_SOURCE_DIR;

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

TEST_CASE("the schema rejects every structurally bad golden spec", "[schema]") {
  Schema schema;
  for (const std::string kind :
       {"spec-unknown-key", "spec-missing-key", "spec-wrong-type", "spec-wrong-length",
        "spec-bad-value", "spec-distribution", "spec-version"}) {
    for (const fs::path& file : YamlFiles(kRoot / "tests/golden/errors" / kind)) {
      std::string unused;
      INFO(file);
      CHECK_FALSE(schema.Accepts(YamlAsJson(file.string()), unused));
    }
  }
}
