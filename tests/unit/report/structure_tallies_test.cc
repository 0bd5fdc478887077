// Structures of a batch, and the parameters that separate them.
#include "mjforge/report/structure_tallies.h"

#include <catch2/catch.hpp>

namespace mjforge::report {
namespace {

using sample::ParameterValue;

manifest::Record RecordIn(std::uint64_t index, const std::string& structure,
                          std::vector<std::pair<std::string, ParameterValue>> params) {
  manifest::Record record;
  record.index = index;
  record.structure = structure;
  record.params = std::move(params);
  return record;
}

std::vector<std::string> NamesOf(const std::vector<Separator>& separators) {
  std::vector<std::string> names;
  for (const Separator& separator : separators) {
    names.push_back(separator.parameter +
                    (separator.separation == Separation::kByRange ? " by range" : ""));
  }
  return names;
}

using Names = std::vector<std::string>;

TEST_CASE("structures are counted in the order of their first variants") {
  StructureTallies tallies;
  for (const std::uint64_t i : {0, 1, 2, 3, 4})
    tallies.Add(RecordIn(i, i % 2 == 0 ? "b" : "a", {}));
  tallies.Add(RecordIn(5, "", {}));  // not loaded in MuJoCo
  REQUIRE(tallies.list().size() == 2);
  CHECK(tallies.list()[0].key == "b");
  CHECK(tallies.list()[0].variants == 3);
  CHECK(tallies.list()[1].first.index == 1);
  CHECK(tallies.more() == 0);
}

TEST_CASE("sections of a manifest are joined") {
  StructureTallies whole;
  StructureTallies first;
  StructureTallies second;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const manifest::Record record =
        RecordIn(i, i % 3 == 0 ? "a" : "b",
                 {{"shape", i % 3 == 0 ? "box" : "ball"}, {"size", static_cast<double>(i) / 7}});
    whole.Add(record);
    (i < 17 ? first : second).Add(record);
  }
  first.Append(second);
  REQUIRE(first.list().size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(first.list()[i].variants == whole.list()[i].variants);
    CHECK(first.list()[i].first.index == whole.list()[i].first.index);
  }
  CHECK(NamesOf(SeparatorsOf(first.list(), {0, 1})) == Names{"shape"});
}

TEST_CASE("a parameter separates by values that no two groups share") {
  StructureTallies tallies;
  tallies.Add(RecordIn(0, "a", {{"shape", "box"}, {"open", true}, {"n", 3.0}, {"size", 0.15}}));
  tallies.Add(RecordIn(1, "a", {{"shape", "box"}, {"open", false}, {"n", 5.0}, {"size", 0.25}}));
  tallies.Add(RecordIn(2, "b", {{"shape", "ball"}, {"open", false}, {"n", 4.0}, {"size", 0.16}}));
  tallies.Add(RecordIn(3, "c", {{"shape", "cone"}, {"open", true}, {"n", 3.0}, {"size", 0.17}}));
  const std::vector<StructureTally>& list = tallies.list();
  CHECK(NamesOf(SeparatorsOf(list, {0, 1, 2})) == Names{"shape"});
  CHECK(NamesOf(SeparatorsOf(list, {0, 1, -1})) == Names{"shape", "n"});
  CHECK(NamesOf(SeparatorsOf(list, {0, 1, 0})) == Names{"shape", "n"});
  CHECK(NamesOf(SeparatorsOf(list, {0, 0, 0})) == Names{});
}

TEST_CASE("a threshold separates if no parameter does so by its values") {
  StructureTallies tallies;
  const std::vector<std::pair<double, double>> low = {{0.11, 0.5}, {0.12, 0.9}, {0.13, 0.7}};
  const std::vector<std::pair<double, double>> high = {{0.14, 0.6}, {0.15, 0.8}};
  for (const auto& [size, other] : low)
    tallies.Add(RecordIn(0, "a", {{"size", size}, {"other", other}}));
  for (const auto& [size, other] : high)
    tallies.Add(RecordIn(0, "b", {{"size", size}, {"other", other}}));
  CHECK(NamesOf(SeparatorsOf(tallies.list(), {0, 1})) == Names{"size by range"});
}

TEST_CASE("no parameter separates groups that share all values") {
  StructureTallies tallies;
  tallies.Add(RecordIn(0, "a", {{"size", 0.11}, {"box", std::vector<double>{0.5, 0.1}}}));
  tallies.Add(RecordIn(1, "a", {{"size", 0.31}, {"box", std::vector<double>{0.7, 0.1}}}));
  tallies.Add(RecordIn(2, "b", {{"size", 0.21}, {"box", std::vector<double>{0.6, 0.2}}}));
  CHECK(NamesOf(SeparatorsOf(tallies.list(), {0, 1})) == Names{"box[1] by range"});
  tallies.Add(RecordIn(3, "b", {{"size", 0.21}, {"box", std::vector<double>{0.6, 0.05}}}));
  CHECK(NamesOf(SeparatorsOf(tallies.list(), {0, 1})) == Names{});
}

TEST_CASE("more structures than the limit are counted together") {
  StructureTallies tallies;
  for (std::uint64_t i = 0; i < StructureTallies::kMaxStructures + 5; ++i)
    tallies.Add(RecordIn(i, std::to_string(i), {}));
  CHECK(tallies.list().size() == StructureTallies::kMaxStructures);
  CHECK(tallies.more() == 5);
}

}  // namespace
}  // namespace mjforge::report
