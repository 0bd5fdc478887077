// Builder of the MJCF attributes of an element that is copied from an MJCF file.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/compiled/compiled.h"
#include "mjforge/model/model.h"
#include "mjforge/xml/xml.h"

namespace mjforge::attach {

using xml::XmlElement;

/// Appends attributes to an element, with the keys and properties that spec::ElementInfo gives for
/// the element. Read() omits attributes that are equal to their defaults.
class Attributes {
 public:
  Attributes(const spec::ElementInfo& info, std::vector<model::Attribute>& out)
      : info_(info), out_(out) {}

  void Number(std::string_view key, double value) { Numbers(key, {&value, 1}); }
  void Number(std::string_view key, double value, double usual) {
    if (value != usual) Number(key, value);
  }
  void Numbers(std::string_view key, std::span<const double> values);
  /// Appends the attributes `fields` of the compiled element `id`, read from the arrays of mjModel.
  void Read(const mjModel& m, std::span<const compiled::ArrayField> fields, int id);
  void Read(const mjModel& m, mjtObj kind, int id) { Read(m, compiled::ArrayFields(kind), id); }
  void Text(std::string_view key, std::string_view text) { Add(key).text = text; }

 private:
  model::Attribute& Add(std::string_view key);

  const spec::ElementInfo& info_;
  std::vector<model::Attribute>& out_;
};

/// Appends those attributes of an element whose names are in `names` to `out`.
void CopyAttributes(const XmlElement& element, std::span<const std::string_view> names,
                    std::vector<model::Attribute>& out);

/// Returns row `id` of an array of mjModel that has `count` numbers per row.
inline std::span<const mjtNum> Row(const mjtNum* array, int id, int count) {
  return {array + static_cast<std::ptrdiff_t>(id) * count, static_cast<std::size_t>(count)};
}

}  // namespace mjforge::attach
