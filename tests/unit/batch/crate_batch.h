// Batches of a crate for tests.

#pragma once

#include <string>

#include "harness/temporary_folder.h"
#include "mjforge/batch/batch.h"

namespace mjforge::batch {

/// A box whose half size along z is drawn.
inline constexpr const char* kBoxSpec =
    "mjforge: 1\n"
    "name: crate\n"
    "params:\n"
    "  height: 0.1 .. 0.2\n"
    "  kind: {choice: [light, heavy]}\n"
    "parts:\n"
    "  - {name: body, type: box, size: [0.1, 0.1, height], density: 500}\n";

/// A box whose size is negative in about half of the variants.
inline constexpr const char* kUnluckySpec =
    "mjforge: 1\n"
    "name: crate\n"
    "params:\n"
    "  height: -0.1 .. 0.1\n"
    "parts:\n"
    "  - {name: body, type: box, size: [0.1, 0.1, height], density: 500}\n";

/// A box with a texture, wood.png.
inline constexpr const char* kWoodenSpec =
    "mjforge: 1\n"
    "name: crate\n"
    "params: {height: 0.1 .. 0.2}\n"
    "materials: {wood: {texture: {file: wood.png}}}\n"
    "parts: [{name: body, type: box, size: [0.1, 0.1, height], material: wood}]\n";

/// Returns a PNG of one pixel, followed by `end`, which makes different files.
std::string Png(char end);

/// Batches of one spec in a fresh folder.
class CrateBatch {
 public:
  explicit CrateBatch(const std::string& text);

  /// Returns a request for `count` variants with seed 1, without validation, to `output`, a path
  /// relative to the folder.
  Request Of(std::uint64_t count, const std::string& output, std::uint64_t per_archive = 10) const;
  Summary Make(const Request& request, const Observer& observer = {});
  /// Stops the batch once `count` variants are done.
  Summary MakeUpTo(Request request, std::uint64_t count);
  /// Returns the bytes of all files in a subfolder, by name.
  std::map<std::string, std::string> Bytes(const std::string& subfolder) const;
  /// Returns the text of the manifest of an output, decompressed.
  std::string ManifestText(const std::string& output) const;

  harness::TemporaryFolder folder;

 private:
  diag::Sources sources_;
  forge::Recipe recipe_;
};

}  // namespace mjforge::batch
