// Snapshots of specs behind the C interface.
#pragma once

#include <mutex>

#include "interface.h"
#include "mjforge/spec/spec.h"

/// Snapshot of a spec. The mutex is held while the spec is loaded, because loading may add files.
struct MjforgeSnapshot {
  std::mutex mutex;
  mjforge::spec::Snapshot snapshot;
};
