// Writing of families: .npz files with the numbers in which variants of one structure differ.

#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "mjforge/batch/batch.h"
#include "mjforge/family/family.h"

namespace mjforge::batch {

/// Writes the family of a batch, or one family for each structure. `rows` are the files that
/// contain the numbers of the batch's variants. `record` has the fields that all records of the
/// batch have in common; each family file contains these fields as facts. Returns the files, to
/// which the caller must give their final names; an empty list after adding a finding.
std::vector<std::unique_ptr<output::PartFile>> WriteFamilies(
    const output::Destination& destination, std::span<const std::filesystem::path> rows,
    const manifest::Record& record, const IndexRange& all, bool force, diag::Findings& findings);

}  // namespace mjforge::batch
