// The variants of a chunk as rows of a family, made by a worker.

#pragma once

#include <string>

#include "mjforge/family/family.h"
#include "mjforge/forge/forge.h"

namespace mjforge::batch {

class FamilyRows {
 public:
  /// Adds a valid variant. Returns false, after adding a finding, if its arrays differ from those
  /// of the chunk's first variant.
  bool Add(const forge::Variant& variant, diag::Findings& findings);
  /// Ends the chunk: returns the header of a file that begins with it, and its bytes.
  std::pair<std::string, std::string> Take();

 private:
  family::Rows rows_;
  std::uint64_t first_ = 0;  // index of the first variant
  std::string base_;
};

/// Adds the finding that a variant cannot be in one family with an earlier one.
void ReportOtherStructure(std::uint64_t index, std::uint64_t other, const std::string& difference,
                          diag::Findings& findings);

}  // namespace mjforge::batch
