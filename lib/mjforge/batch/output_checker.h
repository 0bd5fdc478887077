// Checks that the files of a batch are as its seal and its records say.

#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/manifest/manifest.h"
#include "mjforge/output/output.h"

namespace mjforge::batch {

/// Returns the names in a folder in alphabetical order; adds a finding if the folder cannot be
/// read.
std::vector<std::string> NamesIn(const std::filesystem::path& folder, diag::Findings& findings);

/// Returns true if the size or, with `verify`, the checksum of the file in `folder` has the value
/// in the seal (list of a batch's files); otherwise adds a finding.
bool CheckSealed(const std::filesystem::path& folder, const manifest::SealedFile& file, bool verify,
                 diag::Findings& findings);

/// Adds a finding for a shard that has no manifest, which would have the path `manifest`.
void ReportMissingShard(const output::Shard& shard, const std::filesystem::path& manifest,
                        diag::Findings& findings);

/// Describes the first difference that shows that two shards belong to different batches: "count is
/// '80', not '100'". Empty if their seals can come from one batch.
std::string DifferenceOfShards(const manifest::Seal& seal, const manifest::Seal& other);
/// Adds the finding that a shard's manifest, or a line of it, belongs to another batch. `what`
/// names it.
void ReportOtherShard(std::string_view what, const std::string& difference,
                      diag::Findings& findings);

/// Compares the files of a folder with the hashes in records. Usually reads an asset only once,
/// although several objects use the asset.
class OutputChecker {
 public:
  OutputChecker(std::filesystem::path folder, bool verify)
      : folder_(std::move(folder)), verify_(verify) {}

  /// Returns true if the file of the record and its assets exist and are not empty or, with
  /// `verify`, have their hashes. Otherwise adds a finding; each asset is reported once.
  bool Check(const manifest::Record& record, diag::Findings& findings);

 private:
  bool CheckAssets(const manifest::Record& record, diag::Findings& findings);

  std::filesystem::path folder_;
  bool verify_;
  // Results of assets that were checked, by path and expected hash.
  std::map<std::pair<std::filesystem::path, std::string>, bool> assets_;
};

}  // namespace mjforge::batch
