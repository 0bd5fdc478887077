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

/// Makes variants with moulds and without, and fails the test if a byte differs: of the file, the
/// record, or what is written again of the object. Returns how many came from a mould.
int Compare(Loaded& loaded, Options options, std::uint64_t first, std::uint64_t count);

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
