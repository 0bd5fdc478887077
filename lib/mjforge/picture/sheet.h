// Composition of images: overlays and labels.

#pragma once

#include "mjforge/picture/picture.h"

namespace mjforge::picture {

/// Puts `top` over `below` with its upper left corner at (x, y), clipped to `below`.
void PutOver(const Image& top, int x, int y, Image& below);

/// A text, and its upper left corner in a picture.
struct PlacedText {
  Image text;
  int x = 0;
  int y = 0;
};
/// Draws texts in boxes at or near their places, without overlap.
void PutLabels(std::vector<PlacedText> labels, Image& image);

}  // namespace mjforge::picture
