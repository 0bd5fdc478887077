// Pages of a gallery of specs: an index with a card for each spec, and a page for each spec.
//
// Each page contains its pictures, style and script, and needs no network. Equal input gives equal
// bytes.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mjforge/forge/forge.h"
#include "mjforge/manifest/manifest.h"
#include "mjforge/report/thumbnail.h"

namespace mjforge::report {

struct GalleryPicture {
  Thumbnail image;
  std::string alt;      // text for readers who do not see the picture
  std::string caption;  // shown below the picture
};

/// Pictures of an object with a joint at positions from one end of its range to the other.
struct Film {
  std::string joint;
  std::vector<GalleryPicture> frames;
};

/// A property of an object: name and value.
using Fact = std::pair<std::string, std::string>;

/// A table of features of an object, such as its joints.
struct FeatureTable {
  std::string title;
  std::vector<Fact> rows;
};

/// Content of the page of a spec.
struct SpecPage {
  std::string name;  // name in the search path: "tools/hammer"
  forge::Recipe recipe;
  std::string text;  // content of the spec's file; empty: not shown
  std::vector<manifest::Record> variants;
  std::optional<GalleryPicture> large;
  std::vector<GalleryPicture> tiles;
  std::vector<Film> films;
  std::vector<Fact> facts;
  std::vector<FeatureTable> features;
  std::vector<std::string> notices;  // texts about missing variants and pictures
};
std::string MakeSpecPage(SpecPage page);

/// A card in the index of a gallery.
struct GalleryCard {
  std::string name;  // name in the search path: "tools/hammer"
  std::string description;
  std::string words;    // other texts by which the index's search field finds the card
  std::string facts;    // "1.2 to 3.4 kg, 2 joints"
  std::string problem;  // reason why there is no object; empty: there is an object
  bool has_page = false;
  std::optional<Thumbnail> picture;
};
/// Makes the HTML of the index. Cards of one kind must be adjacent; the kind is the first folder in
/// the name.
std::string MakeGalleryIndex(std::span<const GalleryCard> cards);

/// Returns the file of the page of a spec, relative to the folder of the index:
/// "specs/tools/hammer.html".
std::string GalleryPageFile(const std::string& name);

/// Returns true if the spec with the name `a` is listed before `b` in galleries. The kinds of specs
/// (folders) are in alphabetical order, except that robosuite, shapes and primitives come after all
/// other kinds. Specs without a folder come last.
bool IsBeforeInGallery(const std::string& a, const std::string& b);

}  // namespace mjforge::report
