#include <algorithm>
#include <catch2/catch.hpp>

#include "loaded_recipe.h"
#include "mjforge/batch/batch.h"

namespace mjforge::forge {
namespace {

// A batch of three variants in crate/, beside its spec: the default output folder of `generate`.
struct ReplayTest {
  explicit ReplayTest(const char* text, const Options& options = {}, std::uint64_t count = 3,
                      spec::LoadOptions load = {})
      : loaded(text, std::move(load)) {
    batch::Request request;
    request.count = count;
    request.variant = options;
    request.variant.validation = Validation::kNone;
    request.destination = {.kind = output::Destination::Kind::kFolder,
                           .path = loaded.folder / "crate"};
    REQUIRE(batch::Run(loaded.recipe, loaded.sources, request, {}).ok > 0);
  }

  bool Replay(const std::string& what, const std::string& spec = {}) {
    findings.clear();
    diag::Sources sources;
    return forge::Replay({(loaded.folder / what).string(), spec}, sources, findings);
  }

  LoadedRecipe loaded;
  diag::Findings findings;
};

TEST_CASE("a variant is made again from its record and from its file") {
  spec::LoadOptions load;
  load.settings = {{"height", "0.15 .. 0.16"}};
  Options options;
  options.seed = 9;
  options.name = "box${index}";
  ReplayTest test(kBoxSpec, options, 3, load);
  CHECK(test.Replay("crate/manifest.jsonl:1"));
  CHECK(test.findings.empty());
  CHECK(test.Replay("crate/box2_000002.xml"));
  CHECK(test.findings.empty());
}

TEST_CASE("resampled variants are made again") {
  Options options;
  options.on_invalid = OnInvalid::kResample;
  ReplayTest test(kUnluckySpec, options, 10);
  for (int index = 0; index < 10; ++index) {
    CHECK(test.Replay("crate/manifest.jsonl:" + std::to_string(index)));
    CHECK(test.Replay("crate/crate_00000" + std::to_string(index) + ".xml"));
  }
}

TEST_CASE("variants of a planned batch are made again") {
  for (const sample::Method method : {sample::Method::kRandom, sample::Method::kSobol,
                                      sample::Method::kLatin, sample::Method::kGrid}) {
    Options options;
    options.sampler = method;
    options.batch = 5;
    ReplayTest test(kExactSpec, options, 5);
    std::string manifest = test.loaded.folder.Read("crate/manifest.jsonl");
    const std::string name(sample::MethodName(method));
    const bool named = manifest.find("\"sampler\":\"" + name + "\"") != std::string::npos;
    CHECK(named == (method != sample::Method::kRandom));
    CHECK(manifest.find("\"batch\":5,") != std::string::npos);
    for (int index = 0; index < 5; ++index) {
      CHECK(test.Replay("crate/manifest.jsonl:" + std::to_string(index)));
      CHECK(test.Replay("crate/crate_00000" + std::to_string(index) + ".xml"));
    }
    // Variants of this sampler depend on the size of the batch.
    for (std::size_t at = 0; (at = manifest.find("\"batch\":5,", at)) != std::string::npos; ++at) {
      manifest.replace(at, 10, "\"batch\":4,");
    }
    test.loaded.folder.Write("crate/manifest.jsonl", manifest);
    int same = 0;
    for (int index = 0; index < 5; ++index) {
      same += test.Replay("crate/manifest.jsonl:" + std::to_string(index)) ? 1 : 0;
    }
    CHECK(same == 0);
  }
}

TEST_CASE("a sampler that is not known is a finding") {
  Options options;
  options.sampler = sample::Method::kSobol;
  ReplayTest test(kBoxSpec, options);
  std::string manifest = test.loaded.folder.Read("crate/manifest.jsonl");
  manifest.replace(manifest.find("\"sobol\""), 7, "\"dice\"");
  test.loaded.folder.Write("crate/manifest.jsonl", manifest);
  CHECK_FALSE(test.Replay("crate/manifest.jsonl:0"));
  REQUIRE(test.findings.size() == 1);
  CHECK(test.findings[0].code == diag::Code::kOutputBadManifest);
  CHECK(test.findings[0].message.ends_with(
      "was made with sampler 'dice', which this version does not know"));
}

TEST_CASE("a file that was changed differs at a line") {
  ReplayTest test(kBoxSpec);
  std::string text = test.loaded.folder.Read("crate/crate_000001.xml");
  const std::size_t place = text.find("<geom");
  REQUIRE(place != std::string::npos);
  text.replace(place, 5, "<gone");
  const auto line = static_cast<std::uint32_t>(
      std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(place), '\n') + 1);
  test.loaded.folder.Write("crate/crate_000001.xml", text);
  CHECK_FALSE(test.Replay("crate/manifest.jsonl:1"));
  REQUIRE(test.findings.size() == 1);
  CHECK(test.findings[0].code == diag::Code::kOutputDiffers);
  CHECK(test.findings[0].mark.line == line);
  CHECK(test.findings[0].message.starts_with("line " + std::to_string(line) +
                                             " differs from the regenerated object: '<geom "));
}

TEST_CASE("a file that is gone is compared by its hash") {
  ReplayTest test(kBoxSpec);
  std::filesystem::remove(test.loaded.folder / "crate/crate_000001.xml");
  CHECK(test.Replay("crate/manifest.jsonl:1"));
}

TEST_CASE("a spec that changed since is not used") {
  ReplayTest test(kBoxSpec);
  const auto old_spec = test.loaded.folder.Write("old/crate.yaml", kBoxSpec);
  test.loaded.folder.Write("crate.yaml", std::string(kBoxSpec) + "# changed\n");
  CHECK_FALSE(test.Replay("crate/manifest.jsonl:1"));
  REQUIRE(test.findings.size() == 1);
  CHECK(test.findings[0].code == diag::Code::kOutputDiffers);
  CHECK(test.findings[0].hint == "pass the original spec with --spec");
  CHECK(test.Replay("crate/manifest.jsonl:1", old_spec.string()));
}

TEST_CASE("a failed variant fails again with the same finding") {
  ReplayTest test(kUnluckySpec, {}, 20);
  const std::string manifest = test.loaded.folder.Read("crate/manifest.jsonl");
  std::string_view rest = manifest;
  std::string why_not;
  auto record = manifest::ReadRecord(rest.substr(0, rest.find('\n')), why_not);
  while (record && record->status == manifest::Status::kOk) {
    rest.remove_prefix(rest.find('\n') + 1);
    record = manifest::ReadRecord(rest.substr(0, rest.find('\n')), why_not);
  }
  REQUIRE(record);
  CHECK_FALSE(test.Replay("crate/manifest.jsonl:" + std::to_string(record->index)));
  REQUIRE(test.findings.size() == 1);
  CHECK(test.findings[0].code == diag::Code::kModelBadValue);
  CHECK(test.findings[0].index == record->index);
}

TEST_CASE("a manifest that cannot be understood is a finding") {
  ReplayTest test(kBoxSpec);
  const auto place = [&](const char* name) { return (test.loaded.folder / name).string(); };
  CHECK_FALSE(test.Replay("crate/manifest.jsonl:77"));
  CHECK(test.findings[0].code == diag::Code::kOutputBadManifest);
  CHECK(test.findings[0].message ==
        "'" + place("crate/manifest.jsonl") + "' has no record with index 77");
  test.loaded.folder.Write("bad.jsonl", "{}\n");
  CHECK_FALSE(test.Replay("bad.jsonl:0"));
  CHECK(test.findings[0].message == "this line is not a record: it has no 'file'");
  test.loaded.folder.Write("bad.xml", "<mujoco/>\n");
  CHECK_FALSE(test.Replay("bad.xml"));
  CHECK(test.findings[0].code == diag::Code::kOutputBadManifest);
  CHECK(test.findings[0].message ==
        "'" + place("bad.xml") + "' does not start with mjforge's comment");
  CHECK_FALSE(test.Replay("none.jsonl:0"));
  CHECK(test.findings[0].code == diag::Code::kYamlCannotRead);
}

}  // namespace
}  // namespace mjforge::forge
