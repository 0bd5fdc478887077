// The file of rows: encoding, decoding, damage.

#include "mjforge/family/rows.h"

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "sample_rows.h"

namespace mjforge::family {
namespace {

using sample_rows::Ball;

std::string TwoVariants() {
  ChunkEncoder rows;
  CHECK(rows.Add(Ball(1, "oak", 0.5), {{"r", 1.0}, {"wood", std::string("oak")}}).empty());
  CHECK(rows.Add(Ball(2, "ash", 0.7), {{"r", 2.0}, {"wood", std::string("ash")}}).empty());
  return rows.Header(sample_rows::kBase) + AssetBlock("assets/a.png", "pixels") + rows.Bytes();
}

TEST_CASE("a file of rows has what was added") {
  const harness::TemporaryFolder folder;
  folder.Write("x.rows", TwoVariants());
  RowsFile file(folder / "x.rows");
  CHECK(file.count() == 2);
  CHECK(file.header().shapes == Ball(1, "oak", 0).shapes);
  CHECK(file.header().parameters == std::vector<std::string>{"r", "wood"});
  CHECK(file.header().base == sample_rows::kBase);
  REQUIRE(file.assets().size() == 1);
  CHECK(*file.assets()[0].made == "pixels");
  std::vector<std::string> seen;
  file.ForEach([&](const RowView& row) {
    seen.push_back(row.materials.at(0)->name);
    CHECK(row.material_numbers.at(0)[0] == (seen.size() == 1 ? 0.5 : 0.7));
    CHECK(std::get<std::string>(row.parameters.at(1)) == seen.back());
    CHECK(row.values[0] == static_cast<double>(seen.size()));
  });
  CHECK(seen == std::vector<std::string>{"oak", "ash"});
}

TEST_CASE("variants with other arrays are not added, and are told by the headers") {
  ChunkEncoder rows;
  CHECK(rows.Add(Ball(1, "oak", 0), {}).empty());
  Numbers other = Ball(1, "oak", 0);
  other.shapes[4].elements = {"shell"};
  CHECK(rows.Add(other, {}) == "geom_size has other elements");
  ChunkEncoder others;
  CHECK(others.Add(other, {}).empty());
  CHECK(DifferenceOf(DecodeHeader(others.Header("")), DecodeHeader(rows.Header(""))) ==
        "geom_size has other elements");
  CHECK(DifferenceOf(DecodeHeader(rows.Header("a")), DecodeHeader(rows.Header("b"))).empty());
}

TEST_CASE("a file of rows that was cut short or changed is refused") {
  const harness::TemporaryFolder folder;
  const std::string whole = TwoVariants();
  for (std::size_t size = 1; size < whole.size(); size += 7) {
    folder.Write("x.rows", whole.substr(0, size));
    try {
      RowsFile file(folder / "x.rows");
      file.ForEach([](const RowView&) {});
      CHECK(file.count() < 2);  // cut between two blocks
    } catch (const std::runtime_error&) {
      SUCCEED();
    }
  }
  std::string changed = whole;
  changed[0] = 'x';
  folder.Write("x.rows", changed);
  CHECK_THROWS_AS(RowsFile(folder / "x.rows"), std::runtime_error);
}

}  // namespace
}  // namespace mjforge::family
