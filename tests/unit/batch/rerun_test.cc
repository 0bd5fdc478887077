// Tests of running a batch again over a finished one.

#include <catch2/catch.hpp>

#include "crate_batch.h"

namespace mjforge::batch {
namespace {

TEST_CASE("a stopped batch leaves no manifest of the finished batch that it replaces") {
  const std::string output = GENERATE("", "/x.tar", "/x_%d.tar.zst");
  INFO(output);
  CrateBatch test(kBoxSpec);
  Request request = test.Of(500, "out" + output, 130);
  test.Make(request);
  request.variant.seed = 2;
  REQUIRE(test.MakeUpTo(request, 300).interrupted);
  for (const auto& [name, bytes] : test.Bytes("out")) {
    INFO(name);
    CHECK((name[0] == '.' || name.find("manifest") == std::string::npos));
  }
  Request whole = test.Of(500, "whole" + output, 130);
  whole.variant.seed = 2;
  test.Make(whole);
  request.resume = GENERATE(false, true);
  CHECK(test.Make(request).ok == 500);
  CHECK(test.Bytes("out") == test.Bytes("whole"));
}

TEST_CASE("a batch without a variant keeps the finished one") {
  const std::string output = GENERATE("", "/x.tar");
  CrateBatch test(kUnluckySpec);
  const auto is_made = [&](std::uint64_t index) {
    Request request = test.Of(1, "out" + output);
    request.first = index;
    return test.Make(request).ok == 1;
  };
  std::uint64_t bad = 0;
  while (is_made(bad)) ++bad;
  std::uint64_t good = 0;
  while (!is_made(good)) ++good;
  const auto before = test.Bytes("out");
  CHECK_FALSE(is_made(bad));
  CHECK(test.Bytes("out") == before);
}

TEST_CASE("a manifest stays hidden if a run without a variant follows an interrupted one") {
  CrateBatch test(kUnluckySpec);
  std::uint64_t bad = 0;
  const auto failing = [&](const std::string& output) {
    Request request = test.Of(1, output, 1);
    request.first = bad;
    return request;
  };
  while (test.Make(failing("other")).ok == 1) ++bad;
  const std::string output = GENERATE("out", "out/x_%d.tar");
  INFO(output);
  Request request = test.Of(500, output, 100);
  test.Make(request);
  request.variant.seed = 2;
  REQUIRE(test.MakeUpTo(request, 300).interrupted);
  CHECK(test.Make(failing(output)).ok == 0);
  CHECK_FALSE(std::filesystem::exists(request.destination.Manifest({})));
}

TEST_CASE("a manifest stays hidden where workers may have replaced files before the first result") {
  CrateBatch test(kBoxSpec);
  Request request = test.Of(500, "out");
  test.Make(request);
  test.folder.Write("out/crate_000000.xml", "mine");
  request.variant.seed = 2;
  CHECK(test.Make(request).done() == 0);
  CHECK_FALSE(std::filesystem::exists(test.folder / "out/manifest.jsonl"));
  request.force = true;
  request.resume = true;
  CHECK(test.Make(request).ok == 500);
  CHECK(std::filesystem::exists(test.folder / "out/manifest.jsonl"));
}

TEST_CASE("a batch that gets the same bytes keeps the time of its manifest where asked") {
  CrateBatch test(kBoxSpec);
  Request request = test.Of(30, "out");
  test.Make(request);
  const auto file = test.folder / "out/manifest.jsonl";
  const auto time = std::filesystem::last_write_time(file) - std::chrono::hours(1);
  std::filesystem::last_write_time(file, time);
  request.if_changed = true;
  test.Make(request);
  CHECK(std::filesystem::last_write_time(file) == time);
}

}  // namespace
}  // namespace mjforge::batch
