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
