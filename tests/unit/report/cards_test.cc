#include "mjforge/report/cards.h"

#include <catch2/catch.hpp>

#include "report_records.h"

namespace mjforge::report {
namespace {

struct CardsTest {
  explicit CardsTest(std::uint64_t count = 20, std::uint64_t bad = 0)
      : batch{ManifestSummary(count), {}, {}, {}, {}} {
    for (std::uint64_t i = 0; i < count; ++i)
      batch.summary.Add(RecordOf(i, bad > 0 && i % bad == 0 ? "failed" : "ok"));
  }

  Cards Make(const Thumbnailer& thumbnailer, std::size_t room = 1'000'000) const {
    return MakeCards(batch.summary.Choose(), batch, {"out/manifest.jsonl", "", 200}, thumbnailer,
                     room);
  }

  Batch batch;
};

TEST_CASE("each variant has a row with its picture, values and how to make it again") {
  const Cards cards = CardsTest().Make([](const auto&) { return Picture(100); });
  CHECK(cards.shown() == 20);
  CHECK(cards.without_picture == 0);
  CHECK(Count(cards.html, "<tr ") == 20);
  CHECK(Count(cards.html, "src=\"data:image/webp;base64,eHh4") == 20);
  CHECK(Count(cards.html, "width=\"320\" height=\"240\"") == 20);
  CHECK(Count(cards.html, "alt=\"Variant 7: height 0.17, shape round\"") == 1);
  CHECK(Count(cards.html, "<code>mjforge replay out/manifest.jsonl:7</code>") == 1);
  CHECK(Count(cards.html, "data-mass=\"0.17\"") == 2);
}

TEST_CASE("a variant without a file misses no picture, one with a file does") {
  const Cards cards = CardsTest(20, 4).Make([](const auto&) { return std::nullopt; });
  CHECK(cards.failed == 5);
  CHECK(cards.sampled == 15);
  CHECK(cards.without_picture == 15);
  CHECK(Count(cards.html, "no picture: it has no file") == 5);
  CHECK(Count(cards.html, "data-codes=\"mujoco/error\"") == 5);
  CHECK(Count(cards.html, "it does not load") == 5);
}

TEST_CASE("cards keep within their room, spread over the batch") {
  const auto thumbnailer = [](const auto&) { return Picture(5000); };
  const Cards cards = CardsTest(64).Make(thumbnailer, 60'000);
  CHECK(cards.html.size() <= 60'000);
  CHECK(cards.shown() >= 6);
  CHECK(cards.left_out == 64 - cards.shown());
  CHECK(Count(cards.html, "<tr ") == cards.shown());
  CHECK(Count(cards.html, "id=\"variant-0\"") == 1);
  CHECK(Count(cards.html, "id=\"variant-32\"") == 1);
  CHECK(CardsTest().Make(thumbnailer, 0).shown() == 0);
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
