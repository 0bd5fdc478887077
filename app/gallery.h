// The gallery of `mjforge catalogue --html`.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "console.h"
#include "mjforge/report/report.h"

namespace mjforge::app {

struct GalleryOptions {
  std::filesystem::path folder;
  std::uint64_t jobs = 0;  // 0: one process per core
  Seconds time_limit{600};
  bool force = false;  // overwrite files that mjforge did not make
};

/// Writes an index and a page for each spec to a folder. `cards` have names, descriptions and
/// words; cards with a problem get no page. A spec without a page becomes a finding and a problem
/// on the spec's card.
ExitStatus WriteGallery(const GalleryOptions& options, std::vector<report::GalleryCard> cards,
                        Console& console);

}  // namespace mjforge::app
