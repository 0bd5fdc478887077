// Comparison of variants that are made in several orders and by several generators.

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "harness/temporary_folder.h"
#include "mjforge/forge/forge.h"

namespace mjforge::forge {

/// A recipe that loads without errors. Specs that it nests are looked up among the bundled specs.
struct Loaded {
  explicit Loaded(const std::filesystem::path& file);

  diag::Sources sources;
  Recipe recipe;
};

/// Returns the files of all bundled specs.
std::vector<std::filesystem::path> BundledSpecs();

/// Returns the number of variants of a bundled spec to compare: `whole`, fewer under sanitizers,
/// and 1 of a scene, which takes as long as ten objects.
int CasesOf(const std::filesystem::path& spec, int whole);

/// Returns options for variants that are not loaded in MuJoCo.
Options Seeded(std::uint64_t seed);

/// Makes the variants `first` to `first + count - 1` three times: in reverse order, keeping all
/// results; in order, each in the memory of the previous one; and some of them alone, by generators
/// of their own. Fails the test if a byte of a file or a record differs. Returns the number of
/// valid variants.
int ComparePure(Loaded& loaded, const Options& options, std::uint64_t first, std::uint64_t count);

/// Specs in a temporary folder with a spec that they may nest, inner.yaml.
class SpecFolder {
 public:
  SpecFolder();
  /// Writes a file beside the spec.
  void Write(const std::string& name, const std::string& text) const { folder_.Write(name, text); }
  Loaded Load(const std::string& text) const { return Loaded(folder_.Write("spec.yaml", text)); }

 private:
  harness::TemporaryFolder folder_;
};

}  // namespace mjforge::forge
