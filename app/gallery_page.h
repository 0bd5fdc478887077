// Pages of specs for `mjforge catalogue --html`.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/picture/picture.h"
#include "mjforge/report/report.h"

namespace mjforge::app {

/// Result for one spec of a gallery.
struct GalleryResult {
  report::GalleryCard card;
  std::optional<diag::Finding> finding;  // without a place; an error if there is no page

  /// Encodes the result as bytes, which a child process sends to its parent.
  std::string Pack() const;
  static GalleryResult Unpack(std::string_view bytes);
};

/// Makes variants of specs, draws them, and writes a page for each spec.
class GalleryPages {
 public:
  /// `folder` is the folder of the gallery.
  explicit GalleryPages(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Makes the page of a spec in the search path. The card in the result has no description.
  GalleryResult Make(const std::string& name);

 private:
  picture::Renderer* OpenRenderer(diag::Findings& findings);

  std::filesystem::path folder_;
  bool is_opened_ = false;
  std::unique_ptr<picture::Renderer> renderer_;  // null: not opened yet, or not available
};

}  // namespace mjforge::app
