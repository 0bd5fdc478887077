#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "mjforge/diag/diag.h"
#include "mjforge/manifest/manifest.h"

namespace mjforge::batch {

/// The seal beside a manifest; nothing, and why, if there is none or it is damaged.
std::optional<manifest::Seal> ReadSealBeside(const std::filesystem::path& manifest,
                                             std::string& why_not);

/// Whether the file in `folder` is as its seal says: its size or, with `verify`, its bytes; else
/// why not.
bool MatchesSeal(const std::filesystem::path& folder, const manifest::SealedFile& file, bool verify,
                 std::string& why_not);

/// The same, with a finding if not.
bool CheckSealed(const std::filesystem::path& folder, const manifest::SealedFile& file, bool verify,
                 diag::Findings& findings);

/// What records say is in a folder. Assets that many share are read once.
class ObjectChecker {
 public:
  ObjectChecker(std::filesystem::path folder, bool verify)
      : folder_(std::move(folder)), verify_(verify) {}

  /// Whether the record's own file and its assets are there and not empty or, with `verify`, have
  /// their hashes. Else a finding, of each asset once.
  bool Check(const manifest::Record& record, diag::Findings& findings);

 private:
  bool CheckAssets(const manifest::Record& record, diag::Findings& findings);

  std::filesystem::path folder_;
  bool verify_;
  // Whether they were good, with the hashes that they should have.
  std::map<std::pair<std::filesystem::path, std::string>, bool> assets_;
};

}  // namespace mjforge::batch
