// Snapshots of specs behind the C interface.
#pragma once

#include <mutex>

#include "interface.h"
#include "mjforge/spec/spec.h"

/// Snapshot of a spec. The mutex guards it, because loading the spec may add the texts of files.
struct MjforgeSnapshot {
  std::mutex mutex;
  mjforge::spec::Snapshot snapshot;
};
