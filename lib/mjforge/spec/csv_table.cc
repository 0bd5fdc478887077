#include "mjforge/spec/csv_table.h"

#include <csv.h>

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mjforge/expr/expr.h"

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

// libcsv's parser is given a character at a time: so it is known where each cell begins.
class Splitter {
 public:
  explicit Splitter(SourceMark start) : here_(start), begin_(start) {
    csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI);
  }
  ~Splitter() { csv_free(&parser_); }
  Splitter(const Splitter&) = delete;
  Splitter& operator=(const Splitter&) = delete;

  // False if it is not CSV: then `mark()` is where.
  bool Run(std::string_view text) {
    for (const char c : text) {
      const bool is_blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
      if (is_between_ && !is_blank) begin_ = here_;
      is_between_ = is_between_ && is_blank;
      if (csv_parse(&parser_, &c, 1, &AddCell, &EndRow, this) != 1) return false;
      const bool is_end = c == '\n';
      here_.line += is_end ? 1 : 0;
      here_.column = is_end ? 1 : here_.column + 1;
      if (count_ > kMaxCells) return true;
    }
    return csv_fini(&parser_, &AddCell, &EndRow, this) == 0;
  }

  SourceMark mark() const { return begin_; }
  bool has_too_many() const { return count_ > kMaxCells; }
  std::vector<TableRow>& rows() { return rows_; }

 private:
  static void AddCell(void* text, std::size_t size, void* self) {
    auto& splitter = *static_cast<Splitter*>(self);
    splitter.row_.push_back({std::string(static_cast<const char*>(text), size), splitter.begin_});
    splitter.is_between_ = true;
    ++splitter.count_;
  }
  static void EndRow(int, void* self) {
    auto& splitter = *static_cast<Splitter*>(self);
    splitter.rows_.push_back(std::exchange(splitter.row_, {}));
  }

  csv_parser parser_{};
  SourceMark here_;
  SourceMark begin_;        // of the cell
  bool is_between_ = true;  // no cell has begun
  std::size_t count_ = 0;
  TableRow row_;
  std::vector<TableRow> rows_;
};

YamlNode Scalar(std::string text, SourceMark mark, bool quoted) {
  YamlNode node;
  node.kind = YamlNode::Kind::kScalar;
  node.mark = mark;
  node.text = std::move(text);
  node.quoted = quoted;
  return node;
}

std::string_view Trimmed(std::string_view text) {
  const auto words = expr::WordsOf(text);
  return words.empty()
             ? std::string_view()
             : std::string_view(words.front().data(),
                                static_cast<std::size_t>(words.back().data() + words.back().size() -
                                                         words.front().data()));
}

class TableReader {
 public:
  TableReader(std::vector<TableRow> rows, diag::Findings& findings)
      : rows_(std::move(rows)), findings_(findings) {}

  std::optional<std::vector<TableColumn>> Run() {
    const std::size_t before = findings_.size();
    CheckLengths();
    if (findings_.size() != before) return std::nullopt;
    std::vector<TableColumn> columns;
    for (std::size_t i = 0; i < rows_.front().size(); ++i) columns.push_back(ReadColumn(i));
    return columns;
  }

 private:
  void CheckLengths() {
    const std::size_t wanted = rows_.front().size();
    for (const TableRow& row : rows_) {
      if (row.size() == wanted) continue;
      findings_.Add(Code::kSpecBadTable, row.front().mark,
                    fmt::format("the row has {} cell{}, the header {}", row.size(),
                                row.size() == 1 ? "" : "s", wanted));
    }
  }

  TableColumn ReadColumn(std::size_t i) {
    const TableCell& header = rows_.front()[i];
    std::string_view name = Trimmed(header.text);
    std::string_view unit;
    if (const std::size_t open = name.find('['); open != name.npos && name.ends_with(']')) {
      unit = Trimmed(name.substr(open + 1, name.size() - open - 2));
      name = Trimmed(name.substr(0, open));
    }
    TableColumn column{.name = std::string(name), .mark = header.mark, .unit = {}, .cells = {}};
    const auto is_number = [i](const TableRow& row) { return IsNumber(row[i].text); };
    const auto rows = std::span(rows_).subspan(1);
    CheckUnit(unit, header.mark);
    column.is_text = unit == "text" || (unit.empty() && !std::ranges::all_of(rows, is_number));
    const std::optional<expr::NamedUnit> named = expr::FindUnit(unit);
    if (named) column.unit = named->is_si ? std::string(unit) : named->dimension.Text();
    for (const TableRow& row : rows)
      column.cells.push_back(column.is_text ? Text(row[i]) : Number(row[i], unit));
    return column;
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

  static bool IsNumber(std::string_view text) {
    return expr::ParseNumber(Trimmed(text)).has_value();
  }

  YamlNode Text(const TableCell& cell) {
    if (cell.text.find("${") != std::string::npos)
      findings_.Add(Code::kSpecBadTable, cell.mark,
                    "a table has no expressions: ${ has no meaning");
    return Scalar(cell.text, cell.mark, true);
  }

  YamlNode Number(const TableCell& cell, std::string_view unit) {
    if (!IsNumber(cell.text)) {
      findings_.Add(Code::kSpecBadTable, cell.mark,
                    fmt::format("'{}' is not a number; the column's unit is {}", cell.text, unit));
      return Scalar("1", cell.mark, false);
    }
    // A number carries its unit as it does in expressions, unless it is in SI units already.
    const auto named = expr::FindUnit(unit);
    const std::string_view carried = named && !named->is_si ? unit : std::string_view();
    return Scalar(std::string(Trimmed(cell.text)).append(carried), cell.mark, false);
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
  Splitter splitter(first);
  if (!splitter.Run(text))
    return fail(splitter.mark(), "this cell has a quote in it, or one that is not closed",
                "put the cell in quotes, and write \"\" for each quote in it");
  if (splitter.has_too_many())
    return fail(start, fmt::format("the table has more than {} cells", kMaxCells));
  if (splitter.rows().size() < 2)
    return fail(start, "the table has no rows",
                "its first line has the names of the columns, each other one is a row");
  return TableReader(std::move(splitter.rows()), findings).Run();
}

}  // namespace mjforge::spec
