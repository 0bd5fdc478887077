// Results for the specs of a gallery as bytes, which child processes send.
#include <charconv>
#include <string_view>

#include "gallery_page.h"

namespace mjforge::app {
namespace {

// Appends texts and numbers to bytes; each item begins with its length.
class Packer {
 public:
  void Add(std::string_view text) {
    bytes_ += std::to_string(text.size()) + ':' + std::string(text);
  }
  void Add(int number) { Add(std::to_string(number)); }
  std::string Take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

// Reads texts and numbers in the order of Packer::Add. Missing texts are empty, missing numbers 0.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  std::string Text() {
    const std::size_t colon = bytes_.find(':');
    if (colon == bytes_.npos) return {};
    const auto size = static_cast<std::size_t>(Number(bytes_.substr(0, colon)));
    std::string text(bytes_.substr(colon + 1, size));
    bytes_.remove_prefix(colon + 1 + text.size());
    return text;
  }
  int Number() { return Number(Text()); }

 private:
  static int Number(std::string_view digits) {
    int number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
  }

  std::string_view bytes_;
};

}  // namespace

std::string GalleryResult::Pack() const {
  Packer packer;
  for (const std::string* text : {&card.facts, &card.problem}) packer.Add(*text);
  packer.Add(card.has_page ? 1 : 0);
  packer.Add(card.picture ? card.picture->webp : "");
  packer.Add(card.picture ? card.picture->width : 0);
  packer.Add(card.picture ? card.picture->height : 0);
  packer.Add(finding ? static_cast<int>(finding->code) : -1);
  packer.Add(finding ? finding->message : "");
  packer.Add(finding ? finding->hint : "");
  return packer.Take();
}

GalleryResult GalleryResult::Unpack(std::string_view bytes) {
  Unpacker unpacker(bytes);
  GalleryResult result;
  for (std::string* text : {&result.card.facts, &result.card.problem}) *text = unpacker.Text();
  result.card.has_page = unpacker.Number() == 1;
  report::Thumbnail picture{unpacker.Text(), 0, 0};
  picture.width = unpacker.Number();
  picture.height = unpacker.Number();
  if (!picture.webp.empty()) result.card.picture = std::move(picture);
  const int code = unpacker.Number();
  if (code < 0) return result;
  result.finding.emplace();
  result.finding->code = static_cast<diag::Code>(code);
  result.finding->message = unpacker.Text();
  result.finding->hint = unpacker.Text();
  return result;
}

}  // namespace mjforge::app
