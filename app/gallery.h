// Gallery of `mjforge catalogue --html`: an HTML index of specs, and a page for each spec.
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

/// Writes an index and a page for each spec to a folder. Each card has the name, the description
/// and the parameters (`words`) of a spec. A card with a problem gets no page. If a page cannot be
/// made, adds a finding, and a problem to the spec's card in the index.
ExitStatus WriteGallery(const GalleryOptions& options, std::vector<report::GalleryCard> cards,
                        Console& console);

}  // namespace mjforge::app
