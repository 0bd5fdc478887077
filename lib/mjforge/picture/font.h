// Text as images, drawn in MuJoCo's own font.

#pragma once

#include <string_view>

#include "mjforge/picture/model_context.h"
#include "mjforge/picture/picture.h"

namespace mjforge::picture {

/// MuJoCo's built-in font, which makes pictures independent of the fonts of a machine. A Font needs
/// a current GlContext while it exists.
class Font {
 public:
  Font();

  /// Draws a line of text on a transparent background. Replaces characters other than printable
  /// ASCII by question marks, and cuts off lines that are longer than about 1,000 pixels.
  Image Draw(std::string_view text, const Background::Color& color);

 private:
  RenderContext context_;
};

}  // namespace mjforge::picture
