// C interface: tables of records.
#include "table.h"

#include <exception>
#include <memory>
#include <set>

#include "mjforge/diag/diag.h"
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
  try {
    return new MjforgeTable(std::vector<std::string>(members, members + count));
  } catch (const std::exception&) {
    return nullptr;
  }
}

void MjforgeCloseTable(MjforgeTable* table) { delete table; }

int MjforgeAddRecord(MjforgeTable* table, const char* record, std::size_t size) {
  try {
    return table->columns.Add({record, size}) ? 0 : 1;
  } catch (const std::exception&) {
    return 2;
  }
}

MjforgeText MjforgeLayout(MjforgeTable* table) {
  try {
    diag::Json json(nullptr);
    table->all.clear();
    json.StartArray();
    json.Value(table->columns.rows());
    json.Value(table->columns.texts());
    AddLayout(table->columns.Finish(), *table, json);
    json.EndArray();
    table->layout = json.Take();
  } catch (const std::exception&) {
    return {};
  }
  return View(table->layout);
}

const char* MjforgeKinds(MjforgeTable* table, std::size_t column) {
  return table->all[column]->kinds.data();
}

const std::uint64_t* MjforgeValues(MjforgeTable* table, std::size_t column) {
  return table->all[column]->values.data();
}
