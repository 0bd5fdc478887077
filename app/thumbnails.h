// Thumbnails of the variants on a report page.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/forge/forge.h"
#include "mjforge/picture/picture.h"
#include "mjforge/report/report.h"

namespace mjforge::app {

/// Small WebP pictures of the variants of a batch. Variants without a file of their own, such as
/// failed variants and members of archives, are made again from the spec.
class Thumbnails {
 public:
  /// Draws the variants of this manifest. `spec` replaces the spec named in the records, unless
  /// empty. `sources` must outlive this object.
  Thumbnails(std::filesystem::path manifest, std::string spec, diag::Sources& sources);

  /// Draws the variant of a record. Returns nullopt if there is no renderer, if a file or an
  /// archive that the record names is missing, or if the variant cannot be made again or drawn.
  std::optional<report::Thumbnail> Draw(const manifest::Record& record);

  /// Returns the reason, as warnings, why no pictures can be drawn at all; empty if pictures can be
  /// drawn.
  diag::Findings TakeFindings() { return std::move(findings_); }

 private:
  bool Open();
  std::unique_ptr<picture::Subject> Load(const manifest::Record& record);
  std::unique_ptr<picture::Subject> LoadFromArchive(const manifest::Record& record);
  /// Returns the recipe of the batch, which is loaded for the first record; null if the record
  /// belongs to another spec.
  const forge::Recipe* RecipeOf(const manifest::Record& record);
  /// Makes the object of a record again. Returns null on failure, or if `sha256` is not empty and
  /// differs from the hash of the new text.
  std::unique_ptr<picture::Subject> MakeAgain(const manifest::Record& record,
                                              const std::string& sha256);

  std::filesystem::path manifest_;
  std::string spec_;
  diag::Sources& sources_;
  diag::Findings findings_;
  bool opened_ = false;
  std::unique_ptr<picture::Renderer> renderer_;
  picture::Loader loader_;
  bool looked_for_recipe_ = false;
  std::optional<forge::Recipe> recipe_;
};

}  // namespace mjforge::app
