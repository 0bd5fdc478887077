// Tests of the JSON Schema of records.

#include <catch2/catch.hpp>

#include "harness/source_folder.h"
#include "harness/temporary_folder.h"
#include "mjforge/manifest/manifest.h"

namespace mjforge::manifest {
namespace {

TEST_CASE("schemas/manifest.schema.json is fresh (mjforge schema manifest writes it)") {
  CHECK(harness::ReadFile(harness::SourceFolder() / "schemas/manifest.schema.json") ==
        ManifestSchema());
}

}  // namespace
}  // namespace mjforge::manifest
