// Snapshots of specs behind the C interface.
#pragma once

#include <mutex>

#include "interface.h"
#include "mjforge/spec/spec.h"

/// The mutex is held while a spec is loaded from the snapshot, because the load may add files.
struct MjforgeSnapshot {
  std::mutex mutex;
  mjforge::spec::Snapshot snapshot;
};
