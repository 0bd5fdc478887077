// Tests of quoting for shells.

#include <catch2/catch.hpp>

#include "mjforge/output/output.h"

namespace mjforge::output {
namespace {

TEST_CASE("a word is quoted for a shell if a shell would change it") {
  CHECK(ShellWord("handle_length=0.25") == "handle_length=0.25");
  CHECK(ShellWord("x=10cm .. 12cm") == "'x=10cm .. 12cm'");
  CHECK(ShellWord("") == "''");
  CHECK(ShellWord("a'b $(rm)") == "'a'\\''b $(rm)'");
}

}  // namespace
}  // namespace mjforge::output
