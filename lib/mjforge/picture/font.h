// Text as images, drawn in MuJoCo's own font.

#pragma once

#include <mujoco/mujoco.h>

#include <string_view>

#include "mjforge/engine/engine.h"
#include "mjforge/picture/picture.h"

namespace mjforge::picture {

/// MuJoCo's own font, so that pictures do not depend on the fonts of a machine. Needs a current
/// GlContext while it exists.
class Font {
 public:
  Font();
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// Draws a line of text; replaces characters other than ASCII by question marks.
  Image Draw(std::string_view text, const Background::Color& color);

 private:
  engine::Model model_;
  mjrContext context_;
};

}  // namespace mjforge::picture
