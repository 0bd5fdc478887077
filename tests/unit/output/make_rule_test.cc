// Tests of rules for Make.

#include <catch2/catch.hpp>

#include "harness/command.h"
#include "harness/temporary_folder.h"
#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

TEST_CASE("a rule has its target and a file a line") {
  const std::vector<std::string> targets = {"x.xml"};
  CHECK(MakeRule(targets, {"b.yaml", "a.yaml"}, false) == "x.xml: \\\n  a.yaml \\\n  b.yaml\n");
  CHECK(MakeRule(targets, {"a.yaml"}, true) == "x.xml: \\\n  a.yaml\n\na.yaml:\n");
  CHECK(MakeRule(targets, {}, false) == "x.xml:\n");
}

TEST_CASE("names with blanks and signs of Make reach Make as they are") {
  const harness::TemporaryFolder folder;
  const std::set<std::string> files = {"a b.yaml", "c#d.yaml",  "e$f.yaml",         "p:q.yaml",
                                       "r%s.yaml", "$(g).yaml", "back\\slash.yaml", "h\\ i.yaml"};
  for (const std::string& file : files) folder.Write(file, "");
  const std::vector<std::string> targets = {EscapeForMake("o%ut: put.xml", true)};
  folder.Write("Makefile", MakeRule(targets, files, false) +
                               "\t@for f in $(foreach f,$+,'$f'); do echo \"$$f\"; done\n");
  // Make finds every file, so each name is escaped correctly.
  const auto result =
      harness::Command{
          .program = "make", .arguments = {"-r", "o%ut: put.xml"}, .folder = folder.path()}
          .Run();
  INFO(result.err);
  CHECK(result.status == 0);
  std::filesystem::remove(folder / "c#d.yaml");
  const auto missing =
      harness::Command{
          .program = "make", .arguments = {"-r", "o%ut: put.xml"}, .folder = folder.path()}
          .Run();
  CHECK(missing.err.find("No rule to make target 'c#d.yaml'") != std::string::npos);
}

TEST_CASE("names that Make cannot read in a rule are known") {
  for (const char* name : {"a;b", "a=b", "a|b", "a\nb", "a\\#b"}) CHECK_FALSE(FitsMake(name));
  for (const char* name : {"a b", "a#b", "a\\b", "$(a)", "a:b", "r%s"}) CHECK(FitsMake(name));
}

}  // namespace
}  // namespace mjforge::output
