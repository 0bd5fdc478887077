// Collects the rows of families (.npz files) for the variants of a chunk, in a worker.

#pragma once

#include <string>
#include <vector>

#include "mjforge/family/family.h"
#include "mjforge/forge/forge.h"

namespace mjforge::batch {

/// Collects the numbers of a chunk's variants, one row per variant, for one or several families.
class FamilyRows {
 public:
  /// Adds a valid variant to the rows of the family whose file is `file`. Returns false, after
  /// adding a finding, if the variant's arrays differ from the arrays of the file's first variant.
  bool Add(const forge::Variant& variant, const std::string& file, diag::Findings& findings);
  /// Returns the rows collected so far as bytes, with a header before the rows of each family, and
  /// removes them from this object.
  std::string Take();

 private:
  struct Family {
    std::string file;
    family::ChunkEncoder rows;
    std::uint64_t first = 0;  // index of the first variant
    std::string base;
  };
  std::vector<Family> families_;
};

}  // namespace mjforge::batch
