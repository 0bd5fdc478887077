// The file of a family: columns, coincidences, damaged rows.

#include <catch2/catch.hpp>

#include "harness/npz.h"
#include "harness/temporary_folder.h"
#include "mjforge/family/family.h"
#include "sample_rows.h"

namespace mjforge::family {
namespace {

using sample_rows::Ball;

struct Written {
  bool good = false;
  diag::Findings findings;
  std::map<std::string, harness::NpyArray> arrays;
};

Written Write(const harness::TemporaryFolder& folder,
              const std::vector<std::filesystem::path>& rows) {
  Written written;
  const auto parts = WriteNpz(
      rows, {}, [&](const std::string&) { return folder / "x.npz"; }, written.findings);
  written.good = parts.size() == 1;
  if (written.good) {
    REQUIRE(parts[0]->Commit(false, output::Durability::kNone, written.findings));
    written.arrays = harness::NpzByName(folder.Read("x.npz"));
  }
  return written;
}

std::string RowsOf(const std::vector<Numbers>& variants) {
  ChunkEncoder rows;
  for (const Numbers& numbers : variants)
    CHECK(rows.Add(numbers, {{"list", std::vector{1.0}}}).empty());
  return rows.Header(sample_rows::kBase) + rows.Bytes();
}

TEST_CASE("several files of rows are one family") {
  const harness::TemporaryFolder folder;
  folder.Write("a.rows", RowsOf({Ball(1, "oak", 0.5), Ball(2, "oak", 0.5)}));
  folder.Write("none.rows", "");
  folder.Write("b.rows", RowsOf({Ball(3, "ash", 0.7)}));
  const Written family =
      Write(folder, {folder / "a.rows", folder / "none.rows", folder / "b.rows"});
  REQUIRE(family.good);
  CHECK(family.arrays.at("geom_size").Numbers() == std::vector<double>{1, 0, 0, 2, 0, 0, 3, 0, 0});
  CHECK(family.arrays.at("geom_size.names").Texts() == std::vector<std::string>{"core"});
  CHECK(family.arrays.at("materials").Texts() == std::vector<std::string>{"oak", "ash"});
  CHECK(family.arrays.at("geom_matid").bytes == std::string("\0\0\0\0\0\0\0\0\1\0\0\0", 12));
  CHECK_FALSE(family.arrays.contains("mat_rgba"));  // the color of each is constant
  CHECK_FALSE(family.arrays.contains("geom_pos"));
  CHECK(family.arrays.at("constants/list").Numbers() == std::vector<double>{1});
}

TEST_CASE("each family of the rows has its file, if they have places of their own") {
  const harness::TemporaryFolder folder;
  Numbers other = Ball(4, "oak", 0);
  const double extra = 7;
  other.Add("extra", {}, {&extra, 1});
  folder.Write("a.rows",
               RowsOf({Ball(1, "oak", 0)}) + RowsOf({other}) + RowsOf({Ball(2, "ash", 0)}));
  folder.Write("b.rows", RowsOf({other}));
  const std::vector<std::filesystem::path> rows = {folder / "a.rows", folder / "b.rows"};
  diag::Findings findings;
  int count = 0;
  const auto place = [&](const std::string&) { return folder / std::to_string(count++); };
  for (const auto& part : WriteNpz(rows, {}, place, findings))
    REQUIRE(part->Commit(false, output::Durability::kNone, findings));
  CHECK(findings.empty());
  REQUIRE(count == 2);
  const auto first = harness::NpzByName(folder.Read("0"));
  CHECK(first.at("geom_size").Numbers() == std::vector<double>{1, 0, 0, 2, 0, 0});
  CHECK_FALSE(first.contains("extra"));
  CHECK(harness::NpzByName(folder.Read("1")).at("extra").Numbers() == std::vector<double>{7, 7});
  const Written one = Write(folder, rows);
  REQUIRE_FALSE(one.good);
  CHECK(one.findings.begin()->code == diag::Code::kBatchDiffers);
}

TEST_CASE("a constant element is stored if the base has another value") {
  const harness::TemporaryFolder folder;
  Numbers other = Ball(2, "oak", 0);
  other.values.at(other.values.size() - 1) = 0;  // another flag of the geom at the same place
  folder.Write("a.rows", RowsOf({Ball(1, "oak", 0), other}));
  const Written family = Write(folder, {folder / "a.rows"});
  REQUIRE(family.good);
  CHECK(family.arrays.at("geom_pos").Numbers() == std::vector<double>(6, 0.0));
  const std::string& base = family.arrays.at("base").bytes;
  CHECK(base.find("pos=\"2e-05 2e-05 2e-05\" quat=") != base.npos);
  CHECK(family.arrays.at("family").bytes.find(
            R"("moved":{"geom_pos":["core"],"geom_quat":["core"]})") != std::string::npos);
}

TEST_CASE("damaged rows, a base that MuJoCo refuses and a family of none are findings") {
  const harness::TemporaryFolder folder;
  const std::string rows = RowsOf({Ball(1, "oak", 0), Ball(2, "oak", 0)});
  folder.Write("cut.rows", rows.substr(0, rows.size() - 9));
  const Written cut = Write(folder, {folder / "cut.rows"});
  REQUIRE_FALSE(cut.good);
  CHECK(cut.findings.begin()->message.find("it is cut short") != std::string::npos);
  folder.Write("none.rows", "");
  CHECK_FALSE(Write(folder, {folder / "none.rows"}).good);
  ChunkEncoder refused;
  CHECK(refused.Add(Ball(1, "oak", 0), {}).empty());
  folder.Write(
      "bad.rows",
      refused.Header("<mujoco model=\"x\">\n  <worldbody>\n  </worldbody>\n  <no/>\n</mujoco>\n") +
          refused.Bytes());
  const Written bad = Write(folder, {folder / "bad.rows"});
  REQUIRE_FALSE(bad.good);
  CHECK(bad.findings.begin()->code == diag::Code::kMujocoError);
}

}  // namespace
}  // namespace mjforge::family
