// Simulation of piles: bodies that are released above a region and come to rest on each other.
#pragma once

#include <memory>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::physics {

/// Settles the piles of objects. Reuses the memory of mjData for the next object; a process needs
/// only one PileSettler.
class PileSettler {
 public:
  PileSettler();
  ~PileSettler();

  /// Simulates object.piles with the MuJoCo options of the object. The bodies of a pile are
  /// released one after the other from rest, each from a pose that touches nothing; all other
  /// bodies are held at their start. Tries up to four releases of each pile, which differ in the
  /// release poses of the bodies. Replaces the start of the bodies, and of the joints below them,
  /// by their state at rest. Adds findings about bodies that left the region, that still move after
  /// Pile::time, or that are too deep in another body. Returns false after an error.
  bool Settle(model::Object& object, diag::Findings& findings);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mjforge::physics
