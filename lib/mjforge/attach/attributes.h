#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/compiled/compiled.h"
#include "mjforge/model/model.h"

namespace mjforge::attach {

/// Adds attributes of one kind of element, each with its row of the field table. An attribute with
/// a default is added only if it differs from it.
class Attributes {
 public:
  Attributes(const spec::ElementInfo& info, std::vector<model::Attribute>& out)
      : info_(info), out_(out) {}

  void Number(std::string_view key, double value) { Numbers(key, {&value, 1}); }
  void Number(std::string_view key, double value, double usual) {
    if (value != usual) Number(key, value);
  }
  void Numbers(std::string_view key, std::span<const double> values);
  void Numbers(std::string_view key, std::span<const double> values,
               std::initializer_list<double> usual);
  /// What a compiled element says by itself.
  void Read(const mjModel& m, std::span<const compiled::ArrayField> fields, int id);
  void Read(const mjModel& m, mjtObj kind, int id) { Read(m, compiled::ArrayFields(kind), id); }
  void Text(std::string_view key, std::string text);
  void Flag(std::string_view key, bool value) { Text(key, value ? "true" : "false"); }
  void Flag(std::string_view key, bool value, bool usual) {
    if (value != usual) Flag(key, value);
  }

 private:
  model::Attribute& Add(std::string_view key);

  const spec::ElementInfo& info_;
  std::vector<model::Attribute>& out_;
};

/// Numbers separated by spaces; none if a word is not a number.
std::vector<double> ParseNumbers(std::string_view text);

}  // namespace mjforge::attach
