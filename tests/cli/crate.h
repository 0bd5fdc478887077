#pragma once

#include "harness/command.h"

namespace mjforge {

/// A small good spec in crate.yaml of a fresh folder.
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

/// The same, whose height is below zero in about half of the variants.
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
