// Readers of `contact:` and `mjcf:`, whose entries become elements of MJCF sections.

#include <algorithm>

#include <fmt/format.h>

#include "mjforge/spec/entry_reader.h"

namespace mjforge::spec {
namespace {

using diag::Code;

// A section of MJCF that specs do not accept, and a hint at the keys of specs that replace it.
struct ForeignSection {
  std::string_view section;
  std::string_view hint;
};
constexpr ForeignSection kForeignSections[] = {
    {"compiler", "a spec uses SI units and rad; nothing in it depends on compiler settings"},
    {"default", "use `defaults:` of the spec"},
    {"asset", "assets come from `materials:` and the parts that use them"},
    {"worldbody", "use `parts:` and `bodies:`"},
    {"keyframe", "write where joints start under `pose:`, which makes the keyframe"},
    {"include", "use `import:` for YAML, or a body with `mjcf:`"},
};

class SectionEntryReader {
 public:
  explicit SectionEntryReader(Context& context) : context_(context), entries_(context) {}

  void Read(const YamlNode& sections) {
    if (!IsMap(sections, "MJCF sections", context_)) return;
    for (const YamlNode::Pair& pair : sections.pairs) {
      const SectionInfo* info = FindSection(pair.key);
      if (info == nullptr) {
        ReportUnknown(pair);
      } else if (info->is_element) {
        ReadElementSection(*info, pair);
      } else {
        ReadList(*info, pair.value);
      }
    }
  }

  // Reads pairs of `exclude:` in the forms [a, b] and {if, for, name, bodies: [a, b]}.
  void ReadExcludes(const YamlNode& list) {
    if (!IsList(list, "pairs of bodies", context_)) return;
    for (const YamlNode& item : list.items) {
      if (item.kind == YamlNode::Kind::kList) {
        Entry entry;
        entry.mark = item.mark;
        ReadPair(item, entry);
        AddExclude(std::move(entry));
      } else if (IsMap(item, "a pair's keys", context_)) {
        CheckKeys(kExcludeElement, item, context_);
        Entry entry = entries_.Begin(kExcludeElement, item, item);
        if (const YamlNode* bodies = item.Find("bodies")) {
          ReadPair(*bodies, entry);
        } else {
          context_.findings.Add(Code::kSpecMissingKey, item.mark, "a pair without 'bodies'");
        }
        entries_.End(entry);
        AddExclude(std::move(entry));
      }
    }
  }

 private:
  static const ElementInfo& Exclude() { return *FindSection("contact")->Find("exclude"); }

  void ReadPair(const YamlNode& pair, Entry& entry) {
    if (pair.kind != YamlNode::Kind::kList || pair.items.size() != 2) {
      context_.findings.Add(Code::kSpecWrongLength, pair.mark,
                            "expected the names of two bodies: [BODY, BODY]");
      return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const FieldInfo* info = Exclude().Find(i == 0 ? "body1" : "body2");
      entry.fields.emplace_back(info, context_.values.Read(*info, pair.items[i]),
                                pair.items[i].mark);
    }
  }

  void AddExclude(Entry entry) {
    entry.element = &Exclude();
    SectionOf(*FindSection("contact")).entries.push_back(std::move(entry));
  }

  Section& SectionOf(const SectionInfo& info) {
    auto& sections = context_.spec.sections;
    const auto found = std::ranges::find(sections, &info, &Section::info);
    if (found != sections.end()) return *found;
    return sections.emplace_back(Section{&info, {}});
  }

  void ReportUnknown(const YamlNode::Pair& pair) {
    const auto* foreign = std::ranges::find(kForeignSections, pair.key, &ForeignSection::section);
    if (foreign != std::end(kForeignSections)) {
      context_.findings.Add(Code::kSpecUnknownKey, pair.mark,
                            fmt::format("section '{}' has no place in a spec", pair.key),
                            std::string(foreign->hint));
      return;
    }
    context_.findings.Add(Code::kSpecUnknownKey, pair.mark,
                          fmt::format("MJCF of MuJoCo 2.2 has no section '{}'", pair.key),
                          diag::DidYouMean(pair.key, Sections(), &SectionInfo::name));
  }

  // Reads a section that is a single element (`option`, `size`). Inner elements of the element are
  // keys of the same mapping.
  void ReadElementSection(const SectionInfo& info, const YamlNode::Pair& pair) {
    const ElementInfo& element = info.elements.front();
    if (!IsMap(pair.value, fmt::format("the attributes of '{}'", info.name), context_)) return;
    Entry entry;
    entry.element = &element;
    entry.mark = pair.mark;
    YamlNode own = pair.value;
    std::erase_if(own.pairs, [&](const YamlNode::Pair& inner) {
      const auto child = std::ranges::find(element.children, inner.key, &ElementInfo::name);
      if (child == element.children.end()) return false;
      ReadChild(*child, inner, entry);
      return true;
    });
    entry.fields = ReadElementFields(element, own, context_);
    SectionOf(info).entries.push_back(std::move(entry));
  }

  void ReadChild(const ElementInfo& element, const YamlNode::Pair& pair, Entry& parent) {
    if (!IsMap(pair.value, fmt::format("the attributes of '{}'", element.name), context_)) return;
    Entry entry;
    entry.element = &element;
    entry.mark = pair.mark;
    entry.fields = ReadElementFields(element, pair.value, context_);
    parent.children.push_back(std::move(entry));
  }

