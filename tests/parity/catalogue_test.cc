// Tests that every bundled spec is documented and makes objects that load and differ from each
// other.

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "harness/effort.h"
#include "harness/quick_settings.h"
#include "harness/source_folder.h"
#include "mjforge/diag/diag.h"
#include "mjforge/forge/forge.h"
#include "mjforge/spec/spec.h"

namespace mjforge::parity {
namespace {

const std::filesystem::path kSpecs = harness::SourceFolder() / "specs";

std::string Rendered(const diag::Findings& findings, const diag::Sources& sources) {
  std::string text;
  for (const diag::Finding& finding : findings) {
    text += diag::RenderText(finding, sources, false);
  }
  return text;
}

// Returns the texts of the first variants without their opening comment, which has the index.
std::set<std::string> Texts(const std::string& name, std::uint64_t count,
                            const std::vector<spec::Setting>& settings) {
  diag::Sources sources;
  diag::Findings findings;
  const auto recipe = forge::LoadRecipe(
      name, {.settings = settings, .parameter_files = {}, .search_path = {kSpecs}}, sources,
      findings);
  REQUIRE(Rendered(findings, sources) == "");
  forge::Options options;
  options.seed = 7;
  forge::Generator generator(*recipe, sources, options);
  forge::Variant variant;
  std::set<std::string> texts;
  for (std::uint64_t index = 0; index < count; ++index) {
    generator.Make(index, variant);
    CHECK(Rendered(variant.findings, sources) == "");
    if (variant.ok()) texts.insert(variant.document.text.substr(variant.document.text.find('\n')));
  }
  return texts;
}

}  // namespace

TEST_CASE("the catalogue has more than ninety families, beside scenes") {
  const std::vector<std::string> specs = spec::ListSpecs(kSpecs);
  const auto scenes = std::ranges::count_if(
      specs, [](const std::string& name) { return name.starts_with("scenes/"); });
  CHECK(scenes >= 9);
  CHECK(std::ssize(specs) - scenes > 90);
}

TEST_CASE("every bundled spec is documented and makes different, valid objects") {
  for (const std::string& name : spec::ListSpecs(kSpecs)) {
    DYNAMIC_SECTION(name) {
      diag::Sources sources;
      diag::Findings findings;
      const auto spec =
          spec::LoadSpec(name, {.settings = {}, .parameter_files = {}, .search_path = {kSpecs}},
                         sources, findings);
      REQUIRE(Rendered(findings, sources) == "");
      CHECK(spec->description != "");
      for (const spec::Parameter& parameter : spec->parameters) {
        INFO(parameter.name);
        const bool is_column = parameter.name.find('.') != std::string::npos;
        if (is_column && parameter.record.empty()) continue;  // the record's key is documented
        CHECK(parameter.doc != "");
        CHECK((parameter.unit != "") == (parameter.value.type == expr::Type::kNumber));
      }
      const int whole = name.starts_with("scenes/") ? 2 : 10;  // takes as long as five objects
      const auto count = static_cast<std::uint64_t>(harness::Effort(whole, 2));
      std::vector<spec::Setting> settings;
      for (const auto& [parameter, value] : harness::QuickSettings(name))
        settings.push_back({.name = parameter, .text = value});
      CHECK(Texts(name, count, settings).size() == count);
    }
  }
}

// Uses primitives/box, whose material is set by name.
TEST_CASE("every material of the library has a density and a colour, and can be used") {
  diag::Sources sources;
  diag::Findings findings;
  const auto box = spec::LoadSpec("primitives/box",
                                  {.settings = {}, .parameter_files = {}, .search_path = {kSpecs}},
                                  sources, findings);
  REQUIRE(Rendered(findings, sources) == "");
  int imported = 0;
  for (const spec::Material& material : box->materials) {
    if (material.name == "plain" || material.name == "patterned") continue;
    INFO(material.name);
    ++imported;
    CHECK(material.Find(spec::Key::kDensity) != nullptr);
    CHECK(material.Find(spec::Key::kRgba) != nullptr);
    CHECK(Texts("primitives/box", 1, {{.name = "material", .text = material.name}}).size() == 1);
  }
  CHECK(imported > 30);
}

}  // namespace mjforge::parity
