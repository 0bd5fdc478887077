// Records as a table with one column for each member of their JSON objects.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace mjforge::manifest {

/// Column of a table: the values of one member of JSON objects, one object per row. Lists and
/// objects have an inner column for each of their items or members.
struct Column {
  /// Kinds of values, and the meaning of the value's 64 bits in `values`.
  static constexpr char kAbsent = ' ';   // no value or null; numbers that are not finite are null
  static constexpr char kWhole = 'i';    // std::int64_t
  static constexpr char kNatural = 'u';  // std::uint64_t beyond std::int64_t
  static constexpr char kNumber = 'f';   // double
  static constexpr char kFlag = 'b';     // 0 or 1
  static constexpr char kText = 't';     // index in Columns::texts()
  static constexpr char kList = 'l';     // number of items
  static constexpr char kObject = 'o';   // number of members

  std::string key;                         // name of the member, or number of the item of a list
  std::string kinds = {};                  // kind of each row's value
  std::vector<std::uint64_t> values = {};  // value of each row
  std::vector<Column> inner = {};  // columns of the items or members, in order of occurrence
};

/// Makes columns from members of JSON records, one record per row. Ignores other members.
class Columns {
 public:
  explicit Columns(const std::vector<std::string>& members);

  /// Adds a row; returns false if the text is not a JSON object.
  bool Add(std::string text);
  /// Returns the columns of the members, in the order of the constructor's argument. All columns
  /// and inner columns have one value per row.
  const std::vector<Column>& Finish();
  std::size_t rows() const { return rows_; }
  /// Distinct texts of all columns, each once.
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  template <typename Value>
  void Put(const Value& value, Column& column);
  template <typename Value>
  void PutInner(const Value& value, Column& column);
  std::uint64_t NumberOf(std::string_view text);
  void Fill(std::vector<Column>& columns) const;

  std::vector<Column> columns_;
  std::size_t rows_ = 0;
  std::vector<std::string> texts_;
  std::unordered_map<std::string, std::uint64_t> text_numbers_;
};

}  // namespace mjforge::manifest
