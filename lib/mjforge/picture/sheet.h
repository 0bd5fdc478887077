// Composition of images: an image over another, and labels on an image.

#pragma once

#include "mjforge/picture/picture.h"

namespace mjforge::picture {

/// Puts `top` over `below` with its upper left corner at (x, y), clipped to `below`.
void PutOver(const Image& top, int x, int y, Image& below);

/// A text drawn as an image, and the position of its upper left corner in a picture, in pixels.
struct PlacedText {
  Image text;
  int x = 0;
  int y = 0;
};
/// Draws texts on translucent white boxes. Moves a text that would be cut off into the image, and a
/// text that would cover an earlier text below the earlier text.
void PutLabels(std::vector<PlacedText> labels, Image& image);

}  // namespace mjforge::picture
