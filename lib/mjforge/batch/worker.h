// Options, snapshot path and task handler of the worker processes of a batch.

#pragma once

#include "mjforge/batch/batch.h"
#include "mjforge/batch/pool.h"

namespace mjforge::batch {

/// Returns the options with which the request's variants are made.
forge::Options OptionsOf(const Request& request);

/// Returns the path of the snapshot (copy of the spec, forge::Recipe::snapshot) beside the
/// manifest: DIR/manifest.spec.json or STEM.manifest.spec.json. All shards of a batch have one
/// snapshot.
std::filesystem::path SnapshotPath(const output::Destination& destination);

/// Makes a handler that makes the variants of a task and, if the destination is a folder, writes
/// them. Must be called in the worker, because it initializes MuJoCo. With `lists_variants`,
/// results contain ChunkResult::variants. The references must outlive the handler.
TaskHandler MakeTaskHandler(const forge::Recipe& recipe, diag::Sources& sources,
                            const Request& request, const output::OverwritePolicy& overwrite,
                            bool lists_variants);

}  // namespace mjforge::batch
