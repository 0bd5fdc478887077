#include <algorithm>
#include <catch2/catch.hpp>

#include "mjforge/report/report.h"
#include "report_records.h"

namespace mjforge::report {
namespace {

bool Has(const std::string& text, std::string_view words) { return Count(text, words) > 0; }

GalleryCard CardOf(const std::string& name) {
  GalleryCard card;
  card.name = name;
  card.description = "About " + name;
  card.has_page = true;
  return card;
}

TEST_CASE("galleries list kinds by name, then reference objects, shapes and primitives") {
  std::vector<std::string> names = {"primitives/box", "loose",         "shapes/cone", "tools/b",
                                    "tools/a",        "robosuite/pot", "zoo/ape"};
  std::ranges::sort(names, IsBeforeInGallery);
  CHECK(names == std::vector<std::string>{"tools/a", "tools/b", "zoo/ape", "robosuite/pot",
                                          "shapes/cone", "primitives/box", "loose"});
}

TEST_CASE("an index has a section per kind and a card per spec") {
  std::vector<GalleryCard> cards = {CardOf("tools/a"), CardOf("tools/b"), CardOf("zoo/ape")};
  cards[0].words = "handle_length";
  cards[0].picture = Picture(100);
  cards[1].problem = "line 3: <wrong>";
  cards[1].has_page = false;
  const std::string index = MakeGalleryIndex(cards);
  CHECK(Has(index, "<h1>3 specs</h1>"));
  CHECK(Count(index, "<section class=\"kind\"") == 2);
  CHECK(Has(index, "<li><a href=\"#kind-2\">Zoo</a></li>"));
  CHECK(Count(index, "<li class=\"card\"") == 3);
  CHECK(Has(index, "data-words=\"tools/a About tools/a handle_length\""));
  CHECK(Count(index, "src=\"data:image/webp;base64,") == 1);
  CHECK(Has(index, "<h3>b</h3>"));
  CHECK(Has(index, "line 3: &lt;wrong&gt;"));
  CHECK(Has(index, "<a href=\"specs/zoo/ape.html\">ape</a>"));
  CHECK(Has(index, "script-src 'sha256-"));
  CHECK(MakeGalleryIndex(cards) == index);
}

TEST_CASE("an index of no specs says so") { CHECK(Has(MakeGalleryIndex({}), "<h1>0 specs</h1>")); }

TEST_CASE("texts of cards never become elements") {
  std::vector<GalleryCard> cards = {CardOf("a\"><img src=x>/<b>")};
  cards[0].words = "\"><i>";
  cards[0].facts = "<u>";
  cards[0].problem = "</script><script>";
  const std::string index = MakeGalleryIndex(cards);
  for (const char* element : {"<img src=x", "<b>", "<i>", "<u>", "<script><"})
    CHECK_FALSE(Has(index, element));
  CHECK(Has(index, "href=\"specs/a%22%3E%3Cimg%20src%3Dx%3E/%3Cb%3E.html\""));
}

}  // namespace
}  // namespace mjforge::report
