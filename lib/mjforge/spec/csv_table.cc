// Reader of CSV tables: the CSV parser, and columns with their types, units and checks.

#include "mjforge/spec/csv_table.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mjforge/expr/expr.h"
#include "mjforge/spec/value_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;
using diag::SourceMark;

constexpr std::size_t kMaxCells = 200'000;

struct TableCell {
  std::string text;
  SourceMark mark;
};
using TableRow = std::vector<TableCell>;

// Parser of CSV according to RFC 4180. In addition, lines may end with LF or CR alone, empty lines
// are skipped, and blanks around a cell are removed.
class CsvParser {
 public:
  CsvParser(std::string_view text, SourceMark start)
      : text_(text), here_(start), cell_mark_(start) {}

  // Parses the text. Returns false if the cell at cell_mark() is not valid.
  bool Run() {
    for (Skip(" \t\r\n"); at_ < text_.size(); Skip(" \t\r\n")) {
      rows_.emplace_back();
      do {
        Skip(" \t");
        cell_mark_ = here_;
        std::optional<std::string> cell = Peek() == '"' ? TakeQuoted() : TakePlain();
        if (!cell) return false;
        rows_.back().push_back({*std::move(cell), cell_mark_});
        if (++count_ > kMaxCells) return true;
      } while (Take(1) == ",");
    }
    return true;
  }

  SourceMark cell_mark() const { return cell_mark_; }
  bool has_too_many() const { return count_ > kMaxCells; }
  std::vector<TableRow>& rows() { return rows_; }

 private:
  char Peek() const { return at_ < text_.size() ? text_[at_] : '\n'; }

  std::optional<std::string> TakePlain() {
    const std::string_view cell = Take(text_.find_first_of(",\r\n\"", at_) - at_);
    return Peek() == '"' ? std::nullopt : std::optional(std::string(Trim(cell)));
  }

  std::optional<std::string> TakeQuoted() {
    std::string cell;
    do {
      const std::size_t quote = text_.find('"', at_ + 1);
      if (quote == text_.npos) return std::nullopt;
      // The appended piece begins with a quote: the opening quote or, after a doubled quote (""),
      // the second of the two, which is part of the cell.
      cell += Take(quote - at_);
      Take(1);
    } while (Peek() == '"');
    Skip(" \t");
    const bool has_ended = Peek() == ',' || Peek() == '\r' || Peek() == '\n';
    return has_ended ? std::optional(cell.substr(1)) : std::nullopt;
  }

  void Skip(std::string_view blanks) { Take(text_.find_first_not_of(blanks, at_) - at_); }

  // Takes the next `count` bytes of the text, or all remaining bytes if there are fewer.
  std::string_view Take(std::size_t count) {
    const std::string_view taken = text_.substr(at_, count);
    for (const char c : taken) {
      here_.line += c == '\n' ? 1 : 0;
      here_.column = c == '\n' ? 1 : here_.column + 1;
    }
    at_ += taken.size();
    return taken;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  SourceMark here_;
  SourceMark cell_mark_;
  std::size_t count_ = 0;
  std::vector<TableRow> rows_;
};

class TableReader {
 public:
  TableReader(std::vector<TableRow> rows, diag::Findings& findings)
      : rows_(std::move(rows)), findings_(findings) {}

  std::optional<std::vector<TableColumn>> Run() {
    if (!HaveOneLength()) return std::nullopt;
    std::vector<TableColumn> columns;
    for (std::size_t i = 0; i < rows_.front().size(); ++i) columns.push_back(ReadColumn(i));
    return columns;
  }

 private:
  bool HaveOneLength() {
    bool is_equal = true;
    const std::size_t wanted = rows_.front().size();
    for (const TableRow& row : rows_) {
      if (row.size() == wanted) continue;
      is_equal = false;
      findings_.Add(
          Code::kSpecBadTable, row.front().mark,
          fmt::format("the row has {}, the header {}", diag::Counted(row.size(), "cell"), wanted));
    }
    return is_equal;
  }

