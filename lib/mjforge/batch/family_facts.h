// Facts about a batch in the file of a family.

#pragma once

#include "mjforge/batch/batch.h"
#include "mjforge/family/family.h"

namespace mjforge::batch {

/// Returns the facts about a batch whose records have these fields in common.
family::Facts FactsOf(const manifest::Record& record, const IndexRange& all);

}  // namespace mjforge::batch
