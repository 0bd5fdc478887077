#pragma once

#include "mjforge/batch/batch.h"
#include "mjforge/batch/pool.h"

namespace mjforge::batch {

/// How the request's variants are made.
forge::Options OptionsOf(const Request& request);

/// What a worker does with a task: makes its variants and, into a folder, writes them. Call it in
/// the worker, because it initializes MuJoCo. `lists_variants`: results say each variant's place.
/// The references must outlive it.
TaskHandler MakeTaskHandler(const forge::Recipe& recipe, diag::Sources& sources,
                            const Request& request, const output::OverwritePolicy& overwrite,
                            bool lists_variants);

}  // namespace mjforge::batch
