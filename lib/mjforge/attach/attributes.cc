// Attributes: appends attributes with values from the compiled model (mjModel) or from XML.
#include "mjforge/attach/attributes.h"

#include <algorithm>
#include <stdexcept>

namespace mjforge::attach {

model::Attribute& Attributes::Add(std::string_view key) {
  const spec::FieldInfo* field = info_.Find(key);
  if (field == nullptr) throw std::logic_error("no attribute " + std::string(key));
  model::Attribute& attribute = out_.emplace_back();
  attribute.name = field->key;
  attribute.applies = field->applies;
  attribute.refers = field->refers;
  return attribute;
}

void Attributes::Numbers(std::string_view key, std::span<const double> values) {
  Add(key).numbers.Change().assign(values.begin(), values.end());
}

void Attributes::Read(const mjModel& m, std::span<const compiled::ArrayField> fields, int id) {
  for (const compiled::ArrayField& field : fields) {
    const sample::Numbers numbers = compiled::NumbersOf(m, field, id);
    if (numbers.empty()) continue;
    const bool usual = field.variable == nullptr && field.usual &&
                       std::equal(numbers.begin(), numbers.end(), field.usual->begin());
    if (usual) continue;
    if (field.IsFlag()) {
      Text(field.attribute, numbers[0] != 0 ? "true" : "false");
    } else {
      Add(field.attribute).numbers = numbers;
    }
  }
}

void CopyAttributes(const XmlElement& element, std::span<const std::string_view> names,
                    std::vector<model::Attribute>& out) {
  for (const std::string_view name : names) {
    const std::string* text = element.Find(name);
    if (text == nullptr) continue;
    model::Attribute& attribute = out.emplace_back();
    attribute.name = name;
    const std::vector<double> numbers = xml::NumbersOf(*text);
    attribute.numbers.Change().assign(numbers.begin(), numbers.end());
    if (attribute.numbers.empty()) attribute.text = *text;
  }
}

}  // namespace mjforge::attach
