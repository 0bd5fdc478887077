// Fixtures with a small valid spec.

#pragma once

#include "harness/command.h"

namespace mjforge {

/// Fixture with a small valid spec, crate.yaml, in a new folder.
class CrateTest : public harness::ProgramTest {
 protected:
  CrateTest() { folder().Write("crate.yaml", kText); }

  static constexpr const char* kText =
      "mjforge: 1\n"
      "name: crate\n"
      "description: A box.\n"
      "params:\n"
      "  height: {value: 0.1 .. 0.2, unit: m, doc: Half the height.}\n"
      "parts:\n"
      "  - {name: body, type: box, size: [0.1, 0.1, height], density: 500}\n";
};

/// Fixture with crate.yaml whose height is negative in about half of the variants.
class UnluckyCrateTest : public harness::ProgramTest {
 protected:
  UnluckyCrateTest() {
    folder().Write("crate.yaml",
                   "mjforge: 1\n"
                   "name: crate\n"
                   "params: {height: -0.1 .. 0.1}\n"
                   "parts: [{name: body, type: box, size: [0.1, 0.1, height]}]\n");
  }
};

}  // namespace mjforge
