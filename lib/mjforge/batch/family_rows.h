// Rows of families for the variants of a chunk, made by a worker.

#pragma once

#include <string>
#include <vector>

#include "mjforge/family/family.h"
#include "mjforge/forge/forge.h"

namespace mjforge::batch {

/// Collects the variants of a chunk as rows of one or several families.
class FamilyRows {
 public:
  /// Adds a valid variant to the rows of the family whose file is `file`. Returns false, after
  /// adding a finding, if the variant's arrays differ from the arrays of the file's first variant.
  bool Add(const forge::Variant& variant, const std::string& file, diag::Findings& findings);
  /// Ends the chunk and returns the bytes of all families, each after its header.
  std::string Take();

 private:
  struct Family {
    std::string file;
    family::Rows rows;
    std::uint64_t first = 0;  // index of the first variant
    std::string base;
  };
  std::vector<Family> families_;
};

}  // namespace mjforge::batch
