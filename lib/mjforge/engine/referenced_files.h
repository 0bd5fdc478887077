// Checks the files that an MJCF text refers to, and its meshes, before MuJoCo reads them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::engine {

/// An element that refers to a file that MuJoCo must not open, or a mesh that MuJoCo must not read.
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
/// exceeds bytes::kMaxPixels, because a small file may decode to very many pixels. A mesh, in a
/// file or in the text, is a fault if an index of a face is out of range or a number is not finite,
/// because MuJoCo 2.2 reads memory outside the mesh. Missing files are not faults, because MuJoCo
/// reports them. `folder` is the folder of the text.
std::optional<FileFault> FindFileFault(std::string_view text, const std::filesystem::path& folder);

}  // namespace mjforge::engine
