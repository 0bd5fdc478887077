// Tests of lists, records and tables, and of findings about them.

#include <catch2/catch.hpp>
#include <string>

#include "harness/temporary_folder.h"
#include "loading.h"

namespace mjforge::spec {
namespace {

Strings ReportOf(const std::string& params, std::vector<Setting> settings = {}) {
  return Load("mjforge: 1\nname: t\nparams: " + params +
                  "\nparts: [{name: a, type: sphere, size: 1}]\n",
              std::move(settings))
      .Report();
}

TEST_CASE("a list is of numbers, of texts or of booleans") {
  CHECK(ReportOf("{a: [1, 2, 3, 4, 5], b: [oak], c: [oak, 'pine wood', '${b[0]}'], d: [1, 2]}")
            .empty());
  CHECK(ReportOf("{a: [1, 2, 3, 4, oak]}") ==
        Strings{"3:26 expr/unknown-name: unknown name 'oak'"});
  CHECK(ReportOf("{a: {each: [1, 2], count: 3}}") ==
        Strings{"3:20 spec/wrong-type: a list is of numbers, texts or booleans, but this is 2 "
                "numbers"});
  CHECK(ReportOf("{a: {each: 1 .. 2}}") ==
        Strings{"3:13 spec/missing-key: 'each' without 'count' (write {each: 1cm .. 2cm, count: "
                "5})"});
  CHECK(ReportOf("{a: {sample: [1, 2]}}") ==
        Strings{"3:13 spec/missing-key: 'sample' without 'count' (write {sample: [a, b, c], count: "
                "2}; all of them: {shuffle: [a, b, c]})"});
  CHECK(ReportOf("{a: {shuffle: 3}}") ==
        Strings{"3:23 spec/wrong-type: expected a list or the name of one, got '3'"});
  CHECK(ReportOf("{a: {each: 1 .. 2, count: 1e7}}") ==
        Strings{"3:35 spec/bad-value: count is 10000000; it must be a whole number, 0 to 100000"});
  CHECK(ReportOf("{a: {each: 1 .. 2, count: 3, weights: [1]}}") ==
        Strings{"3:38 spec/unknown-key: unknown key 'weights' in a distribution"});
  CHECK(ReportOf("{a: {choice: [[1, 2, 3, 4, 5], [oak]]}}") ==
        Strings{"3:40 spec/wrong-type: the values to choose from are of different kinds: a list of "
                "numbers and a list of texts"});
}

TEST_CASE("booleans in brackets are a list, and its items are conditions") {
  CHECK(ReportOf("{a: [true, false], b: {each: {bernoulli: 0.5}, count: 3}, c: {shuffle: a}, "
                 "d: ['b[0]', true, {bernoulli: 0.1}], e: 'a[1] and not b[2]', n: 'sum(b) * 2cm'}")
            .empty());
  CHECK(ReportOf(
            "{n: 2, a: [n > 1, n < 1], b: ['a[0] and n == 2'], c: [{bernoulli: 0.5}, 'not a[1]']}")
            .empty());
  CHECK(ReportOf("{n: 2, a: [n > 1, n]}") ==
        Strings{"3:27 spec/wrong-type: expected a condition, but 'n' is a number (compare it with "
                "something, as in `x > 0`)"});
  CHECK(ReportOf("{a: [true, 2]}") ==
        Strings{"3:20 spec/wrong-type: expected a condition, but '2' is a number (compare it with "
                "something, as in `x > 0`)"});
  CHECK(ReportOf("{a: {each: [true, false], count: 2}}") ==
        Strings{"3:20 spec/wrong-type: a list is of numbers, texts or booleans, but this is a list "
                "of booleans"});
  CHECK(ReportOf("{a: [true, false]}", {{"a", "[true]"}}).empty());
  CHECK(ReportOf("{a: [true, false]}", {{"a", "{each: {bernoulli: 0.5}, count: 7}"}}).empty());
  CHECK(ReportOf("{a: [true, false]}", {{"a", "[1, 0]"}}) ==
        Strings{"1:4 spec/wrong-type: parameter 'a' is a list of booleans, but '[1, 0]' is a "
                "list of numbers (the spec has 'a: [true, false]')"});
}

TEST_CASE("lists are parameters") {
  const auto part = [](const std::string& text) {
    return Load("mjforge: 1\nname: t\nparams: {l: [1, 2, 3, 4, 5]}\nparts:\n  - " + text + "\n")
        .Report();
  };
  CHECK(
      part("{name: a, type: sphere, size: l}").at(0).starts_with("5:35 expr/type: 'l' is a list"));
  CHECK(part("{name: a, type: sphere, size: {each: 1, count: 1}}").at(0) ==
        "5:36 spec/wrong-type: 'each' makes a list, which has no place here (a list is a "
        "parameter: name it under `params:`)");
  CHECK(part("{name: a, let: {m: l}, type: sphere, size: 1}").at(0) ==
        "5:24 spec/wrong-type: 'm' is a list; a local value is not (make it a parameter, and use "
        "its items here)");
  CHECK(
      part("{name: 'a${w}', for: {w: [1 .. 2]}, type: sphere, size: 1}").at(0) ==
      "5:30 spec/conflict: what a loop runs over cannot be drawn here (draw it as a parameter and "
      "use that parameter's name)");
}

TEST_CASE("settings of lists are lists, however short") {
  const std::string params = "{a: [1, 2, 3, 4, 5], b: [oak, pine], c: 'sum(a)', d: '${b[0]}'}";
  for (const std::string list : {"[1, 2]", "[7]", "[]", "{each: 1 .. 2, count: 3}"})
    CHECK(ReportOf(params, {{"a", list}}).empty());
  CHECK(ReportOf(params, {{"b", "[]"}}).empty());
  CHECK(ReportOf(params, {{"a", "3"}}) ==
        Strings{"1:4 spec/wrong-type: parameter 'a' is a list of numbers, but '3' is a number (the "
                "spec has 'a: [1, 2, 3, 4, 5]')"});
  CHECK(ReportOf(params, {{"a", "[oak]"}}) ==
        Strings{"1:4 spec/wrong-type: parameter 'a' is a list of numbers, but '[oak]' is a list of "
                "texts (the spec has 'a: [1, 2, 3, 4, 5]')"});
}

TEST_CASE("all mappings of a record have the same keys") {
  CHECK(
      ReportOf("{s: {choice: [{n: a, l: 1}, {n: b}, {n: c, l: 2, m: 3}]}, t: s.l}") ==
      Strings{"3:37 spec/missing-key: 'l' is missing here (all mappings of a choice have the same "
              "keys)",
              "3:58 spec/unknown-key: the first mapping of this choice has no 'm' (all mappings "
              "of a choice have the same keys)"});
  CHECK(ReportOf("{s: {choice: [{n: a, l: 1}, {n: b, l: oak}]}}") ==
        Strings{"3:47 spec/wrong-type: the values to choose from are of different kinds: a number "
                "and text"});
  CHECK(ReportOf("{s: {choice: [{n: a, x: 1}, {n: b, x: 2}]}}") ==
        Strings{"3:30 spec/bad-name: 's.x' would be a component of a vector; column 'x' needs "
                "another name"});
  CHECK(ReportOf("{s: {choice: [{n: a, l: 1}, {n: b, l: 2}], weights: k}}") ==
        Strings{"3:61 spec/unknown-key: no column 'k'",
                "3:61 spec/wrong-type: expected a list for 'weights', got 'k'"});
}

TEST_CASE("settings reach into records") {
  const std::string params =
      "{s: {choice: [{n: a, l: 1 .. 2}, {n: b, l: 2}]}, d: {choice: [{k: 3mm, l: 1}, {k: 4mm, l: "
      "2}]}, t: s.l + d.l}";
  for (const auto& [name, value] : {std::pair("s", "b"),
                                    {"s.n", "b"},
                                    {"s.l", "5"},
                                    {"s.l", "5 .. 6"},
                                    {"d", "4mm"},
                                    {"d.k", "0.004"},
                                    {"s", "{choice: [a, b], weights: [1, 2]}"}}) {
    INFO(name << "=" << value);
    CHECK(ReportOf(params, {{name, value}}).empty());
  }
  CHECK(ReportOf(params, {{"s", "c"}}) == Strings{"1:4 spec/bad-value: 'c' is not one of a, b"});
  CHECK(ReportOf(params, {{"d", "5mm"}}) ==
        Strings{"1:4 spec/bad-value: no row of 'd' has 0.005 (the rows are 3mm, 4mm)"});
  CHECK(ReportOf(params, {{"s.m", "1"}})
            .at(0)
            .starts_with("1:6 spec/unknown-parameter: 't' has no parameter 's.m'"));
}

TEST_CASE("a column of a record may use other parameters, and other columns") {
  CHECK(ReportOf("{w: 3, s: {choice: [{n: a, l: w, m: s.l}, {n: b, l: 2 * w, m: w}]}}").empty());
  CHECK(ReportOf("{s: {choice: [{n: a, l: s.m, m: s.l}, {n: b, l: 2, m: 3}]}}") ==
        Strings{"3:30 spec/cycle: parameters depend on each other: s.l -> s.m -> s.l"});
}

// The report of a spec with this table, and of the table.
Strings ReportOfTable(const std::string& table) {
  const harness::TemporaryFolder folder;
  folder.Write("t.csv", table);
  Loaded loaded;
  loaded.spec = LoadSpecText("t.yaml",
                             "mjforge: 1\nname: t\nparams: {c: {rows: t.csv}}\n"
                             "parts: [{name: a, type: sphere, size: c.r}]\n",
                             folder.path(), {}, loaded.sources, loaded.findings);
  return loaded.Report();
}

TEST_CASE("a table is a CSV file with a header") {
  CHECK(ReportOfTable("name,r [mm]\nM3,3\nM4,4\n").empty());
  CHECK(ReportOfTable("\xef\xbb\xbfname , r [mm]\r\n\"M3, long\" , 3 \r\n\r\n\"M\"\"4\",\"4\"")
            .empty());
  CHECK(ReportOfTable("r\n3\n3\n").empty());
  CHECK(ReportOfTable("r,name [text]\n3,1\n3,2\n").empty());
}

TEST_CASE("a column of numbers and texts is told, unless its header says that it is text") {
  const Strings mixed = ReportOfTable("name,s,r [mm]\nM3,3,3\nM4,4x,4\nM5,x,5\n");
  CHECK(mixed ==
        Strings{"3:4 spec/bad-table: column 's' is text, because '4x' is not a number (write `s "
                "[text]` in the header if this is meant)"});
  CHECK(ReportOfTable("name,s [text],r [mm]\nM3,3,3\nM4,4x,4\n").empty());
  CHECK(ReportOfTable("name,r [mm]\n3,3\nM4,4\n").empty());  // names
}

TEST_CASE("what is wrong in a table is told at its place") {
  CHECK(ReportOfTable("").at(0).starts_with("1:1 spec/bad-table: the table has no rows"));
  CHECK(ReportOfTable("name,r\n").at(0).starts_with("1:1 spec/bad-table: the table has no rows"));
  CHECK(ReportOfTable("name,r [mm]\nM3,nan\nM4,4,4\n") ==
        Strings{"3:1 spec/bad-table: the row has 3 cells, the header 2"});
  CHECK(ReportOfTable("name,r [mm]\nM3,nan\nM4,1e999\n") ==
        Strings{"2:4 spec/bad-table: 'nan' is not a number; the column's unit is mm",
                "3:4 spec/bad-table: '1e999' is not a number; the column's unit is mm"});
  CHECK(ReportOfTable("name,r [feet]\nM3,3\n")
            .at(0)
            .starts_with("1:6 expr/unknown-unit: unknown unit 'feet'"));
  CHECK(ReportOfTable("name,r\nM3,\"3\nM4,4\n")
            .at(0)
            .starts_with(
                "2:4 spec/bad-table: this cell has a quote in it, or one that is not closed"));
  CHECK(ReportOfTable("name,r\nM3,\"3\"4\n").at(0).starts_with("2:4 spec/bad-table"));
  CHECK(ReportOfTable("name,r\n${1},3\n") ==
        Strings{"2:1 spec/bad-table: a table has no expressions: ${ has no meaning"});
  CHECK(ReportOfTable("a b,r\n1,3\n").at(0).starts_with("1:1 spec/bad-name"));
  CHECK(ReportOfTable("r,r\n1,3\n").at(0).starts_with("1:3 spec/duplicate-name"));
  CHECK(ReportOfTable(std::string("r\n1\0\n", 5)) ==
        Strings{"1:1 spec/bad-table: the table is binary"});
  std::string large = "r\n";
  for (int i = 0; i < 200'001; ++i) large += "1\n";
  CHECK(ReportOfTable(large) ==
        Strings{"1:1 spec/bad-table: the table has more than 200000 cells"});
  CHECK(ReportOfTable(std::string(9 << 20, '1')) ==
        Strings{"1:1 spec/bad-table: the table has more than 8 MiB"});
}

TEST_CASE("a file's own parameters win over those that it imports") {
  const harness::TemporaryFolder folder;
  folder.Write("a.yaml", "mjforge: 1\nimport: b.yaml\nparams: {r: 1}\n");
  folder.Write("b.yaml", "mjforge: 1\nparams: {r: 2, q: 3}\n");
  Loaded loaded;
  loaded.spec = LoadSpecText("t.yaml",
                             "mjforge: 1\nname: t\nimport: a.yaml\n"
                             "parts: [{name: a, type: box, size: [r, q, 1]}]\n",
                             folder.path(), {}, loaded.sources, loaded.findings);
  CHECK(loaded.Report().empty());
  REQUIRE(loaded.spec != nullptr);
  CHECK(loaded.spec->FindParameter("r")->source == "1");
  CHECK(loaded.spec->FindParameter("q")->source == "3");
}

}  // namespace
}  // namespace mjforge::spec
