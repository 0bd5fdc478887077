#include <catch2/catch.hpp>

#include "mjforge/bytes/bytes.h"

namespace mjforge::bytes {
namespace {

// FIPS 180-4, examples of the NIST.
TEST_CASE("SHA-256 gives the values of the standard's examples") {
  CHECK(Sha256Of("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(Sha256Of("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(Sha256Of(std::string(1'000'000, 'a')) ==
        "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace mjforge::bytes
