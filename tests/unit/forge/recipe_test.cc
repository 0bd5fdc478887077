#include <catch2/catch.hpp>

#include "loaded_recipe.h"

namespace mjforge::forge {
namespace {

spec::LoadOptions With(spec::Snapshot& snapshot) {
  spec::LoadOptions options;
  options.snapshot = &snapshot;
  return options;
}

using Settings = std::vector<std::pair<std::string, std::string>>;

TEST_CASE("a spec that was given as a path is named by its file alone") {
  CHECK(LoadedRecipe(kBoxSpec).recipe.reference == "crate.yaml");
}

TEST_CASE("a text is a spec like any other, which findings call by the name it is given") {
  diag::Sources sources;
  diag::Findings findings;
  spec::Snapshot snapshot;
  snapshot.text_name = "mine";
  snapshot.texts["-"] = kBoxSpec;
  const std::optional<Recipe> recipe = LoadRecipe("-", With(snapshot), sources, findings);
  REQUIRE(recipe);
  CHECK(recipe->reference == "-");
  snapshot = {};
  snapshot.text_name = "mine";
  snapshot.texts["-"] = "mjforge: 1\nname: bad\nprats: []\n";
  CHECK_FALSE(LoadRecipe("-", With(snapshot), sources, findings));
  REQUIRE(findings.HasErrors());
  CHECK(sources.Name(findings[0].mark.file) == "mine");
}

TEST_CASE("a snapshot loads without the files that it was read from, also after it was saved") {
  const harness::TemporaryFolder folder;
  folder.Write("specs/wood.yaml", "mjforge: 1\nmaterials: {wood: {rgba: [1, 1, 1, 1]}}\n");
  const auto file = folder.Write("specs/a.yaml",
                                 "mjforge: 1\nname: a\nimport: wood\nparts: [{name: b, type: "
                                 "sphere, size: 1, material: wood}]\n");
  spec::Snapshot snapshot;
  snapshot.spec = file.string();
  diag::Sources sources;
  diag::Findings findings;
  const auto first = LoadRecipe(snapshot.spec, With(snapshot), sources, findings);
  REQUIRE(first);
  std::filesystem::remove_all(folder / "specs");
  const auto saved = folder.Write("a.spec.json", spec::SnapshotText(snapshot));
  CHECK(LoadRecipe(snapshot.spec, With(snapshot), sources, findings));
  const auto again = LoadRecipe(saved.string(), {}, sources, findings);
  REQUIRE(again);
  CHECK(again->spec->sha256 == first->spec->sha256);
  CHECK(again->reference == first->reference);
  folder.Write("a.spec.json", spec::SnapshotText(snapshot).substr(0, 90));
  CHECK_FALSE(LoadRecipe(saved.string(), {}, sources, findings));
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].code == diag::Code::kYamlCannotRead);
}

TEST_CASE("the snapshot of a spec is kept when its file has another text or is gone") {
  const harness::TemporaryFolder folder;
  const auto file = folder.Write("a.yaml", kBoxSpec);
  spec::Snapshot snapshot;
  snapshot.spec = file.string();
  diag::Sources sources;
  diag::Findings findings;
  REQUIRE(LoadRecipe(snapshot.spec, With(snapshot), sources, findings));
  const auto saved = folder.Write("a.spec.json", spec::SnapshotText(snapshot)).string();
  const auto kept = [&] { return LoadRecipe(saved, {}, sources, findings)->snapshot; };
  CHECK(kept().empty());
  folder.Write("a.yaml", std::string(kBoxSpec) + "\n");
  CHECK(kept() == spec::SnapshotText(snapshot));
  std::filesystem::remove(file);
  CHECK(kept() == spec::SnapshotText(snapshot));
}

TEST_CASE("a spec in the search path is named as the search path names it") {
  const harness::TemporaryFolder folder;
  const auto file = folder.Write("specs/boxes/crate.yaml", kBoxSpec);
  spec::LoadOptions options;
  options.search_path = {folder / "specs"};
  for (const std::string given : {"crate", "boxes/crate", file.c_str()}) {
    diag::Sources sources;
    diag::Findings findings;
    const std::optional<Recipe> recipe = LoadRecipe(given, options, sources, findings);
    REQUIRE(recipe);
    CHECK(recipe->reference == "boxes/crate");
  }
}

TEST_CASE("settings are recorded, the last of a name wins") {
  spec::LoadOptions options;
  options.settings = {{"height", "0.3"}, {"kind", "light"}, {"height", "0.4 .. 0.5"}};
  CHECK(LoadedRecipe(kBoxSpec, options).recipe.settings ==
        Settings{{"height", "0.4 .. 0.5"}, {"kind", "light"}});
}

TEST_CASE("what a parameter file sets is recorded like a setting, which wins over it") {
  const harness::TemporaryFolder folder;
  spec::LoadOptions options;
  options.parameter_files = {folder.Write("p.yaml", "height: 0.3 .. 0.4\nkind: heavy\n")};
  options.settings = {{"kind", "light"}};
  CHECK(LoadedRecipe(kBoxSpec, options).recipe.settings ==
        Settings{{"height", "0.3 .. 0.4"}, {"kind", "light"}});
}

TEST_CASE("a spec with errors gives no recipe") {
  const harness::TemporaryFolder folder;
  diag::Sources sources;
  diag::Findings findings;
  const std::string file = folder.Write("bad.yaml", "mjforge: 1\nname: bad\nprats: []\n").string();
  CHECK_FALSE(LoadRecipe(file, {}, sources, findings).has_value());
  CHECK(findings.HasErrors());
}

TEST_CASE("every ${index} in a name becomes the variant's index") {
  CHECK(ExpandName("crate", 42) == "crate");
  CHECK(ExpandName("c${index}_${index}x", 42) == "c42_42x");
  CHECK(ExpandName("c${indices}", 42) == "c${indices}");
}

TEST_CASE("a name has letters, digits and _ and begins with a letter") {
  diag::Findings findings;
  CHECK(CheckName("Crate_2", findings));
  CHECK(CheckName("c${index}", findings));
  CHECK(findings.empty());
  for (const char* name :
       {"", "2c", "_c", "a b", "a/b", "..", "a\nb", "${index}", "a${x}", "\"a"}) {
    CHECK_FALSE(CheckName(name, findings));
  }
  REQUIRE(findings.size() == 10);
  CHECK(findings[1].code == diag::Code::kOutputBadName);
  CHECK(findings[1].message == "'2c' cannot be an object's name");
  CHECK(findings[1].hint ==
        "use a letter, then letters, digits and _; ${index} stands for the variant's index");
}

}  // namespace
}  // namespace mjforge::forge
