// Tests of snapshots as text.
#include "mjforge/spec/snapshot.h"

#include <catch2/catch.hpp>

namespace mjforge::spec {

TEST_CASE("a snapshot without a folder names the search path by absolute paths") {
  Snapshot snapshot;
  snapshot.spec = "-";
  snapshot.search_path = {"parts"};
  const std::optional<Snapshot> read = ReadSnapshot(SnapshotText(snapshot));
  REQUIRE(read);
  CHECK(read->search_path ==
        std::vector<std::filesystem::path>{std::filesystem::current_path() / "parts"});
}

}  // namespace mjforge::spec
