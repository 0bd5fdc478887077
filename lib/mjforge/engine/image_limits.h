// Limits the total number of pixels in textures and height fields of a model.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mjforge::engine {

/// The texture or height field at which the total of a model's pixels exceeds bytes::kMaxPixels.
struct ImageFault {
  int line = 0;  // line in the model's text; 1 if an included file has the element
  std::string message;
};

/// Adds up the pixels of all images that a text of MJCF refers to, from the headers of their files,
/// because a small file may decode to very many pixels. `folder` is the folder of the text.
std::optional<ImageFault> FindOversizedImage(std::string_view text,
                                             const std::filesystem::path& folder);

}  // namespace mjforge::engine
