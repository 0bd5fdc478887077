// Composition of images: sheets of several pictures with captions, labels, and overlays of one
// image on another.

#include "mjforge/picture/sheet.h"

#include <algorithm>
#include <cmath>

namespace mjforge::picture {
namespace {

constexpr int kGap = 12;          // pixels between tiles and around them
constexpr int kBelowCaption = 8;  // additional pixels between a caption and the tile below it

// Composites the pixel `top` over the pixel `below`.
void PutPixel(const std::uint8_t* top, std::uint8_t* below) {
  const int over = top[3];
  const int under = below[3] * (255 - over) / 255;
  const int alpha = over + under;
  for (int c = 0; c < 3; ++c) {
    const int mixed = top[c] * over + below[c] * under;
    // Treats opaque results separately, because dividing by a constant is several times as fast.
    const int mean = alpha == 255 ? (mixed + 127) / 255 : (mixed + alpha / 2) / alpha;
    below[c] = static_cast<std::uint8_t>(mean);
  }
  below[3] = static_cast<std::uint8_t>(alpha);
}

Image MakeImage(int width, int height) {
  Image image{width, height, {}};
  image.rgba.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  return image;
}

// Returns the number of columns of a nearly square sheet with the fewest empty places.
int ColumnsFor(int count) {
  const int square = static_cast<int>(std::ceil(std::sqrt(count)));
  int best = square;
  int least = count;
  for (int columns = square; columns <= square + 1 + square / 4; ++columns) {
    const int empty = (columns - count % columns) % columns;
    if (empty < least) {
      least = empty;
      best = columns;
    }
  }
  return best;
}

// Returns true if any pixel of a row is not transparent.
bool IsShown(const Image& image, int y) {
  const std::uint8_t* alpha = image.rgba.data() + 4 * std::ptrdiff_t{y * image.width} + 3;
  for (int x = 0; x < image.width; ++x, alpha += 4) {
    if (*alpha != 0) return true;
  }
  return false;
}

// Row of tiles in a sheet. The tiles are cropped: rows of pixels at their top and bottom in which
// no tile of the row shows anything are left out.
struct SheetRow {
  SheetRow(std::span<const Tile> tiles, int sheet_top) : top(sheet_top) {
    last = tiles.front().image.height;
    const auto shows = [&](int y) {
      return std::ranges::any_of(tiles, [&](const Tile& tile) { return IsShown(tile.image, y); });
    };
    while (first < last && !shows(first)) ++first;
    while (last > first && !shows(last - 1)) --last;
    for (const Tile& tile : tiles) lines = std::max(lines, tile.caption.size());
  }
  int height() const { return last - first; }

  int top;                // y of the cropped tiles in the sheet, pixels
  int first = 0;          // first row of pixels of the tiles that is shown
  int last = 0;           // row of pixels after the last row of the tiles that is shown
  std::size_t lines = 0;  // lines of the longest caption
};

Background::Color InkColor(const Background& background) {
  const int light = background.bottom[0] + background.bottom[1] + background.bottom[2];
  if (background.transparent || light > 3 * 110) return {40, 44, 52};
  return {235, 238, 242};
}

}  // namespace

void PutOver(const Image& top, int x, int y, Image& below) {
  const int first = std::max(0, -x);
  for (int row = std::max(0, -y); row < std::min(top.height, below.height - y); ++row) {
    const std::uint8_t* from = top.rgba.data() + 4 * std::ptrdiff_t{row * top.width + first};
    std::uint8_t* to = below.rgba.data() + 4 * std::ptrdiff_t{(y + row) * below.width + x + first};
    for (int column = first; column < std::min(top.width, below.width - x); ++column) {
      if (from[3] != 0) PutPixel(from, to);
      from += 4;
      to += 4;
    }
  }
}

// Places the labels in order. Moves each label below the earlier labels that it would cover.
void PutLabels(std::vector<PlacedText> labels, Image& image) {
  std::vector<PlacedText> put;
  for (PlacedText& label : labels) {
    const int width = label.text.width;
    const int height = label.text.height;
    label.x = std::clamp(label.x, 2, std::max(2, image.width - width - 2));
    label.y = std::clamp(label.y, 2, std::max(2, image.height - height - 2));
    for (bool moved = true; moved;) {
      moved = false;
      for (const PlacedText& other : put) {
        const bool apart = label.x + width <= other.x || other.x + other.text.width <= label.x ||
                           label.y + height <= other.y || other.y + other.text.height <= label.y;
        if (apart) continue;
        label.y = other.y + other.text.height + 1;
        moved = true;
      }
    }
    Image box = MakeImage(width, height);
    for (std::size_t i = 0; i < box.rgba.size(); ++i) box.rgba[i] = i % 4 == 3 ? 200 : 255;
    PutOver(label.text, 0, 0, box);
    PutOver(box, label.x, label.y, image);
    put.push_back(std::move(label));
  }
}

Image ContactSheet(Renderer& renderer, std::span<const Tile> tiles, const Background& background) {
  if (tiles.empty()) return {};
  const auto columns = static_cast<std::size_t>(ColumnsFor(static_cast<int>(tiles.size())));
  const Background::Color ink = InkColor(background);
  const int line_height = renderer.DrawText("x", ink).height;
  const int width = tiles.front().image.width;
  std::vector<SheetRow> rows;
  int height = kGap;
  for (std::size_t first = 0; first < tiles.size(); first += columns) {
    const SheetRow& row =
        rows.emplace_back(tiles.subspan(first, std::min(columns, tiles.size() - first)), height);
    height += row.height() + static_cast<int>(row.lines) * line_height + kGap;
    if (row.lines > 0) height += kBelowCaption;
  }
  Image sheet = MakeImage(static_cast<int>(columns) * (width + kGap) + kGap, height);
  PutBehind(background, sheet);
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    const SheetRow& row = rows[i / columns];
    const int left = kGap + static_cast<int>(i % columns) * (width + kGap);
    PutOver(tiles[i].image, left, row.top - row.first, sheet);
    int top = row.top + row.height();
    for (const std::string& line : tiles[i].caption) {
      const Image text = renderer.DrawText(line, ink);
      PutOver(text, left + std::max(0, (width - text.width) / 2), top, sheet);
      top += line_height;
    }
  }
  return sheet;
}

}  // namespace mjforge::picture
