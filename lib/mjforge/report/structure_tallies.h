// Tallies of the structures (structure.h) of a batch's variants, and the parameters whose values
// tell variants of different structures apart.

#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mjforge/manifest/manifest.h"

namespace mjforge::report {

/// Values of a parameter, or of a component of a vector, in a group of variants.
struct ParameterExtent {
  /// Largest number of different values that are kept.
  static constexpr std::size_t kMaxValues = 24;

  std::string name;              // "shape", "size[0]"
  std::set<std::string> values;  // different texts, flags and whole numbers
  bool more_values = false;      // true: more than kMaxValues, or numbers that are not whole
  // Range of the values that are numbers; low > high if there are none.
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void Append(const ParameterExtent& other);
};

/// Relation of a parameter's values to a division of variants into groups.
enum class Separation {
  kNone,     // several groups may have the same value
  kByValue,  // no value occurs in several groups
  kByRange,  // the ranges of the numbers in the groups do not overlap
};

/// The variants of one structure: their number, and the values of their parameters.
struct StructureTally {
  std::string key;  // Record::structure
  std::uint64_t variants = 0;
  manifest::Record first;  // the first variant of this structure
  std::vector<ParameterExtent> params;

  void Add(const manifest::Record& record);
  void Append(const StructureTally& next);
};

/// Tallies of the structures of a batch, in the order of their first variants.
class StructureTallies {
 public:
  /// Largest number of different structures that are counted separately.
  static constexpr std::size_t kMaxStructures = 1000;

  void Add(const manifest::Record& record);
  void Append(const StructureTallies& next);

  const std::vector<StructureTally>& list() const { return list_; }
  /// Number of variants of structures beyond kMaxStructures.
  std::uint64_t more() const { return more_; }

 private:
  StructureTally* FindOrAdd(const std::string& key);

  std::vector<StructureTally> list_;
  std::map<std::string, std::size_t> numbers_;  // positions in the list, by key
  std::uint64_t more_ = 0;
};

/// Parameter whose values tell groups of variants apart: no value occurs in two groups, or the
/// ranges of the values in the groups do not overlap.
struct Separator {
  std::string parameter;
  Separation separation = Separation::kNone;
};
/// Returns the parameters whose values tell groups of structures apart. `groups[i]` is the number
/// of the group of `structures[i]`; structures with a negative number are ignored. Returns
/// parameters with Separation::kByRange only if there are none with kByValue, because the ranges of
/// a few variants may be disjoint by chance.
std::vector<Separator> SeparatorsOf(const std::vector<StructureTally>& structures,
                                    const std::vector<int>& groups);

}  // namespace mjforge::report
