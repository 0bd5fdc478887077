// Comparison of variants that are made in several orders and by several generators.

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "harness/temporary_folder.h"
#include "mjforge/forge/forge.h"

namespace mjforge::forge {

/// A spec that loads without errors; others are looked for among the bundled ones.
struct Loaded {
  explicit Loaded(const std::filesystem::path& file);

  diag::Sources sources;
  Recipe recipe;
};

/// Variants that MuJoCo does not look at.
Options Seeded(std::uint64_t seed);

/// Makes the variants `first` to `first + count - 1` in order, each into the memory of the one
/// before; then in reverse order, while all results are kept; and some of them alone, by generators
/// of their own. Fails the test if a byte of a file or a record differs. Returns how many are valid.
int ComparePure(Loaded& loaded, const Options& options, std::uint64_t first, std::uint64_t count);

/// Specs in a folder of their own, with one, inner.yaml, that they may bring.
class Written {
 public:
  Written();
  /// A file beside the spec.
  void Write(const std::string& name, const std::string& text) const { folder_.Write(name, text); }
  Loaded Load(const std::string& text) const { return Loaded(folder_.Write("spec.yaml", text)); }

 private:
  harness::TemporaryFolder folder_;
};

}  // namespace mjforge::forge
