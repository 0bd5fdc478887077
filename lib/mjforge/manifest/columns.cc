// Conversion of JSON records to the columns of a table.

#include "mjforge/manifest/columns.h"

#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "mjforge/manifest/exact_json.h"

namespace mjforge::manifest {
namespace {

std::string_view TextOf(const rapidjson::Value& value) {
  return {value.GetString(), value.GetStringLength()};
}

// Returns the inner column with that key; adds the column if there is none. Tries the column `next`
// first, because the members of all records usually have the same order.
Column& InnerOf(Column& column, std::string_view key, std::size_t next) {
  std::vector<Column>& inner = column.inner;
  if (next < inner.size() && inner[next].key == key) return inner[next];
  for (Column& each : inner) {
    if (each.key == key) return each;
  }
  inner.push_back({.key = std::string(key)});
  return inner.back();
}

}  // namespace

Columns::Columns(const std::vector<std::string>& members) {
  for (const std::string& member : members) columns_.push_back({.key = member});
}

std::uint64_t Columns::NumberOf(std::string_view text) {
  const auto [known, is_new] = text_numbers_.try_emplace(std::string(text), texts_.size());
  if (is_new) texts_.emplace_back(text);
  return known->second;
}

template <typename Value>
void Columns::PutInner(const Value& value, Column& column) {
  std::size_t next = 0;
  if (value.IsObject()) {
    for (const auto& [name, member] : value.GetObject())
      Put(member, InnerOf(column, TextOf(name), next++));
  } else {
    for (const auto& item : value.GetArray()) {
      if (next == column.inner.size()) column.inner.push_back({.key = std::to_string(next)});
      Put(item, column.inner[next++]);
    }
  }
}

template <typename Value>
void Columns::Put(const Value& value, Column& column) {
  if (value.IsNull() || column.kinds.size() > rows_) return;  // ignores a repeated key
  column.kinds.resize(rows_, Column::kAbsent);
  column.values.resize(rows_);
  const auto put = [&](char kind, std::uint64_t bits) {
    column.kinds += kind;
    column.values.push_back(bits);
  };
  if (value.IsInt64()) {
    put(Column::kWhole, static_cast<std::uint64_t>(value.GetInt64()));
  } else if (value.IsUint64()) {
    put(Column::kNatural, value.GetUint64());
  } else if (value.IsNumber()) {
    put(Column::kNumber, std::bit_cast<std::uint64_t>(value.GetDouble()));
  } else if (value.IsBool()) {
    put(Column::kFlag, value.GetBool() ? 1 : 0);
  } else if (value.IsString()) {
    put(Column::kText, NumberOf(TextOf(value)));
  } else if (value.IsArray()) {
    put(Column::kList, value.Size());
    PutInner(value, column);
  } else {
    put(Column::kObject, value.MemberCount());
    PutInner(value, column);
  }
}

bool Columns::Add(std::string text) {
  alignas(std::max_align_t) std::array<char, kParserBytes> memory;
  rapidjson::MemoryPoolAllocator<> allocator(memory.data(), memory.size());
  rapidjson::Document record(&allocator);
  if (!ParseExactly(text, record) || !record.IsObject()) return false;
  for (Column& column : columns_) {
    const auto member = record.FindMember(column.key.c_str());
    if (member != record.MemberEnd()) Put(member->value, column);
  }
  ++rows_;
  return true;
}

void Columns::Fill(std::vector<Column>& columns) const {
  for (Column& column : columns) {
    column.kinds.resize(rows_, Column::kAbsent);
    column.values.resize(rows_);
    Fill(column.inner);
  }
}

const std::vector<Column>& Columns::Finish() {
  Fill(columns_);
  return columns_;
}

}  // namespace mjforge::manifest
