// Index page of a gallery: a card for each spec, grouped by kind (folder of the spec).

#include "mjforge/report/gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "mjforge/report/gallery_head.h"
#include "mjforge/report/templates.h"

namespace mjforge::report {
namespace {

constexpr std::size_t kMaxWords = 20'000;  // bytes of the text in which the search field searches

// Returns the first folder in a spec's name: "tools" of "tools/hammer"; empty if the name has no
// folder.
std::string KindOf(const std::string& name) {
  const std::size_t slash = name.find('/');
  return slash == name.npos ? "" : name.substr(0, slash);
}

std::string TitleOfKind(std::string kind) {
  if (kind.empty()) return "Others";
  kind[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(kind[0])));
  return Clean(kind);
}

// Returns the position, from 1 on, of a kind among the kinds that are listed last; 0 for other
// kinds.
int RankOf(const std::string& kind) {
  constexpr std::array<std::string_view, 3> kLast = {"robosuite", "shapes", "primitives"};
  const auto* found = std::ranges::find(kLast, kind);
  return found == kLast.end() ? 0 : static_cast<int>(found - kLast.begin()) + 1;
}

void AddCard(Dictionary& list, const GalleryCard& card) {
  Dictionary& shown = Section(list, "CARD");
  const std::string title = Clean(card.name.substr(card.name.find('/') + 1));
  const std::string description = Clean(card.description, 1000);
  Set(shown, "WORDS",
      Clean(fmt::format("{} {} {}", card.name, card.description, card.words), kMaxWords));
  Set(shown, "DESCRIPTION", description);
  ShowText(shown, "FACTS", card.facts);
  ShowText(shown, "PROBLEM", Clean(card.problem, 1000));
  if (card.picture) {
    Dictionary& picture = Section(shown, "PICTURE");
    SetPicture(picture, *card.picture);
    Set(picture, "ALT", fmt::format("A variant of {}", Clean(card.name)));
  } else {
    ShowText(shown, "NO_PICTURE", "no picture");
  }
  if (card.has_page) {
    Dictionary& link = Section(shown, "LINK");
    Set(link, "HREF", UrlOf(GalleryPageFile(card.name)));
    Set(link, "TITLE", title);
  } else {
    ShowText(shown, "NO_LINK", title);
  }
}

}  // namespace

std::string GalleryPageFile(const std::string& name) { return "specs/" + name + ".html"; }

bool IsBeforeInGallery(const std::string& a, const std::string& b) {
  const auto key = [](const std::string& name) {
    const std::string kind = KindOf(name);
    return std::tuple(kind.empty(), RankOf(kind), kind, name);
  };
  return key(a) < key(b);
}

std::string MakeGalleryIndex(std::span<const GalleryCard> cards) {
  ctemplate::TemplateDictionary page("gallery");
  AddHead(page);
  Set(page, "COUNT", CountText(cards.size(), "spec"));
  Dictionary* list = nullptr;
  std::size_t kinds = 0;
  for (std::size_t i = 0; i < cards.size(); ++i) {
    const std::string kind = KindOf(cards[i].name);
    if (list == nullptr || KindOf(cards[i - 1].name) != kind) {
      const std::string id = fmt::format("kind-{}", ++kinds);
      list = &Section(page, "KIND");
      for (Dictionary* place : {list, &Section(page, "KIND_LINK")}) {
        Set(*place, "ID", id);
        Set(*place, "TITLE", TitleOfKind(kind));
      }
    }
    AddCard(*list, cards[i]);
  }
  return Expand(TemplateName::kGallery, page);
}

}  // namespace mjforge::report
