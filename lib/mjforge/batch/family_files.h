// Files of the families of a batch.

#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "mjforge/batch/batch.h"
#include "mjforge/family/family.h"

namespace mjforge::batch {

/// Writes the family of a batch, or one for each structure, from files of rows. The records of the
/// batch have the fields of `record` in common, which become facts about the family. Returns the
/// files, which are still to be committed; none after adding a finding.
std::vector<std::unique_ptr<output::PartFile>> WriteFamilies(
    const output::Destination& destination, std::span<const std::filesystem::path> rows,
    const manifest::Record& record, const IndexRange& all, bool force, diag::Findings& findings);

}  // namespace mjforge::batch
