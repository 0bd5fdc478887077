// Differences between the structures of two compiled models, and their description.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "mjforge/structure/structure.h"
#include "mjforge/structure/tables.h"

namespace mjforge::structure {
namespace {

constexpr std::size_t kShownElements = 3;

// Access to the counts, names and field values of a structure, by kind of element.
class View {
 public:
  explicit View(const Structure& structure) : structure_(structure) {
    const std::size_t kinds = Kinds().size();
    std::size_t at = kinds;
    std::size_t name = 0;
    auto field = Fields().begin();
    for (std::size_t k = 0; k < kinds; ++k) {
      const Kind& kind = Kinds()[k];
      for (; field != Fields().end() && field->kind == kind.type; ++field) {
        columns_.push_back(at);
        at += static_cast<std::size_t>(Count(k));
      }
      std::vector<std::string_view>& names = names_.emplace_back();
      for (int i = 0; kind.names != nullptr && i < Count(k); ++i) {
        names.emplace_back(structure.names.c_str() + name);
        name += names.back().size() + 1;
      }
    }
  }

  int Count(std::size_t kind) const { return structure_.integers[kind]; }
  const std::vector<std::string_view>& Names(std::size_t kind) const { return names_[kind]; }
  int Value(std::size_t field, int element) const {
    return structure_.integers[columns_[field] + static_cast<std::size_t>(element)];
  }

  // Returns the name of an element for messages. A degree of freedom has the name of its joint.
  std::string NameOf(std::size_t kind, int element) const {
    const mjtObj type = Kinds()[kind].type;
    if (type == mjOBJ_DOF) {
      const int joint = Value(FieldAt("dof_jntid"), element);
      return NameOf(KindAt(mjOBJ_JOINT), joint);
    }
    const auto i = static_cast<std::size_t>(element);
    if (i < names_[kind].size() && !names_[kind][i].empty()) return std::string(names_[kind][i]);
    if (type == mjOBJ_BODY && element == 1) return "root";
    return fmt::format("{} {}", Kinds()[kind].word, element);
  }

 private:
  static std::size_t FieldAt(std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(Fields(), name, &Field::name) -
                                    Fields().begin());
  }
  static std::size_t KindAt(mjtObj type) {
    return static_cast<std::size_t>(std::ranges::find(Kinds(), type, &Kind::type) -
                                    Kinds().begin());
  }

  const Structure& structure_;
  std::vector<std::size_t> columns_;  // for each field: index in `integers` of its first value
  std::vector<std::vector<std::string_view>> names_;
};

std::string WordOf(const Field& field, int value) {
  const auto i = static_cast<std::size_t>(value);
  return i < field.words.size() ? std::string(field.words[i]) : fmt::format("{}", value);
}

// Returns the names that do not occur equally often in the two lists.
std::vector<std::string> OneSided(const std::vector<std::string_view>& a,
                                  const std::vector<std::string_view>& b) {
  std::map<std::string_view, int> surplus;
  for (const std::string_view name : a) ++surplus[name];
  for (const std::string_view name : b) --surplus[name];
  std::vector<std::string> names;
  for (const auto& [name, count] : surplus) {
    if (count != 0 && !name.empty()) names.emplace_back(name);
  }
  return names;
}

std::string Joined(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) text.append(name).push_back('\0');
  return text;
}

// Compares the number and the names of the elements of a kind; returns nullopt if they are equal.
std::optional<Difference> DifferenceOfNames(const View& a, const View& b, std::size_t kind) {
  const auto& names_a = a.Names(kind);
  const auto& names_b = b.Names(kind);
  Difference difference;
  difference.elements = OneSided(names_a, names_b);
  difference.contents = Joined(names_b);
  if (a.Count(kind) != b.Count(kind)) {
    difference.field = Kinds()[kind].number;
    difference.values = {fmt::format("{}", a.Count(kind)), fmt::format("{}", b.Count(kind))};
    return difference;
  }
  const auto [in_a, in_b] = std::ranges::mismatch(names_a, names_b);
  if (in_a == names_a.end()) return std::nullopt;
  difference.field = fmt::format("{} names", Kinds()[kind].word);
  difference.values = {std::string(*in_a), std::string(*in_b)};
  return difference;
}

