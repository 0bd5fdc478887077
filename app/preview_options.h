#ifndef MJFORGE_APP_PREVIEW_OPTIONS_H_
#define MJFORGE_APP_PREVIEW_OPTIONS_H_

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/picture/picture.h"
#include "options.h"

namespace mjforge::app {

/// What `preview` is told.
struct PreviewOptions {
  std::string what;  // a spec or FILE.xml
  std::uint64_t count = 1;
  std::uint64_t seed = 0;
  std::uint64_t first = 0;
  std::string output;
  std::string size;
  std::string layer = "visual";
  std::string background = "studio";
  std::vector<std::string> joints;  // name=expression
  bool sweep = false;
  bool force = false;
  SpecOptions spec;
  ReportOptions report;

  bool is_file() const { return what.ends_with(".xml"); }
};

void AddPreviewOptions(CLI::App& command, PreviewOptions& options);

/// Variants on one contact sheet.
inline constexpr std::uint64_t kMostTiles = 400;

/// The options as a renderer takes them; nothing, and why, if they contradict each other.
struct PreviewRequest {
  picture::Options picture;
  std::vector<std::pair<std::string, double>> joints;  // rad, m
};
std::optional<PreviewRequest> RequestOf(const PreviewOptions& options, std::string& why_not);

}  // namespace mjforge::app

#endif  // MJFORGE_APP_PREVIEW_OPTIONS_H_
