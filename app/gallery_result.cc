// Encoding of results for the specs of a gallery, which child processes send to their parent.
#include <stdexcept>
#include <string_view>
#include <tuple>

#include "gallery_page.h"
#include "mjforge/bytes/bytes.h"

namespace mjforge::app {
namespace {

// Members of the structs in a result, in the order of their encoding.
struct Fields {
  static auto Of(report::Thumbnail& picture) {
    return std::tie(picture.webp, picture.width, picture.height);
  }
  static auto Of(report::GalleryCard& card) {
    return std::tie(card.facts, card.problem, card.has_page, card.picture);
  }
  static auto Of(diag::Finding& finding) {
    return std::tie(finding.code, finding.message, finding.hint);
  }
  static auto Of(GalleryResult& result) { return std::tie(result.card, result.finding); }
};

}  // namespace

std::string GalleryResult::Pack() const { return bytes::Encode<Fields>(*this); }

GalleryResult GalleryResult::Unpack(std::string_view bytes) {
  try {
    return bytes::Decoder<Fields>(bytes).Read<GalleryResult>();
  } catch (const std::runtime_error&) {
    // A message to the parent process has a limited size: a text in the result was too long.
    GalleryResult result;
    result.card.problem = "a text is too long";
    return result;
  }
}

}  // namespace mjforge::app
