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
