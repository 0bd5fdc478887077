// Reader of record parameters, in which one draw selects several values together.
//
// `style: {choice: [{name: modern, leg: 3cm}, ...]}` becomes the parameters `style.name` and
// `style.leg`; `cup: {rows: cups.csv}` becomes one parameter for each column of the table. The
// first column is the record's key if its values are constants that all differ: the key is drawn,
// and the other columns are looked up in the drawn row. Otherwise a column `row` with the numbers
// of the rows, from 0, is added as the key.

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "mjforge/spec/csv_table.h"
#include "mjforge/spec/record_parameters.h"

namespace mjforge::spec {
namespace {

using diag::Code;
using diag::SourceMark;

// Returns the pair with the options of a record (`choice`, `cycle` or `rows`); null if the
// parameter is not a record.
const YamlNode::Pair* OptionsOf(const YamlNode& node) {
  const auto is_record = [](const YamlNode& option) {
    return option.kind == YamlNode::Kind::kMap &&
           std::ranges::none_of(option.pairs, [](const auto& pair) { return IsDrawKey(pair.key); });
  };
  for (const YamlNode::Pair& pair : node.pairs) {
    if (pair.key == "rows") return &pair;
    const bool draws = pair.key == "choice" || pair.key == "cycle";
    if (draws && !pair.value.items.empty() && is_record(pair.value.items.front())) return &pair;
  }
  return nullptr;
}

YamlNode ChoiceOf(std::vector<YamlNode> options, SourceMark mark) {
  YamlNode choice = YamlNode::Empty(YamlNode::Kind::kMap, mark);
  choice.pairs.push_back({"choice", mark, YamlNode::List(std::move(options), mark)});
  return choice;
}

class RecordParameterReader {
 public:
  RecordParameterReader(const YamlNode::Pair& parameter, Context& context)
      : parameter_(parameter), context_(context) {}

  std::vector<ParameterNode> Run(const YamlNode& node, const YamlNode::Pair& options) {
    const bool is_table = options.key == "rows";
    std::vector<TableColumn> columns =
        is_table ? FromFile(options.value) : FromMappings(options.value);
    if (columns.empty()) {
      context_.spec.names.DeclareUnknown(parameter_.key);
      return {};
    }
    std::set<std::string_view> seen;
    for (const TableColumn& column : columns) {
      CheckColumnName(column);
      if (!seen.insert(column.name).second)
        Fail(Code::kSpecDuplicateName, column.mark,
             fmt::format("two columns are named '{}'", column.name));
    }
    std::shared_ptr<const RecordRows> rows = KeyOf(columns.front());
    if (rows == nullptr) {
      columns.insert(columns.begin(), Numbered(columns.front()));
      rows = KeyOf(columns.front());
    }
    std::vector<ParameterNode> declared;
    for (const TableColumn& column : columns) {
      const FieldKind kind = column.is_text ? FieldKind::kText : FieldKind::kNumber;
      declared.push_back({.name = parameter_.key + "." + column.name,
                          .mark = column.mark,
                          .value = ChoiceOf(column.cells, node.mark),
                          .source = fmt::format("by {}.{}", parameter_.key, columns.front().name),
                          .unit = column.unit,
                          .kind = is_table ? kind : FieldKind::kAnything,
                          .rows = rows});
    }
    declared.front().record = parameter_.key;
    declared.front().value = KeyNode(node, options, columns);
    // Shows a table as the spec writes it (`{rows: ...}`), because the list of all keys would be
    // too long.
    declared.front().source = is_table ? "" : FlowText(declared.front().value);
    return declared;
  }

 private:
  void Fail(Code code, SourceMark mark, std::string message, std::string hint = {}) {
    context_.findings.Add(code, mark, std::move(message), std::move(hint));
  }

  std::vector<TableColumn> FromFile(const YamlNode& file) {
    const std::string name = context_.values.ReadPlainText("rows", file);
    const auto source = name.empty() ? std::nullopt : context_.loader.OpenFile(name, file.mark);
    if (!source) return {};
    return ReadTable(*source, context_.sources, context_.findings)
        .value_or(std::vector<TableColumn>());
  }