// Returns true for fields that contain ids of elements. Ids change if other elements are added.
bool IsReference(const Field& field) {
  return field.name.ends_with("id") || field.name.ends_with("id2") || field.kind == mjOBJ_PAIR ||
         field.kind == mjOBJ_EXCLUDE;
}

// Elements to compare, each as a pair of its ids in the two structures.
using Elements = std::vector<std::pair<int, int>>;

// Returns the elements whose names occur exactly once in each of the two lists.
Elements CommonElements(const std::vector<std::string_view>& a,
                        const std::vector<std::string_view>& b) {
  Elements elements;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::ranges::count(a, a[i]) != 1 || std::ranges::count(b, a[i]) != 1) continue;
    const auto in_b = std::ranges::find(b, a[i]) - b.begin();
    elements.emplace_back(static_cast<int>(i), static_cast<int>(in_b));
  }
  return elements;
}

Elements AllElements(int count) {
  Elements elements;
  for (int i = 0; i < count; ++i) elements.emplace_back(i, i);
  return elements;
}

std::optional<Difference> DifferenceOfField(const View& a, const View& b, std::size_t kind,
                                            std::size_t number, const Elements& elements) {
  const Field& field = Fields()[number];
  Difference difference;
  difference.field = field.name;
  difference.is_coincidence = field.is_coincidence;
  for (const auto& [id_a, id_b] : elements) {
    const int in_a = a.Value(number, id_a);
    const int in_b = b.Value(number, id_b);
    if (in_a == in_b) continue;
    if (difference.elements.empty()) difference.values = {WordOf(field, in_a), WordOf(field, in_b)};
    std::string name = kind == 0 ? std::string("model") : a.NameOf(kind, id_a);
    difference.contents += fmt::format("{}={};", name, in_b);
    if (std::ranges::find(difference.elements, name) == difference.elements.end())
      difference.elements.push_back(std::move(name));
  }
  if (difference.elements.empty()) return std::nullopt;
  return difference;
}

}  // namespace

std::vector<Difference> DifferencesOf(const Structure& a, const Structure& b) {
  std::vector<Difference> differences;
  if (a.empty() || b.empty() || a == b) return differences;
  const View view_a(a);
  const View view_b(b);
  std::size_t field = 0;
  for (std::size_t k = 0; k < Kinds().size(); ++k) {
    const bool is_named = Kinds()[k].names != nullptr;
    auto of_names = is_named ? DifferenceOfNames(view_a, view_b, k) : std::nullopt;
    const bool is_same = view_a.Count(k) == view_b.Count(k) && !of_names;
    const Elements elements =
        is_same ? AllElements(view_a.Count(k)) : CommonElements(view_a.Names(k), view_b.Names(k));
    if (of_names) differences.push_back(*std::move(of_names));
    for (; field < Fields().size() && Fields()[field].kind == Kinds()[k].type; ++field) {
      if (!is_same && IsReference(Fields()[field])) continue;
      if (auto found = DifferenceOfField(view_a, view_b, k, field, elements))
        differences.push_back(*std::move(found));
    }
  }
  return differences;
}

std::string Describe(const Difference& difference) {
  const auto& [first, second] = difference.values;
  std::string elements;
  const std::size_t count = difference.elements.size();
  for (std::size_t i = 0; i < std::min(count, kShownElements); ++i) {
    elements += fmt::format("{}'{}'", i == 0 ? "" : ", ", difference.elements[i]);
  }
  if (count > kShownElements) elements += fmt::format(" and {} more", count - kShownElements);
  if (difference.field.ends_with(" names"))
    return fmt::format("{} differ ('{}', not '{}')", difference.field, second, first);
  if (difference.field.starts_with('n')) {
    return fmt::format("{} is {}, not {}{}", difference.field, second, first,
                       elements.empty() ? "" : fmt::format(" ({})", elements));
  }
  if (difference.field.starts_with("option"))
    return fmt::format("{} is {}, not {}", difference.field, second, first);
  return fmt::format("{} of {} is {}, not {}", difference.field, elements, second, first);
}

}  // namespace mjforge::structure
