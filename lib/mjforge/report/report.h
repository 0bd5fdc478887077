// HTML report about a batch, made from its manifest, and pages about specs (gallery.h).
//
// A report shows the expected and the drawn values of the parameters, the findings, and pictures of
// some of the objects. A report is a single file, which can be read without network and scripts.
// Equal input gives equal bytes.

#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/manifest/manifest.h"
#include "mjforge/report/gallery.h"
#include "mjforge/report/manifest_summary.h"
#include "mjforge/report/thumbnail.h"

namespace mjforge::report {

struct Request {
  std::filesystem::path manifest;  // complete or under construction
  std::string spec;                // empty: the spec that the records name
  /// Maximum number of variants shown; fewer are shown if the page would exceed kMaxBytes.
  std::size_t shown = 200;
};

/// Maximum size of a page, bytes.
inline constexpr std::size_t kMaxBytes = 10'000'000;

/// Function that draws a small picture of a record's object; returns nullopt if there is no object.
/// Called once for each variant that is shown.
using Thumbnailer = std::function<std::optional<Thumbnail>(const manifest::Record&)>;

struct Page {
  std::string html;
  std::uint64_t variants = 0;
  std::size_t shown = 0;
  std::size_t without_picture = 0;  // shown variants that have a file but no picture
};

/// Reads the manifest once, in memory that does not depend on the manifest's length, and makes a
/// page. Adds a warning for everything that is missing from the page; the page shows it, too. Adds
/// errors for the first of the lines that are not records; makes the page from the other lines.
/// Returns nullopt, and adds a finding, if the manifest cannot be read or has lines but no records.
std::optional<Page> MakePage(const Request& request, const Thumbnailer& thumbnailer,
                             diag::Sources& sources, diag::Findings& findings);

/// Returns true if `file` may be overwritten: it does not exist, it is a page made by mjforge, or
/// `force` is true. Otherwise adds a finding.
bool MayReplace(const std::filesystem::path& file, bool force, diag::Findings& findings);

}  // namespace mjforge::report
