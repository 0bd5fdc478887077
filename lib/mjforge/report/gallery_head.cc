// Head of the HTML pages of a gallery: hashes of style and script for the Content Security Policy,
// and URLs of other pages.

#include "mjforge/report/gallery_head.h"

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/forge/forge.h"

namespace mjforge::report {

extern const std::string_view kGalleryCss;
extern const std::string_view kGalleryJs;

namespace {

// Returns the source of a Content Security Policy that allows an element with this content:
// "'sha256-...'".
std::string HashSource(std::string_view content) {
  const std::string digits = bytes::Sha256Of(content);
  std::string hash;
  for (std::size_t i = 0; i < digits.size(); i += 2)
    hash += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
  return fmt::format("'sha256-{}'", Base64(hash));
}

}  // namespace

void AddHead(Dictionary& page) {
  static const std::string kCss = std::string(kPageCss) + std::string(kGalleryCss);
  static const std::string kPolicy = fmt::format(
      "default-src 'none'; img-src data:; style-src {}; script-src {}; base-uri "
      "'none'; form-action 'none'",
      HashSource(kCss), HashSource(kGalleryJs));
  Set(page, "VERSION", forge::Version());
  Set(page, "POLICY", kPolicy);
  Set(page, "CSS", kCss);
  Set(page, "JS", kGalleryJs);
}

std::string UrlOf(std::string_view path) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._~-";
  std::string url;
  for (const char c : path) {
    if (kPlain.find(c) != kPlain.npos) {
      url += c;
    } else {
      url += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return url;
}

}  // namespace mjforge::report
