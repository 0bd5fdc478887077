#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "mjforge/manifest/manifest.h"
#include "mjforge/report/report.h"

namespace mjforge::report {

/// A variant of a mug of some mass (kg) that is twice as high (m).
manifest::Record RecordOf(std::uint64_t index, const std::string& status = "ok");

/// A finding as a record holds it.
std::string FindingOf(const std::string& code, const std::string& message,
                      const std::string& severity = "error");

/// The text of a manifest with `count` of them, every `bad`-th failed (0: none).
std::string ManifestOf(std::uint64_t count, std::uint64_t bad = 0);

/// Returns the number of places at which the text contains the words.
std::size_t Count(const std::string& text, std::string_view words);

/// Returns a thumbnail of this size in bytes, which is no real image.
Thumbnail Picture(std::size_t bytes);

}  // namespace mjforge::report