  TableColumn ReadColumn(std::size_t i) {
    const TableCell& header = rows_.front()[i];
    std::string_view name = Trim(header.text);
    std::string_view unit;
    if (const std::size_t open = name.find('['); open != name.npos && name.ends_with(']')) {
      unit = Trim(name.substr(open + 1, name.size() - open - 2));
      name = Trim(name.substr(0, open));
    }
    TableColumn column{.name = std::string(name), .mark = header.mark, .unit = {}, .cells = {}};
    const auto is_number = [i](const TableRow& row) { return IsNumber(row[i].text); };
    const auto rows = std::span(rows_).subspan(1);
    CheckUnit(unit, header.mark);
    column.is_text = unit == "text" || (unit.empty() && !std::ranges::all_of(rows, is_number));
    if (i > 0 && column.is_text && unit.empty() && std::ranges::any_of(rows, is_number))
      WarnOfTexts(column, (*std::ranges::find_if_not(rows, is_number))[i]);
    const std::optional<expr::NamedUnit> named = expr::FindUnit(unit);
    if (named) column.unit = named->is_si ? std::string(unit) : named->dimension.Text();
    for (const TableRow& row : rows)
      column.cells.push_back(column.is_text ? Text(row[i]) : Number(row[i], unit));
    return column;
  }

  // Warns that a column of numbers is text because of one cell, which may be a typing error. The
  // first column is exempt, because it has the rows' names.
  void WarnOfTexts(const TableColumn& column, const TableCell& cell) {
    findings_.Warn(
        Code::kSpecBadTable, cell.mark,
        fmt::format("column '{}' is text, because '{}' is not a number", column.name, cell.text),
        fmt::format("write `{} [text]` in the header if this is meant", column.name));
  }

  void CheckUnit(std::string_view& unit, SourceMark mark) {
    if (unit.empty() || unit == "text") return;
    if (const auto named = expr::FindUnit(unit); named && named->is_si) return;
    std::vector<std::string_view> units = {"text"};
    for (const expr::Unit& known : expr::Units()) units.push_back(known.name);
    if (std::ranges::find(units, unit) != units.end()) return;
    std::string hint = diag::DidYouMean(unit, units);
    if (hint.empty()) hint = fmt::format("write {}", fmt::join(units, ", "));
    findings_.Add(Code::kExprUnknownUnit, mark, fmt::format("unknown unit '{}'", unit),
                  std::move(hint));
    unit = {};
  }

  static bool IsNumber(std::string_view text) { return expr::ParseNumber(Trim(text)).has_value(); }

  YamlNode Text(const TableCell& cell) {
    if (cell.text.find("${") != std::string::npos)
      findings_.Add(Code::kSpecBadTable, cell.mark,
                    "a table has no expressions: ${ has no meaning");
    YamlNode node = YamlNode::Scalar(cell.text, cell.mark);
    node.quoted = true;
    return node;
  }

  YamlNode Number(const TableCell& cell, std::string_view unit) {
    if (!IsNumber(cell.text)) {
      findings_.Add(Code::kSpecBadTable, cell.mark,
                    fmt::format("'{}' is not a number; the column's unit is {}", cell.text, unit));
      return YamlNode::Scalar("1", cell.mark);
    }
    // Appends a unit that is not an SI unit (12 becomes 12mm), so that the number is converted to
    // SI units like a number in an expression.
    const auto named = expr::FindUnit(unit);
    const std::string_view carried = named && !named->is_si ? unit : std::string_view();
    return YamlNode::Scalar(std::string(Trim(cell.text)).append(carried), cell.mark);
  }

  std::vector<TableRow> rows_;
  diag::Findings& findings_;
};

}  // namespace

std::optional<std::vector<TableColumn>> ReadTable(std::uint32_t file, const diag::Sources& sources,
                                                  diag::Findings& findings) {
  std::string_view text = sources.Text(file);
  const auto fail = [&](SourceMark mark, std::string message, std::string hint = {}) {
    findings.Add(Code::kSpecBadTable, mark, std::move(message), std::move(hint));
    return std::nullopt;
  };
  const SourceMark start{file, 1, 1};
  if (text.size() > kMaxYamlBytes)
    return fail(start, fmt::format("the table has more than {} MiB", kMaxYamlBytes >> 20));
  if (text.find('\0') != text.npos) return fail(start, "the table is binary");
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  SourceMark first = start;
  if (text.starts_with(kByteOrderMark)) {
    text.remove_prefix(kByteOrderMark.size());
    first.column += static_cast<std::uint32_t>(kByteOrderMark.size());
  }
  CsvParser parser(text, first);
  if (!parser.Run())
    return fail(parser.cell_mark(), "this cell has a quote in it, or one that is not closed",
                "put the cell in quotes, and write \"\" for each quote in it");
  if (parser.has_too_many())
    return fail(start, fmt::format("the table has more than {} cells", kMaxCells));
  if (parser.rows().size() < 2)
    return fail(start, "the table has no rows",
                "its first line has the names of the columns, each other one is a row");
  return TableReader(std::move(parser.rows()), findings).Run();
}

}  // namespace mjforge::spec
