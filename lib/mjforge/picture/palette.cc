#include "mjforge/picture/palette.h"

#include <algorithm>

namespace mjforge::picture {
namespace {

// Pixels of one cell: how many, and the sums of their colors.
struct Cell {
  std::size_t number = 0;
  std::uint64_t count = 0;
  std::array<std::uint64_t, 3> sums = {};

  double Mean(std::size_t channel) const {
    return static_cast<double>(sums[channel]) / static_cast<double>(count);
  }
};
using Cells = std::span<Cell>;

struct Box {
  Cells cells;
  std::uint64_t count = 0;  // of pixels
  std::size_t channel = 0;  // in which its colors differ most
  double score = 0;         // by how much, and for how many pixels

  explicit Box(Cells all) : cells(all) {
    double width = 0;
    for (const Cell& cell : cells) count += cell.count;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto less = [c](const Cell& a, const Cell& b) { return a.Mean(c) < b.Mean(c); };
      const auto [low, high] = std::minmax_element(cells.begin(), cells.end(), less);
      if (high->Mean(c) - low->Mean(c) <= width) continue;
      width = high->Mean(c) - low->Mean(c);
      channel = c;
    }
    score = width * width * static_cast<double>(count);
  }

  Background::Color Mean() const {
    Background::Color color = {};
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint64_t sum = 0;
      for (const Cell& cell : cells) sum += cell.sums[c];
      color[c] = static_cast<std::uint8_t>((sum + count / 2) / count);
    }
    return color;
  }
};

// Median cut (P. Heckbert: Color image quantization for frame buffer display,
// SIGGRAPH 1982): the box that is worst is cut where half of its pixels are.
std::vector<Box> Cut(std::vector<Cell>& cells, std::size_t most) {
  std::vector<Box> boxes = {Box(cells)};
  while (boxes.size() < most) {
    const auto worst = std::max_element(
        boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.score < b.score; });
    if (worst->score <= 0) break;
    const Cells whole = worst->cells;
    const std::size_t c = worst->channel;
    std::stable_sort(whole.begin(), whole.end(),
                     [c](const Cell& a, const Cell& b) { return a.Mean(c) < b.Mean(c); });
    const std::uint64_t half = worst->count / 2;
    std::size_t at = 0;
    for (std::uint64_t sum = 0; at + 1 < whole.size() && sum + whole[at].count <= half; ++at)
      sum += whole[at].count;
    at = std::max<std::size_t>(at, 1);
    *worst = Box(whole.first(at));
    boxes.emplace_back(whole.subspan(at));
  }
  return boxes;
}

}  // namespace

Palette::Palette(std::span<const Image> images, std::size_t most) {
  nearest_.resize(std::size_t{1} << 3 * kBits);
  std::vector<Cell> all(nearest_.size());
  for (const Image& image : images) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      Cell& cell = all[CellOf(image.rgba.data() + i)];
      ++cell.count;
      for (std::size_t c = 0; c < 3; ++c) cell.sums[c] += image.rgba[i + c];
    }
  }
  std::vector<Cell> used;
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].number = i;
    if (all[i].count > 0) used.push_back(all[i]);
  }
  if (used.empty()) return;
  for (const Box& box : Cut(used, most)) {
    for (const Cell& cell : box.cells)
      nearest_[cell.number] = static_cast<std::uint8_t>(colors_.size());
    colors_.push_back(box.Mean());
  }
}

}  // namespace mjforge::picture
