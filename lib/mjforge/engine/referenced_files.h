// Checks the files to which an MJCF text refers, and the meshes in files and text, before MuJoCo
// reads them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"

namespace mjforge::engine {

/// Reason to refuse an MJCF text before MuJoCo reads it: an element refers to an unsafe file, has a
/// faulty mesh, or exceeds the limit of pixels.
struct FileFault {
  diag::Code code = diag::Code::kYamlCannotRead;
  // Line and offset (bytes) of the element in the MJCF text; of the `<include>` if the element is
  // in an included file.
  int line = 0;
  std::size_t offset = 0;
  std::string message;
};

/// Returns the first fault of an MJCF text in the folder `folder`; nullopt if there is none. Files
/// that are not regular or are too large are faults, because opening a pipe waits and reading a
/// device may never end. The texture or height field with which the total of all pixels exceeds
/// bytes::kMaxPixels is a fault, because a small file may decode to very many pixels. A mesh, in a
/// file or in the text, is a fault if an index of a face is out of range or a number is not finite,
/// because MuJoCo 2.2 reads memory outside the mesh. Missing files are not faults, because MuJoCo
/// reports them.
std::optional<FileFault> FindFileFault(std::string_view text, const std::filesystem::path& folder);

}  // namespace mjforge::engine
