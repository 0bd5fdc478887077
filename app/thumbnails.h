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

/// Small WebP pictures of the objects of a batch: drawn from their files, or, for failed ones,
/// which have none, from the objects that the spec gives again.
class Thumbnails {
 public:
  /// `spec`: if not the one that the records name. The sources must outlive it.
  Thumbnails(std::filesystem::path manifest, std::string spec, diag::Sources& sources);

  /// Nothing if its file is gone, or if MuJoCo or the spec gives nothing to draw.
  std::optional<report::Thumbnail> Draw(const manifest::Record& record);

  /// Why there are no pictures at all, if so.
  diag::Findings TakeFindings() { return std::move(findings_); }

 private:
  bool Open();
  std::unique_ptr<picture::Subject> Load(const manifest::Record& record);
  std::unique_ptr<picture::Subject> LoadFromArchive(const manifest::Record& record);
  /// The recipe of the first record that it is called with: all records of a batch share it.
  const forge::Recipe* RecipeOf(const manifest::Record& record);
  /// The regenerated object, if there is one. `sha256`: only if its file has this hash; empty: any.
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
