#ifndef MJFORGE_APP_FIND_BATCH_H_
#define MJFORGE_APP_FIND_BATCH_H_

#include <filesystem>
#include <optional>
#include <string>

#include "mjforge/diag/diag.h"

namespace mjforge::app {

/// The manifest of a batch as it is named on a command line: a manifest, the folder or the
/// archives it went to. Nothing, and a finding that says what was probably meant, if there is
/// none.
std::optional<std::filesystem::path> FindBatch(const std::string& what, diag::Findings& findings);

/// Where a page about a batch goes unless told: beside its manifest, "out/manifest.jsonl" ->
/// "out/report.html", "mugs.manifest.jsonl" -> "mugs.report.html".
std::filesystem::path PageOf(const std::filesystem::path& manifest);

}  // namespace mjforge::app

#endif  // MJFORGE_APP_FIND_BATCH_H_
