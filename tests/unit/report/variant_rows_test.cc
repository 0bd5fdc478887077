#include "mjforge/report/variant_rows.h"

#include <catch2/catch.hpp>

#include "report_records.h"

namespace mjforge::report {
namespace {

struct VariantRowsTest {
  explicit VariantRowsTest(std::uint64_t count = 20, std::uint64_t bad = 0)
      : batch{ManifestSummary(count), {}, {}, {}, {}} {
    for (std::uint64_t i = 0; i < count; ++i)
      batch.summary.Add(RecordOf(i, bad > 0 && i % bad == 0 ? "failed" : "ok"));
  }

  VariantRows Make(const Thumbnailer& thumbnailer, std::size_t room = 1'000'000) const {
    return MakeVariantRows(batch.summary.Choose(), batch, {"out/manifest.jsonl", "", 200},
                           thumbnailer, room);
  }

  Batch batch;
};

TEST_CASE("each variant has a row with its picture, values and how to make it again") {
  const VariantRows rows = VariantRowsTest().Make([](const auto&) { return Picture(100); });
  CHECK(rows.shown() == 20);
  CHECK(rows.without_picture == 0);
  CHECK(Count(rows.html, "<tr ") == 20);
  CHECK(Count(rows.html, "src=\"data:image/webp;base64,eHh4") == 20);
  CHECK(Count(rows.html, "width=\"320\" height=\"240\"") == 20);
  CHECK(Count(rows.html, "alt=\"Variant 7: height 0.17, shape round\"") == 1);
  CHECK(Count(rows.html, "<code>mjforge replay out/manifest.jsonl:7</code>") == 1);
  CHECK(Count(rows.html, "data-mass=\"0.17\"") == 2);
}

TEST_CASE("a variant without a file misses no picture, one with a file does") {
  const VariantRows rows = VariantRowsTest(20, 4).Make([](const auto&) { return std::nullopt; });
  CHECK(rows.failed == 5);
  CHECK(rows.sampled == 15);
  CHECK(rows.without_picture == 15);
  CHECK(Count(rows.html, "no picture: it has no file") == 5);
  CHECK(Count(rows.html, "data-codes=\"mujoco/error\"") == 5);
  CHECK(Count(rows.html, "it does not load") == 5);
}

TEST_CASE("rows keep within their room, spread over the batch") {
  const auto thumbnailer = [](const auto&) { return Picture(5000); };
  const VariantRows rows = VariantRowsTest(64).Make(thumbnailer, 60'000);
  CHECK(rows.html.size() <= 60'000);
  CHECK(rows.shown() >= 6);
  CHECK(rows.left_out == 64 - rows.shown());
  CHECK(Count(rows.html, "<tr ") == rows.shown());
  CHECK(Count(rows.html, "id=\"variant-0\"") == 1);
  CHECK(Count(rows.html, "id=\"variant-32\"") == 1);
  CHECK(VariantRowsTest().Make(thumbnailer, 0).shown() == 0);
}

TEST_CASE("a command is quoted for the shell where it needs it") {
  CHECK(ReplayCommand({"out/manifest.jsonl", ""}, 42) == "mjforge replay out/manifest.jsonl:42");
  CHECK(ReplayCommand({"my out/manifest.jsonl", ""}, 1) ==
        "mjforge replay 'my out/manifest.jsonl:1'");
  CHECK(ReplayCommand({"it's/m.jsonl", ""}, 1) == "mjforge replay 'it'\\''s/m.jsonl:1'");
  CHECK(ReplayCommand({"m.jsonl", "old x.yaml"}, 1) ==
        "mjforge replay m.jsonl:1 --spec 'old x.yaml'");
}

}  // namespace
}  // namespace mjforge::report
