// Structures in a batch (classes of variants with equal elements and types): their number, their
// differences, and the parameters whose values tell them apart.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "json_output.h"
#include "mjforge/report/report.h"

namespace mjforge::app {

/// A field of the compiled model that differs between variants.
struct DifferingField {
  std::string name;                   // "geom_type"
  std::vector<std::string> elements;  // elements in which the first differing structure differs
  std::string example;                // "geom_type of 'handle' is cylinder, not box"
  bool is_coincidence = false;
  std::uint64_t variants = 0;  // number of variants that differ from the first variant
  std::vector<report::Separator> separators;
};

struct BatchStructures {
  /// Largest number of structures whose fields are compared, because comparing regenerates a
  /// variant of each structure.
  static constexpr std::size_t kMaxCompared = 100;

  std::vector<report::StructureTally> structures;
  std::uint64_t variants = 0;  // number of variants whose structure is known
  std::uint64_t more = 0;      // number of variants whose structures are not in the list
  std::vector<DifferingField> fields;
  std::string why_unknown;  // reason why fields could not be compared; empty if they were
  /// Parameters whose values tell the structures apart; set if fields could not be compared.
  std::vector<report::Separator> separators;
};

/// Compares the structures of a batch. Generates one variant of each structure again, from the spec
/// that the records name; `folder` is the folder of the manifest.
BatchStructures CompareStructures(const report::ManifestSummary& batch,
                                  const std::filesystem::path& folder);

/// Returns a line per field that differs: "geom_type differs in 32 of 64: handle_shape (...)".
std::vector<std::string> DifferencesText(const BatchStructures& batch);
/// Returns a table of the structures and the lines about fields; empty if there are no structures.
std::string StructuresText(const BatchStructures& batch);
/// Writes the members of a JSON object about structures and their differences.
void WriteStructures(diag::Json& json, const BatchStructures& batch);

}  // namespace mjforge::app
