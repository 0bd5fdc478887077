#include "mjforge/engine/adapt.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/engine/api.h"
#include "mjforge/engine/later_mjcf.h"
#include "mjforge/engine/older_rules.h"
#include "mjforge/engine/placed_elements.h"
#include "mjforge/engine/rewrite.h"
#include "mjforge/engine/xml_file.h"

namespace mjforge::engine {
namespace {

using diag::Code;

std::string_view ReasonOf(Loss loss) {
  switch (loss) {
    case Loss::kLooks:
      return "it changes only what is seen";
    case Loss::kSpeed:
      return "it changes only how the same is computed";
    case Loss::kSimulation:
      return "it changes only how the whole model is simulated";
    case Loss::kReading:
      return "it only reads, and acts on nothing";
    case Loss::kExpansion:
    case Loss::kInclusion:
    case Loss::kMeaning:
      break;
  }
  return {};
}

bool IsUsual(const Later& later, const std::string& value) {
  if (later.usual.empty()) return false;
  const std::vector<double> numbers = NumbersOf(value);
  if (numbers.empty()) return value == later.usual;
  const std::vector<double> usual = NumbersOf(later.usual);
  return !usual.empty() && std::ranges::all_of(numbers, [&](double n) { return n == usual[0]; });
}

class Adapter {
 public:
  Adapter(XmlElement& root, int version, Use use, const diag::Sources& sources,
          diag::Findings& findings)
      : root_(root), version_(version), use_(use), sources_(sources), findings_(findings) {}

  bool Run() {
    const bool changed = KeepOlderRules(root_, version_);
    if (!HasLater(root_)) return changed;
    PlacedElements elements(root_);
    Rewriting rewriting(elements, version_);
    rewriting_ = &rewriting;
    rewriting.Run();
    for (const Placed& placed : elements.all()) {
      for (const XmlElement* element : elements.DefaultsOf(placed)) {
        CheckInherited(placed, *element);
      }
    }
    Strip(root_, true);
    return true;
  }

 private:
  const Later* Lacks(std::string_view parent, std::string_view tag) const {
    const Later* later = FindLater(parent, tag);
    if (later == nullptr) return nullptr;
    // An attached file is compiled by the MuJoCo of this build, whose compiled model has no groups.
    const bool expands = use_ == Use::kBodies && later->loss == Loss::kExpansion;
    return later->since > (expands ? mjVERSION_HEADER : version_) ? later : nullptr;
  }
  const Later* Lacks(std::string_view parent, std::string_view tag, std::string_view attribute,
                     const std::string& value) const {
    const Later* later = FindLater(parent, tag, attribute, value);
    return later != nullptr && later->since > version_ ? later : nullptr;
  }

  bool HasLater(const XmlElement& parent) const {
    return std::ranges::any_of(parent.children, [&](const XmlElement& child) {
      if (Lacks(parent.tag, child.tag) != nullptr) return true;
      for (const auto& [name, value] : child.attributes) {
        if (Lacks(parent.tag, child.tag, name, value) != nullptr) return true;
      }
      return HasLater(child);
    });
  }

  /// What an element has from its default class means as much as what it says itself.
  void CheckInherited(const Placed& placed, const XmlElement& element) {
    for (const auto& [name, value] : element.attributes) {
      const Later* later = Lacks("default", element.tag, name, value);
      if (later == nullptr || later->loss != Loss::kMeaning || IsUsual(*later, value)) continue;
      if (placed.element->Find(name) != nullptr || rewriting_->Find(placed.element, name)) continue;
      const std::string& tag = placed.element->tag;
      const bool biased =
          name == "kv" && tag == "general" && placed.element->Find("biasprm") == nullptr;
      if (!biased && Lacks(placed.parent->tag, tag, name, value) == nullptr) continue;
      Refuse(element, name, *later);
    }
  }

  void Strip(XmlElement& parent, bool told) {
    for (XmlElement& child : parent.children) {
      const bool is_told = told && !IsUnused(parent, child);
      const Later* whole = Lacks(parent.tag, child.tag);
      if (whole != nullptr && is_told) Tell(child, "", "", *whole, false);
      std::erase_if(child.attributes, [&](const auto& attribute) {
        const auto& [name, value] = attribute;
        const Later* later = Lacks(parent.tag, child.tag, name, value);
        if (later == nullptr) return false;
        if (is_told) Tell(child, name, value, *later, parent.tag == "default");
        return true;
      });
      Strip(child, is_told && (whole == nullptr || whole->loss != Loss::kMeaning));
    }
    std::erase_if(parent.children,
                  [&](const XmlElement& child) { return Lacks(parent.tag, child.tag) != nullptr; });
  }

  /// A section that is not carried over is told as a whole.
  bool IsUnused(const XmlElement& parent, const XmlElement& section) const {
    constexpr std::string_view kOfModel[] = {"option", "size", "visual", "statistic", "keyframe"};
    return use_ == Use::kBodies && parent.tag == "mujoco" &&
           std::ranges::find(kOfModel, section.tag) != std::end(kOfModel);
  }

