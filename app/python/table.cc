// C interface: tables whose rows are records of variants.
#include "table.h"

#include <set>

#include "mjforge/diag/diag.h"
#include "no_throw.h"
#include "text_view.h"

using namespace mjforge;
using python::View;

namespace {

void AddLayout(const std::vector<manifest::Column>& columns, MjforgeTable& table,
               diag::Json& json) {
  json.List(columns, [&](const manifest::Column& column) {
    table.all.push_back(&column);
    const std::set<char> kinds(column.kinds.begin(), column.kinds.end());
    json.StartArray();
    json.Value(column.key);
    json.Value(std::string(kinds.begin(), kinds.end()));
    AddLayout(column.inner, table, json);
    json.EndArray();
  });
}

}  // namespace

MjforgeTable* MjforgeOpenTable(const char* const* members, std::size_t count) {
  return python::NoThrow<MjforgeTable*>(nullptr, [&] {
    return new MjforgeTable(std::vector<std::string>(members, members + count));
  });
}

void MjforgeCloseTable(MjforgeTable* table) { delete table; }

int MjforgeAddRecord(MjforgeTable* table, const char* record, std::size_t size) {
  return python::NoThrow(2, [&] { return table->columns.Add({record, size}) ? 0 : 1; });
}

MjforgeText MjforgeLayout(MjforgeTable* table) {
  table->layout = python::NoThrow(std::string(), [&] {
    diag::Json json(nullptr);
    table->all.clear();
    json.StartArray();
    json.Value(table->columns.rows());
    json.Value(table->columns.texts());
    AddLayout(table->columns.Finish(), *table, json);
    json.EndArray();
    return json.Take();
  });
  return View(table->layout);
}

const char* MjforgeKinds(MjforgeTable* table, std::size_t column) {
  return table->all[column]->kinds.data();
}

const std::uint64_t* MjforgeValues(MjforgeTable* table, std::size_t column) {
  return table->all[column]->values.data();
}
