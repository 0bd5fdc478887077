#include "mjforge/report/color_parameters.h"

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/report/variant_rows.h"
#include "report_records.h"

namespace mjforge::report {
namespace {

constexpr const char* kSpec = R"(
mjforge: 1
name: crate
params:
  tint: {hsv: [0 .. 1, 0.5, 0.5]}
  paint: {choice: [[1, 0, 0, 1], [0, 0, 1, 1]]}
  grain: [0.2, 0.4, 0.6]
  lamp: [1, 1, 0, 0.5]
  mark: [0, 1, 0, 1]
  half: [0.1, 0.2, 0.3]
materials:
  wood: {rgba: paint, texture: {builtin: checker, rgb1: grain, rgb2: [0, 0, 0]}}
parts:
  - {name: body, type: box, size: half, material: wood}
  - frame: {pos: [0, 0, 1]}
    parts: [{name: lid, type: sphere, size: 0.1, rgba: lamp}]
sites: [{name: grasp, rgba: mark}]
)";

struct ColorsTest {
  ColorsTest() : batch{ManifestSummary(10), {}, {}, {}, {}} {
    const harness::TemporaryFolder folder;
    diag::Sources sources;
    diag::Findings findings;
    batch.recipe =
        forge::LoadRecipe(folder.Write("crate.yaml", kSpec).string(), {}, sources, findings);
    REQUIRE(batch.recipe);
    for (std::uint64_t i = 0; i < 4; ++i) {
      manifest::Record record = RecordOf(i);
      record.params = {{"tint", std::vector<double>{0.5, 0.25, 0.25, 1}},
                       {"paint", std::vector<double>{i < 3 ? 1.0 : 0.0, 0, i < 3 ? 0.0 : 1.0, 1}},
                       {"half", std::vector<double>{0.1, 0.2, 0.3}}};
      batch.summary.Add(record);
    }
  }

  Batch batch;
};

TEST_CASE("parameters that are drawn or used as colours are colours") {
  CHECK(ColorsOf(*ColorsTest().batch.recipe->spec) ==
        std::set<std::string>{"grain", "lamp", "mark", "paint", "tint"});
}

TEST_CASE("a colour is three or four numbers from 0 to 1") {
  CHECK(HexColor(std::vector<double>{1, 0.5, 0}) == "#ff8000");
  CHECK(HexColor(std::vector<double>{1, 0.5, 0, 0.2}) == "#ff800033");
  CHECK(HexColor(std::vector<double>{1, 1.5, 0}) == std::nullopt);
  CHECK(HexColor(std::vector<double>{1, 0}) == std::nullopt);
  CHECK(HexColor(0.5) == std::nullopt);
  CHECK(HexColor(std::string("red")) == std::nullopt);
}

TEST_CASE("values of colours have a swatch in the table of variants, others have none") {
  const ColorsTest test;
  const VariantRows rows = MakeVariantRows(
      test.batch.summary.Choose(), test.batch, {"m.jsonl", "", 200},
      [](const auto&) { return std::nullopt; }, 1'000'000);
  CHECK(Count(rows.html, "class=\"swatch\"") == 8);
  CHECK(Count(rows.html, "fill=\"#804040ff\"/></svg> 0.5 0.25 0.25 1<") == 4);
  CHECK(Count(rows.html, "fill=\"#ff0000ff\"/></svg> 1 0 0 1<") == 3);
  CHECK(Count(rows.html, "fill=\"#0000ffff\"/></svg> 0 0 1 1<") == 1);
  CHECK(Count(rows.html, "<dd>0.1 0.2 0.3<") == 4);
}

TEST_CASE("the first chart of a colour shows drawn colours") {
  const ColorsTest test;
  Dictionary page("page");
  AddParameters(Section(page, "BODY"), test.batch);
  const std::string html = Expand(TemplateName::kPage, page);
  CHECK(Count(html, "aria-label=\"Colours of 4 variants\"") == 2);
  CHECK(Count(html, "fill=\"#804040ff\"") == 4);
  CHECK(Count(html, "fill=\"#ff0000ff\"") == 3);
}

TEST_CASE("without the spec nothing is known to be a colour") {
  ColorsTest test;
  test.batch.recipe.reset();
  CHECK(DrawnColors(test.batch).empty());
}

}  // namespace
}  // namespace mjforge::report