  void Tell(const XmlElement& element, const std::string& attribute, const std::string& value,
            const Later& later, bool in_default) {
    std::string_view reason = ReasonOf(later.loss);
    if (const auto done = rewriting_->Find(&element, attribute)) {
      if (done->empty()) return;
      reason = *done;
    } else if (later.loss == Loss::kMeaning && IsUsual(later, value)) {
      reason = "with this value it changes nothing";
    } else if (later.loss == Loss::kMeaning && in_default) {
      reason = "nothing in the file has it from there";
    }
    if (reason.empty()) return Refuse(element, attribute, later);
    if (!IsNew(element, attribute)) return;
    const std::string version = VersionText(later.since);
    findings_.Warn(Code::kMujocoLater, MarkOf(element, attribute),
                   attribute.empty() ? fmt::format("{} is left out: {} (MuJoCo {})",
                                                   element.Description(), reason, version)
                                     : fmt::format("'{}' of {} is left out: {} (MuJoCo {})",
                                                   Shown(element, attribute, later),
                                                   element.Description(), reason, version));
  }

  void Refuse(const XmlElement& element, const std::string& attribute, const Later& later) {
    if (!IsNew(element, attribute)) return;
    const std::string version = VersionText(later.since);
    findings_.Add(
        Code::kMujocoLater, MarkOf(element, attribute),
        attribute.empty()
            ? fmt::format("{} needs MuJoCo {}", element.Description(), version)
            : fmt::format("'{}' of {} needs MuJoCo {}", Shown(element, attribute, later),
                          element.Description(), version),
        HintFor(later));
  }

  std::string HintFor(const Later& later) const {
    const bool expands = later.loss == Loss::kExpansion;
    if (expands || later.loss == Loss::kInclusion) {
      return fmt::format("the Python package mujoco 3.3.7 expands it: {}{}", ConversionCommand(),
                         expands || use_ == Use::kWholeModel
                             ? fmt::format("; mjforge built with MuJoCo {} or later accepts it",
                                           VersionText(later.since))
                             : "");
    }
    return use_ == Use::kBodies
               ? "what is attached must mean the same in MuJoCo 2.2, which has nothing like it"
               : fmt::format("this is MuJoCo {}; mjforge can be built with a later one", Version());
  }

  /// A shell command that writes the file beside itself without frames, replicates and attachments.
  /// MuJoCo 3.3.7 keeps frames that have a name or a class, and from 3.11 on all frames.
  std::string ConversionCommand() const {
    std::string file = sources_.Name(root_.mark.file);
    if (file.starts_with('<')) file = "FILE.xml";  // standard input
    return fmt::format(
        "python3 -c \"import mujoco; s = mujoco.MjSpec.from_file('{}'); [setattr(f, a, '') for f in "
        "s.frames for a in ('name', 'childclass')]; s.compile(); open('{}-flat.xml', "
        "'w').write(s.to_xml())\"",
        file, file.substr(0, file.rfind('.')));
  }

  /// With its value, where only that is new.
  static std::string Shown(const XmlElement& element, const std::string& attribute,
                           const Later& later) {
    const std::string* value = element.Find(attribute);
    const bool only_value = later.names.find('=') != std::string_view::npos && value != nullptr;
    return only_value ? attribute + "=" + *value : attribute;
  }

  bool IsNew(const XmlElement& element, const std::string& attribute) {
    const std::string& name = attribute.empty() ? '<' + element.tag : attribute;
    return told_.emplace(element.mark.file, name).second;
  }

  diag::SourceMark MarkOf(const XmlElement& element, const std::string& attribute) const {
    return attribute.empty() ? element.mark : MarkOfAttribute(sources_, element, attribute);
  }

  XmlElement& root_;
  int version_;
  Use use_;
  const diag::Sources& sources_;
  diag::Findings& findings_;
  const Rewriting* rewriting_ = nullptr;
  std::set<std::pair<std::uint32_t, std::string>> told_;
};

}  // namespace

bool AdaptMjcf(XmlElement& root, int version, Use use, const diag::Sources& sources,
               diag::Findings& findings) {
  return Adapter(root, version, use, sources, findings).Run();
}

diag::SourceMark MarkOfAttribute(const diag::Sources& sources, const XmlElement& element,
                                 std::string_view attribute) {
  const std::string_view text = sources.Text(element.mark.file);
  std::size_t at = 0;
  for (std::uint32_t line = 1; line < element.mark.line; ++line) at = text.find('\n', at) + 1;
  at += element.mark.column - 1;
  for (char quote = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      break;
    } else if (static_cast<unsigned char>(c) <= ' ' && text.substr(at + 1).starts_with(attribute) &&
               text.find_first_of(" \t\r\n=", at + 1) == at + 1 + attribute.size()) {
      return MarkAt(sources, element.mark.file, at + 1);
    }
  }
  return element.mark;
}

}  // namespace mjforge::engine
