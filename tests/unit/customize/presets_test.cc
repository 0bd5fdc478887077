#include "mjforge/customize/presets.h"

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"

namespace mjforge::customize {
namespace {

TEST_CASE("names of presets are names of files") {
  CHECK(Presets::IsValidName("Tall_2-b"));
  for (const char* wrong : {"", "a/b", "..", "a b", ".a", "a.b"})
    CHECK_FALSE(Presets::IsValidName(wrong));
  CHECK_FALSE(Presets::IsValidName(std::string(61, 'a')));
}

TEST_CASE("a preset is a file beside the spec, which may be written again") {
  const harness::TemporaryFolder folder;
  const Presets presets(folder.path(), "lamp");
  diag::Findings findings;
  const std::vector<spec::Setting> settings = {{"height", "0.3"}};
  CHECK(presets.List().empty());
  CHECK(presets.Save("tall", settings, findings));
  CHECK(presets.Save("tall", settings, findings));
  CHECK(presets.Save("low", {}, findings));
  CHECK(findings.empty());
  CHECK(folder.Read("lamp.tall.params.yaml") ==
        "# Values for mjforge: --params lamp.tall.params.yaml\nheight: 0.3\n");
  CHECK(presets.List() == std::vector<std::string>{"low", "tall"});
}

TEST_CASE("a file of somebody else is not replaced") {
  const harness::TemporaryFolder folder;
  folder.Write("lamp.mine.params.yaml", "height: 1\n");
  diag::Findings findings;
  CHECK_FALSE(Presets(folder.path(), "lamp").Save("mine", {}, findings));
  CHECK(findings.HasErrors());
  CHECK(folder.Read("lamp.mine.params.yaml") == "height: 1\n");
}

TEST_CASE("other files are not listed, and a folder that cannot be read has none") {
  const harness::TemporaryFolder folder;
  for (const char* name :
       {"lamp.params.yaml", "lamp.yaml", "lamp2.a.params.yaml", "lamp.a.b.params.yaml"})
    folder.Write(name, "{}\n");
  CHECK(Presets(folder.path(), "lamp").List().empty());
  CHECK(Presets(folder / "none", "lamp").List().empty());
}

}  // namespace
}  // namespace mjforge::customize
