#ifndef MJFORGE_APP_THUMBNAILS_H_
#define MJFORGE_APP_THUMBNAILS_H_

#include <filesystem>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/manifest/manifest.h"

namespace mjforge::app {

/// Small pictures of the objects of a batch.
class Thumbnails {
 public:
  Thumbnails(const std::filesystem::path& manifest, std::string spec, diag::Sources& sources);
  std::optional<std::string> Draw(const manifest::Record& record);
  diag::Findings TakeFindings();
};

}  // namespace mjforge::app

#endif  // MJFORGE_APP_THUMBNAILS_H_
