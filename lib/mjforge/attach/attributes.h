#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/model/model.h"

namespace mjforge::attach {

using engine::XmlElement;

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
  /// What a compiled element says by itself.
  void Read(const mjModel& m, std::span<const compiled::ArrayField> fields, int id);
  void Read(const mjModel& m, mjtObj kind, int id) { Read(m, compiled::ArrayFields(kind), id); }
  void Text(std::string_view key, std::string text);

 private:
  model::Attribute& Add(std::string_view key);

  const spec::ElementInfo& info_;
  std::vector<model::Attribute>& out_;
};

/// Numbers separated by spaces; none if a word is not a number.
sample::Numbers ParseNumbers(std::string_view text);

/// Adds attributes of an element as the file has them, those of these names that it has.
void CopyAttributes(const XmlElement& element, std::span<const std::string_view> names,
                    std::vector<model::Attribute>& out);

/// The id-th group of `count` numbers of an array of mjModel.
inline std::span<const mjtNum> Row(const mjtNum* array, int id, int count) {
  return {array + static_cast<std::ptrdiff_t>(id) * count, static_cast<std::size_t>(count)};
}

}  // namespace mjforge::attach
