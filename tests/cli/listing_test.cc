// Tests of `mjforge catalogue` and `mjforge schema`.

#include <catch2/catch.hpp>

#include "crate.h"
#include "harness/quick_settings.h"
#include "harness/source_folder.h"

namespace mjforge {
namespace {

TEST_CASE_METHOD(CrateTest, "catalogue lists the bundled specs with their descriptions") {
  const auto result = Run({"catalogue"});
  CHECK(result.status == 0);
  CHECK(result.err.empty());
  for (const char* name : {"containers/bin", "containers/mug", "fixtures/hook_frame",
                           "primitives/box", "shapes/cone", "tools/hammer"}) {
    CHECK(result.out.find("\n" + std::string(name) + "  ") != std::string::npos);
  }
}

TEST_CASE_METHOD(CrateTest, "catalogue lists the specs of MJFORGE_PATH, too") {
  folder().Write("mine/boxes/crate.yaml", kText);
  const auto result =
      Run({"catalogue", "--json"}, {}, {{"MJFORGE_PATH", (folder() / "mine").string()}});
  CHECK(result.status == 0);
  CHECK(result.out.find("{\"name\":\"boxes/crate\",\"description\":\"A box.\"}") !=
        std::string::npos);
}

TEST_CASE_METHOD(CrateTest, "catalogue finds words in names, descriptions and parameters") {
  folder().Write("mine/crate.yaml", kText);
  const std::map<std::string, std::string> path = {{"MJFORGE_PATH", (folder() / "mine").string()}};
  const auto names = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "catalogue");
    const auto result = Run(words, {}, path);
    CHECK(result.status == 0);
    std::vector<std::string> found;
    for (std::size_t at = result.out.find('\n') + 1; at < result.out.size();
         at = result.out.find('\n', at) + 1)
      found.push_back(result.out.substr(at, result.out.find(' ', at) - at));
    return found;
  };
  CHECK(names({"A BOX."}) == std::vector<std::string>{"crate"});
  CHECK(names({"tools/hammer"}) == std::vector<std::string>{"tools/hammer"});
  CHECK(names({"handle_length", "hammer"}) ==
        std::vector<std::string>{"robosuite/hammer", "tools/hammer"});
  CHECK(names({"Gas spring"}) ==
        std::vector<std::string>{"electronics/monitor_arm", "furniture/office_chair"});
  const auto none = Run({"catalogue", "--json", "xyz", "lid"}, {}, path);
  CHECK(none.status == 1);
  CHECK(none.out == "[]\n");
  CHECK(none.err ==
        "mjforge: error: no spec has 'xyz' and 'lid' [spec/not-found]\n"
        "  hint: `mjforge catalogue` lists all specs\n");
}

TEST_CASE_METHOD(CrateTest, "every spec that catalogue names can be checked") {
  const auto list = Run({"catalogue"});
  std::size_t line = list.out.find('\n') + 1;
  int count = 0;
  while (line < list.out.size()) {
    const std::string name = list.out.substr(line, list.out.find(' ', line) - line);
    const bool is_scene = name.starts_with("scenes/");  // which takes as long as ten objects
    std::vector<std::string> arguments = {"check", name, "-q", "-n", is_scene ? "1" : "5"};
    for (std::string& option : harness::QuickOptions(name)) arguments.push_back(std::move(option));
    const auto result = Run(std::move(arguments));
    INFO(name << ": " << result.err);
    CHECK(result.status == 0);
    CHECK(result.err.empty());
    ++count;
    line = list.out.find('\n', line) + 1;
  }
  CHECK(count >= 14);
}

TEST_CASE_METHOD(CrateTest, "schema prints the schemas that are checked in") {
  CHECK(Run({"schema"}).out ==
        harness::ReadFile(harness::SourceFolder() / "schemas/object.schema.json"));
  CHECK(Run({"schema", "object"}).out == Run({"schema"}).out);
  CHECK(Run({"schema", "manifest"}).out ==
        harness::ReadFile(harness::SourceFolder() / "schemas/manifest.schema.json"));
  CHECK(Run({"schema", "placement"}).out ==
        harness::ReadFile(harness::SourceFolder() / "schemas/placement.schema.json"));
  const auto result = Run({"schema", "other"});
  CHECK(result.status == 2);
  CHECK(result.err ==
        "mjforge: error: WHICH: 'other' is not one of object, manifest, placement\n"
        "  hint: see 'mjforge schema --help'\n");
}

}  // namespace
}  // namespace mjforge
