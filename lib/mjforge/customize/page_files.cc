// Files of the page of `mjforge customize`, which are compiled into the program.

#include <array>

#include "mjforge/customize/customize.h"

namespace mjforge::customize {

extern const std::string_view kPageHtml;
extern const std::string_view kPageCss;
extern const std::string_view kPageJs;

std::span<const PageFile> PageFiles() {
  static const std::array kFiles = {
      PageFile{"", "text/html; charset=utf-8", kPageHtml},
      PageFile{"page.css", "text/css; charset=utf-8", kPageCss},
      PageFile{"page.js", "text/javascript; charset=utf-8", kPageJs},
  };
  return kFiles;
}

}  // namespace mjforge::customize
