// Checks the files that an MJCF text refers to, before MuJoCo opens them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::engine {

/// An element that refers to a file that MuJoCo must not open.
struct FileFault {
  diag::Code code = diag::Code::kYamlCannotRead;
  // Place of the element in the model's text or, if an included file has the element, of the
  // include.
  int line = 0;
  std::size_t offset = 0;
  std::string message;
};

/// Returns the first fault among the files that a text refers to; nullopt if there is none. A fault
/// is a file that is not regular or is too large, because opening a pipe waits and reading a device
/// may never end. Another fault is the texture or height field at which the total of all pixels
/// exceeds bytes::kMaxPixels, because a small file may decode to very many pixels. Missing files
/// are not faults, because MuJoCo reports them. `folder` is the folder of the text.
std::optional<FileFault> FindFileFault(std::string_view text, const std::filesystem::path& folder);

}  // namespace mjforge::engine
