#pragma once

// A manifest -> one HTML page that says what the batch is: what was asked for and
// what was drawn, what failed and why, and pictures of some of its objects. The
// page needs no network, no other file and no script; the same input gives the
// same bytes.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/manifest/manifest.h"
#include "mjforge/report/gather.h"

namespace mjforge::report {

struct Request {
  std::filesystem::path manifest;  // or one under construction
  std::string spec;                // if not the one that the records name
  /// At most as many variants are shown, and fewer if the page would grow past kMaxBytes.
  std::size_t shown = 200;
};

/// No page is larger, whatever the batch is.
inline constexpr std::size_t kMaxBytes = 10'000'000;

struct Thumbnail {
  std::string webp;
  int width = 0;  // pixels
  int height = 0;
};
/// Draws a small picture of a record's object; nothing if there is none. Called once for each
/// variant that is shown.
using Thumbnailer = std::function<std::optional<Thumbnail>(const manifest::Record&)>;

struct Page {
  std::string html;
  std::uint64_t variants = 0;
  std::size_t shown = 0;
  std::size_t without_picture = 0;  // of those shown, though they have a file
};

/// Reads the manifest once, in memory that does not depend on its length, and the shown variants'
/// objects. What keeps the page from being complete is a warning, which is also on the page; a line
/// that is not a record is an error, and the page is made from the others. Nothing, and a finding,
/// if there is nothing to read.
std::optional<Page> MakePage(const Request& request, const Thumbnailer& thumbnailer,
                             diag::Sources& sources, diag::Findings& findings);

/// True if nothing would be lost by writing a page to `file`: it does not exist, it is a
/// page made here, or `force` says so. Else a finding.
bool MayReplace(const std::filesystem::path& file, bool force, diag::Findings& findings);

}  // namespace mjforge::report
