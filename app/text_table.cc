// Rendering of tables for terminals: widths of columns, and columns left out.
#include "text_table.h"

#include <algorithm>
#include <utility>

#include "console.h"

namespace mjforge::app {
namespace {

// Returns the number of characters, which are all bytes except UTF-8 continuation bytes.
std::size_t Width(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, std::not_fn(diag::IsContinuation)));
}

}  // namespace

void TextTable::Add(std::vector<std::string> row) {
  std::ranges::transform(row, row.begin(), OneLine);
  rows_.push_back(std::move(row));
}

std::string TextTable::Render() const {
  std::vector<std::size_t> widths(rows_.front().size(), 0);  // 0: the column is left out
  for (std::size_t column = 0; column < widths.size(); ++column) {
    const bool used = std::any_of(rows_.begin() + 1, rows_.end(),
                                  [&](const auto& row) { return !row[column].empty(); });
    if (!used) continue;
    for (const auto& row : rows_) widths[column] = std::max(widths[column], Width(row[column]));
  }
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (widths[column] == 0) continue;
      line += row[column];
      line.append(widths[column] - Width(row[column]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace mjforge::app
