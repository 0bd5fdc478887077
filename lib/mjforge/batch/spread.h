#ifndef MJFORGE_BATCH_SPREAD_H_
#define MJFORGE_BATCH_SPREAD_H_

#include "mjforge/batch/batch.h"

namespace mjforge::batch {

/// Warns where a sampler or an exact choice cannot cover the batch evenly: it begins in
/// the middle of a block, or a grid's points are not as many as its variants.
void CheckSpread(const forge::Recipe& recipe, const Request& request, diag::Findings& findings);

}  // namespace mjforge::batch

#endif  // MJFORGE_BATCH_SPREAD_H_