  void ReadList(const SectionInfo& info, const YamlNode& list) {
    if (!IsList(list,
                fmt::format("elements, as in `{}: [{{{}: {{...}}}}]`", info.name,
                            info.elements.front().name),
                context_)) {
      return;
    }
    for (const YamlNode& item : list.items) {
      if (IsMap(item, fmt::format("one element of '{}'", info.name), context_)) {
        ReadElement(info, item);
      }
    }
  }

  // Reads an entry {if, for, let, TAG: {attributes, children}}, where TAG is the name of an
  // element.
  void ReadElement(const SectionInfo& info, const YamlNode& item) {
    const YamlNode::Pair* found = OnlyElement(info.elements, info.name, item);
    if (found == nullptr) return;
    const ElementInfo& element = *info.Find(found->key);
    if (!IsMap(found->value, fmt::format("the attributes of '{}'", element.name), context_)) return;
    const bool needs_name = info.name != "contact";
    Entry entry = entries_.Begin(
        element, item, found->value,
        needs_name ? EntryReader::Naming::kRequired : EntryReader::Naming::kOptional);
    entry.mark = found->mark;
    YamlNode own = found->value;
    std::erase_if(own.pairs, [&](const YamlNode::Pair& inner) {
      if (inner.key != "children" || element.children.empty()) return false;
      ReadChildren(element, inner.value, entry);
      return true;
    });
    RejectRepetition(own);
    entry.fields = ReadElementFields(element, own, context_);
    if (found->value.Find("name") == nullptr) RejectDraws(entry);
    entries_.End(entry);
    SectionOf(info).entries.push_back(std::move(entry));
  }

  void ReadChildren(const ElementInfo& element, const YamlNode& list, Entry& parent) {
    if (!IsList(list, "elements", context_)) return;
    for (const YamlNode& item : list.items) {
      if (!IsMap(item, fmt::format("one element of '{}'", element.name), context_)) continue;
      const YamlNode::Pair* found = OnlyElement(element.children, element.name, item);
      if (found == nullptr) continue;
      ReadChild(*std::ranges::find(element.children, found->key, &ElementInfo::name), *found,
                parent);
      if (std::ranges::none_of(item.pairs, IsOfEntry)) continue;
      context_.findings.Add(Code::kSpecConflict, item.mark,
                            "'if', 'for' and 'let' have no meaning for an element inside another",
                            "write them at the outer element");
    }
  }

  // Reports `if`, `for` and `let` among the attributes of an element, and removes them.
  void RejectRepetition(YamlNode& attributes) {
    std::erase_if(attributes.pairs, [this](const YamlNode::Pair& pair) {
      if (!IsOfEntry(pair)) return false;
      context_.findings.Add(Code::kSpecUnknownKey, pair.mark,
                            fmt::format("'{}' is not an MJCF attribute", pair.key),
                            "write it next to the element: `- {if: ..., joint: {...}}`");
      return true;
    });
  }

  static bool IsOfEntry(const YamlNode::Pair& pair) {
    return pair.key == "if" || pair.key == "for" || pair.key == "let";
  }

  // Returns the pair whose key names an element in `known`. Returns null, after adding a finding,
  // if `item` does not have exactly one pair besides `if`, `for` and `let`, or if its element is
  // unknown.
  const YamlNode::Pair* OnlyElement(std::span<const ElementInfo> known, std::string_view owner,
                                    const YamlNode& item) {
    const YamlNode::Pair* only = nullptr;
    for (const YamlNode::Pair& pair : item.pairs) {
      if (IsOfEntry(pair)) continue;
      if (std::ranges::find(known, pair.key, &ElementInfo::name) == known.end()) {
        context_.findings.Add(
            Code::kSpecUnknownKey, pair.mark,
            fmt::format("MJCF of MuJoCo 2.2 has no element '{}' in '{}'", pair.key, owner),
            diag::DidYouMean(pair.key, known, &ElementInfo::name));
        return nullptr;
      }
      if (only != nullptr) {
        context_.findings.Add(
            Code::kSpecConflict, pair.mark,
            fmt::format("'{}' together with '{}': one element per entry", pair.key, only->key));
        return nullptr;
      }
      only = &pair;
    }
    if (only == nullptr) {
      context_.findings.Add(Code::kSpecMissingKey, item.mark,
                            fmt::format("an element of '{}' is missing here", owner));
    }
    return only;
  }

  void RejectDraws(const Entry& entry) {
    for (const Field& field : entry.fields) {
      if (!HasDraw(field.value)) continue;
      context_.findings.Add(
          Code::kSpecUnnamedDraw, field.value.mark,
          fmt::format("a draw in a '{}' element without a name", entry.element->name),
          "draws are keyed by names; give it a 'name'");
      return;
    }
  }

  Context& context_;
  EntryReader entries_;
};

}  // namespace

void ReadSections(const YamlNode& sections, Context& context) {
  SectionEntryReader(context).Read(sections);
}

void ReadContact(const YamlNode& contact, Context& context) {
  if (!IsMap(contact, "contact's keys", context)) return;
  CheckKeys(kContactElement, contact, context);
  if (const YamlNode* exclude = contact.Find("exclude")) {
    SectionEntryReader(context).ReadExcludes(*exclude);
  }
}

}  // namespace mjforge::spec
