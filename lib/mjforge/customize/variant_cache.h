// Cache of `mjforge customize`: keeps the texts of the spec's files and the last variant from one
// request of the page to the next.

#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/customize/page_request.h"
#include "mjforge/forge/forge.h"
#include "mjforge/picture/picture.h"

namespace mjforge::customize {

using forge::Validation;

/// A spec with settings, and one of the spec's variants.
struct ShownVariant {
  diag::Sources sources;
  diag::Findings spec_findings;
  std::optional<forge::Recipe> recipe;
  std::optional<forge::Variant> variant;
  Validation level = Validation::kNone;
  std::unique_ptr<picture::Subject> subject;  // null: there is nothing to draw
  std::vector<picture::Joint> joints;         // joints of the subject in the base pose

  /// Returns the findings of the spec and of the variant.
  diag::Findings Findings() const;
};

/// Loads a spec with settings and makes variants. Keeps the last variant. Keeps the texts of the
/// spec's files until a request has another revision.
class VariantCache {
 public:
  /// `place_seed`: that of all variants (Start::place_seed).
  VariantCache(std::string reference, std::vector<std::filesystem::path> search_path,
               std::optional<std::uint64_t> place_seed)
      : reference_(std::move(reference)),
        search_path_(std::move(search_path)),
        place_seed_(place_seed) {}

  /// Converts those settings of a request that are plain texts (Request::values) to YAML. A text
  /// that the spec would read as an expression, such as `pi` or `a + b`, becomes an expression
  /// whose value is this text: `${'a + b'}`.
  void QuoteTexts(Request& request);
  /// Returns the spec with the settings of the request, without making a variant; a variant of the
  /// last request with the same settings remains. The recipe is nullopt if the spec or a setting
  /// has errors.
  ShownVariant& LoadSpec(const Request& request);
  /// Returns the variant of the request, with at least the checks of `level`. The variant is
  /// nullopt if the spec or a setting has errors.
  ShownVariant& Make(const Request& request, Validation level);

  /// Returns the files on which the current spec and variant depend, including those that are
  /// missing.
  std::vector<std::filesystem::path> Files() const;

 private:
  void Renew(std::uint64_t revision);
  void FindNames(std::uint64_t revision);
  void MakeVariant(const Request& request, Validation level);
  void LoadSubject();

  std::string reference_;
  std::vector<std::filesystem::path> search_path_;
  std::optional<std::uint64_t> place_seed_;
  std::uint64_t revision_ = 0;
  // Names of the spec that expressions can use, and names of the parameters that choose among
  // constants; for QuoteTexts().
  std::optional<std::set<std::string, std::less<>>> names_;
  std::set<std::string> choices_;
  spec::Snapshot snapshot_;
  std::optional<picture::Loader> loader_ = std::make_optional<picture::Loader>();
  std::vector<std::filesystem::path> assets_;  // mesh and texture files of the last object
  std::string key_;                            // revision and settings of `shown_`; empty: no spec
  std::string variant_key_;  // seed and index of the variant in `shown_`; empty: no variant
  ShownVariant shown_;
};

}  // namespace mjforge::customize
