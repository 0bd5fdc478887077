#pragma once

#include "mjforge/picture/picture.h"

namespace mjforge::picture {

/// Puts `top` over `below` with its upper left corner at (x, y); what sticks out is cut off.
void PutOver(const Image& top, int x, int y, Image& below);

/// Texts in boxes near their places in the picture, moved apart so that all can be read.
struct PlacedText {
  Image text;
  int x = 0;
  int y = 0;
};
void PutLabels(std::vector<PlacedText> labels, Image& image);

}  // namespace mjforge::picture
