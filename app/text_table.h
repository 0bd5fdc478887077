// Tables for terminals.
#pragma once

#include <string>
#include <vector>

namespace mjforge::app {

/// A table whose columns are aligned and two spaces apart.
class TextTable {
 public:
  explicit TextTable(std::vector<std::string> header) : rows_{std::move(header)} {}

  /// Adds a row with one cell per column. Cells may contain text of unknown origin.
  void Add(std::vector<std::string> row);
  bool empty() const { return rows_.size() == 1; }
  /// Returns the table without columns that are empty in every row.
  std::string Render() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace mjforge::app
