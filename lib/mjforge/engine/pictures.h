#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mjforge::engine {

/// A texture or height field, with which the pictures of a model get more than bytes::kMaxPixels.
struct PictureFault {
  int line = 0;  // of the model's text; 1 if it is in an included file
  std::string message;
};

/// Looks at the headers of all pictures that a text of MJCF names, before MuJoCo decodes them: a
/// small file may hold very many pixels. `folder` is that of the text.
std::optional<PictureFault> FindTooManyPixels(std::string_view text,
                                              const std::filesystem::path& folder);

}  // namespace mjforge::engine
