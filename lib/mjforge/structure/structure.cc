// Functions that read the structure of a compiled model and compute its hash.
#include "mjforge/structure/structure.h"

#include <array>

#include "mjforge/bytes/bytes.h"
#include "mjforge/structure/tables.h"

namespace mjforge::structure {
namespace {

constexpr std::size_t kKeyDigits = 12;

int CountOf(const mjModel& m, const Kind& kind) {
  return kind.count == nullptr ? 1 : static_cast<int>(m.*kind.count);
}

std::string_view WithoutPrefix(std::string_view name, std::string_view object_name) {
  if (object_name.empty() || !name.starts_with(object_name)) return name;
  if (name.size() == object_name.size()) return {};
  return name[object_name.size()] == '_' ? name.substr(object_name.size() + 1) : name;
}

}  // namespace

Structure StructureOf(const mjModel& m, std::string_view object_name) {
  Structure structure;
  std::size_t total = 0;
  auto field = Fields().begin();
  for (const Kind& kind : Kinds()) {
    const int count = CountOf(m, kind);
    structure.integers.push_back(count);
    for (; field != Fields().end() && field->kind == kind.type; ++field) {
      total += static_cast<std::size_t>(count);
    }
  }
  structure.integers.reserve(structure.integers.size() + total);
  field = Fields().begin();
  for (const Kind& kind : Kinds()) {
    const int count = CountOf(m, kind);
    for (; field != Fields().end() && field->kind == kind.type; ++field) {
      for (int i = 0; i < count; ++i) structure.integers.push_back(field->value(m, i));
    }
    for (int i = 0; kind.names != nullptr && i < count; ++i) {
      structure.names += WithoutPrefix(m.names + (m.*kind.names)[i], object_name);
      structure.names += '\0';
    }
  }
  return structure;
}

std::string Structure::Key() const {
  if (empty()) return {};
  const std::string_view numbers(reinterpret_cast<const char*>(integers.data()),
                                 integers.size() * sizeof(int));
  std::string bytes(numbers);
  bytes += names;
  return bytes::ChecksumOf(bytes).substr(0, kKeyDigits);
}

std::string Structure::FamilyKey() const {
  Structure without = *this;
  auto number = without.integers.begin();
  auto first = number + std::ssize(Kinds());  // the counts come first
  auto field = Fields().begin();
  for (const Kind& kind : Kinds()) {
    const int count = empty() ? 0 : *number++;
    for (; field != Fields().end() && field->kind == kind.type; ++field) {
      if (field->is_coincidence) std::fill_n(first, count, 0);
      first += count;
    }
  }
  return without.Key();
}

}  // namespace mjforge::structure
