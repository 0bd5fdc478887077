// Small picture in a report or gallery.

#pragma once

#include <string>

namespace mjforge::report {

struct Thumbnail {
  std::string webp;
  int width = 0;  // pixels
  int height = 0;
};

}  // namespace mjforge::report