  std::vector<TableColumn> FromMappings(const YamlNode& list) {
    std::vector<TableColumn> columns;
    for (const YamlNode::Pair& pair : list.items.front().pairs)
      columns.push_back({.name = pair.key, .mark = pair.mark, .unit = {}, .cells = {}});
    for (const YamlNode& row : list.items) {
      if (!IsMap(row, "a mapping like the first one", context_)) continue;
      for (TableColumn& column : columns) {
        if (const YamlNode* cell = row.Find(column.name)) {
          column.cells.push_back(*cell);
        } else {
          Fail(Code::kSpecMissingKey, row.mark, fmt::format("'{}' is missing here", column.name),
               "all mappings of a choice have the same keys");
        }
      }
      for (const YamlNode::Pair& pair : row.pairs) {
        if (std::ranges::find(columns, pair.key, &TableColumn::name) != columns.end()) continue;
        Fail(Code::kSpecUnknownKey, pair.mark,
             fmt::format("the first mapping of this choice has no '{}'", pair.key),
             "all mappings of a choice have the same keys");
      }
    }
    return columns;
  }

  void CheckColumnName(const TableColumn& column) {
    CheckName("column", column.name, column.mark, context_.findings);
    if (column.name.size() == 1 &&
        std::string_view("xyzw").find(column.name) != std::string::npos) {
      Fail(
          Code::kSpecBadName, column.mark,
          fmt::format("'{0}.{1}' would be a component of a vector; column '{1}' needs another name",
                      parameter_.key, column.name));
    }
  }

  // Returns an index of the rows by their values in this column. Returns null unless all values are
  // constant numbers or plain texts, and different from each other.
  std::shared_ptr<const RecordRows> KeyOf(const TableColumn& column) const {
    auto rows = std::make_shared<RecordRows>();
    for (const YamlNode& cell : column.cells) {
      if (cell.kind != YamlNode::Kind::kScalar) return nullptr;
      std::optional<double> key;
      if (column.is_text || context_.values.IsPlainText(cell)) {
        key = expr::TextKey(cell.text);
      } else {
        expr::Error error;
        const auto number = expr::Expression::Compile(cell.text, expr::SymbolTable(), error);
        if (number && number->type() == expr::Type::kNumber) key = number->constant();
      }
      if (!key || !rows->numbers.emplace(*key, rows->names.size()).second) return nullptr;
      rows->names.push_back(cell.text);
    }
    return rows;
  }

  static TableColumn Numbered(const TableColumn& first) {
    TableColumn rows{.name = "row", .mark = first.mark, .unit = {}, .cells = {}};
    for (const YamlNode& cell : first.cells)
      rows.cells.push_back(YamlNode::Scalar(std::to_string(rows.cells.size()), cell.mark));
    return rows;
  }

  // Returns the draw of the record's key: the record's own draw, in which the values of the first
  // column replace the options. If `weights` names a column, the column's values replace the name.
  YamlNode KeyNode(const YamlNode& node, const YamlNode::Pair& options,
                   std::vector<TableColumn>& columns) {
    YamlNode key = node;
    for (YamlNode::Pair& pair : key.pairs) {
      if (pair.key == options.key) {
        if (pair.key == "rows") pair.key = "choice";
        pair.value = YamlNode::List(columns.front().cells, pair.value.mark);
      } else if (pair.key == "weights" && pair.value.kind == YamlNode::Kind::kScalar) {
        const auto named = std::ranges::find(columns, pair.value.text, &TableColumn::name);
        if (named != columns.end()) {
          pair.value = YamlNode::List(named->cells, pair.value.mark);
        } else {
          Fail(Code::kSpecUnknownKey, pair.value.mark,
               fmt::format("no column '{}'", pair.value.text),
               diag::DidYouMean(pair.value.text, columns, &TableColumn::name));
        }
      }
    }
    return key;
  }

  const YamlNode::Pair& parameter_;
  Context& context_;
};

}  // namespace

const YamlNode& WithoutLongForm(const YamlNode& node) {
  const YamlNode* value = node.Find("value");
  return value != nullptr ? *value : node;
}

std::optional<std::vector<ParameterNode>> ReadRecord(const YamlNode::Pair& parameter,
                                                     Context& context) {
  const YamlNode& node = WithoutLongForm(parameter.value);
  const YamlNode::Pair* options = OptionsOf(node);
  if (options == nullptr) return std::nullopt;
  return RecordParameterReader(parameter, context).Run(node, *options);
}

}  // namespace mjforge::spec
