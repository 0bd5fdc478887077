// Backports a tree of MJCF elements: applies legacy rules and replacements, and removes or reports
// elements and attributes that an older MuJoCo does not have.
#include "mjforge/backport/backport.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/backport/default_classes.h"
#include "mjforge/backport/inherited_gains.h"
#include "mjforge/backport/key_limits.h"
#include "mjforge/backport/legacy_rules.h"
#include "mjforge/backport/mjcf_versions.h"
#include "mjforge/backport/replacements.h"
#include "mjforge/backport/sensor_references.h"
#include "mjforge/engine/engine.h"
#include "mjforge/xml/xml.h"

namespace mjforge::backport {
namespace {

using diag::Code;

/// Reasons, for warnings, why features can be removed, in the order of Effect; an empty text if
/// removal would change the model.
constexpr std::string_view kReasons[] = {"it changes only what is seen",
                                         "it changes only how the same is computed",
                                         "it changes only how the whole model is simulated",
                                         "it only reads, and acts on nothing",
                                         "",
                                         "",
                                         ""};
static_assert(std::size(kReasons) == static_cast<std::size_t>(Effect::kMeaning) + 1);

/// Returns true if `value` is the neutral value of the attribute that `feature` describes. Without
/// an attribute that has its neutral value, the model is the same.
bool IsNeutral(const MjcfFeature& feature, const std::string& value) {
  if (feature.neutral.empty()) return false;
  const std::vector<double> numbers = xml::NumbersOf(value);
  if (numbers.empty()) return value == feature.neutral;
  const std::vector<double> usual = xml::NumbersOf(feature.neutral);
  return !usual.empty() && std::ranges::all_of(numbers, [&](double n) { return n == usual[0]; });
}

/// Returns a list with the meaning of `numbers` and the length that the older release requires;
/// nullopt if there is no such list.
std::optional<std::vector<double>> Resized(const MjcfList& list, std::vector<double> numbers) {
  const std::vector<double> usual = xml::NumbersOf(list.usual);
  const double neutral = list.beyond.empty() ? numbers[0] : xml::NumbersOf(list.beyond)[0];
  for (std::size_t i = usual.size(); i < numbers.size(); ++i) {
    if (numbers[i] != neutral) return std::nullopt;
  }
  const std::size_t given = std::min(numbers.size(), usual.size());
  numbers.resize(usual.size());
  std::copy(usual.begin() + static_cast<std::ptrdiff_t>(given), usual.end(),
            numbers.begin() + static_cast<std::ptrdiff_t>(given));
  return numbers;
}

class Backporter {
 public:
  Backporter(xml::XmlElement& root, int version, Use use, const diag::Sources& sources,
             diag::Findings& findings)
      : root_(root), version_(version), use_(use), sources_(sources), findings_(findings) {}

  bool Run() {
    bool changed = ApplyLegacyRules(root_, version_);
    WarnOfForeignGains(root_, version_, findings_);
    changed = WriteInheritedGains(root_, version_) || changed;
    changed = ResizeLists(root_) || changed;
    changed = RemoveLongKeys(root_, version_, sources_,
                             use_ == Use::kWholeModel ? &findings_ : nullptr) ||
              changed;
    if (use_ == Use::kWholeModel) ReportRefusals(root_);
    if (!HasMissing(root_)) return changed;
    DefaultClasses elements(root_);
    Replacements replacements(elements, version_);
    replacements_ = &replacements;
    replacements.Run();
    for (const ClassedElement& classed : elements.all()) {
      for (const xml::XmlElement* element : elements.DefaultsOf(classed)) {
        CheckInherited(classed, *element);
      }
    }
    for (const ClassedElement* sensor : elements.In("sensor")) {
      const MjcfFeature* feature = FindMissing("sensor", sensor->element->tag);
      if (feature != nullptr && feature->effect == Effect::kReading)
        CheckReferences(*sensor->element, root_, sources_, findings_);
    }
    RemoveMissing(root_, true);
    return true;
  }

 private:
  /// Gives lists of numbers the lengths that the release requires. Adds an error for each list that
  /// has no equivalent of the required length. Returns true if the tree changed.
  bool ResizeLists(xml::XmlElement& parent) {
    bool changed = false;
    for (xml::XmlElement& child : parent.children) {
      for (auto& [name, value] : child.attributes) {
        const MjcfList* list = FindList(parent.tag, child.tag, name);
        if (list == nullptr || list->since <= version_) continue;
        const std::vector<double> numbers = xml::NumbersOf(value);
        // MuJoCo rejects a list without numbers, and a list that is too long for every release.
        if (numbers.empty() || numbers.size() > list->most) continue;
        if (const auto resized = Resized(*list, numbers)) {
          changed = changed || *resized != numbers;
          if (*resized != numbers) value = xml::TextOf(*resized);
        } else if (IsNew(child, name)) {
          findings_.Add(Code::kMujocoLater, MarkOf(child, name),
                        fmt::format("'{}' of {} with {} numbers needs MuJoCo {}", name,
                                    child.Description(), numbers.size(), VersionText(list->since)),
                        HintFor({}));
        }
      }
      changed = ResizeLists(child) || changed;
    }
    return changed;
  }

  /// Warns of attributes, and of values of attributes, that later releases of MuJoCo reject.
  void ReportRefusals(const xml::XmlElement& parent) {
    for (const xml::XmlElement& child : parent.children) {
      for (const auto& [name, value] : child.attributes) {
        const auto refusal = FindRefusal(parent.tag, child.tag, name, value, version_);
        if (!refusal || !IsNew(child, name)) continue;
        findings_.Warn(Code::kMujocoLaterRefuses, MarkOf(child, name),
                       fmt::format("{} {}", child.Description(), *refusal));
      }
      if (child.tag == "inertial" && child.Find("fullinertia") && child.Find("diaginertia") &&
          version_ < 324 && IsNew(child, "diaginertia")) {
        findings_.Warn(Code::kMujocoLaterRefuses, MarkOf(child, "diaginertia"),
                       fmt::format("{} has 'diaginertia' beside 'fullinertia'; MuJoCo 3.2.4 and "
                                   "later reject this",
                                   child.Description()));
      }
      ReportRefusals(child);
    }
  }

  const MjcfFeature* FindMissing(std::string_view parent, std::string_view tag) const {
    const MjcfFeature* feature = FindFeature(parent, tag);
    if (feature == nullptr) return nullptr;
    // Frames and replicates of an attached file may be as new as the MuJoCo of this build, because
    // this MuJoCo expands them.
    const bool expands = use_ == Use::kBodies && feature->effect == Effect::kExpansion;
    return feature->since > (expands ? mjVERSION_HEADER : version_) ? feature : nullptr;
  }
  const MjcfFeature* FindMissing(std::string_view parent, std::string_view tag,
                                 std::string_view attribute, const std::string& value) const {
    const MjcfFeature* feature = FindFeature(parent, tag, attribute, value);
    return feature != nullptr && feature->since > version_ ? feature : nullptr;
  }

  bool HasMissing(const xml::XmlElement& parent) const {
    return std::ranges::any_of(parent.children, [&](const xml::XmlElement& child) {
      if (FindMissing(parent.tag, child.tag) != nullptr) return true;
      for (const auto& [name, value] : child.attributes) {
        if (FindMissing(parent.tag, child.tag, name, value) != nullptr) return true;
      }
      return HasMissing(child);
    });
  }

  /// Checks the attributes of `element`, an element in `<default>`, that `classed` inherits. Adds
  /// an error for each attribute that the release lacks and whose removal would change the meaning
  /// of `classed`.
  void CheckInherited(const ClassedElement& classed, const xml::XmlElement& element) {
    for (const auto& [name, value] : element.attributes) {
      const MjcfFeature* feature = FindMissing("default", element.tag, name, value);
      if (feature == nullptr || feature->effect != Effect::kMeaning || IsNeutral(*feature, value))
        continue;
      if (classed.element->Find(name) != nullptr || replacements_->Find(classed.element, name))
        continue;
      const std::string& tag = classed.element->tag;
      const bool biased =
          name == "kv" && tag == "general" && classed.element->Find("biasprm") == nullptr;
      if (!biased && FindMissing(classed.parent->tag, tag, name, value) == nullptr) continue;
      ReportMissing(element, name, *feature);
    }
  }

  /// Removes all elements and attributes that the release lacks. If `reported` is true, adds a
  /// warning or an error for each.
  void RemoveMissing(xml::XmlElement& parent, bool reported) {
    for (xml::XmlElement& child : parent.children) {
      const bool is_reported = reported && !IsUnused(parent, child);
      const MjcfFeature* whole = FindMissing(parent.tag, child.tag);
      if (whole != nullptr && is_reported) ReportRemoval(child, "", "", *whole, false);
      std::erase_if(child.attributes, [&](const auto& attribute) {
        const auto& [name, value] = attribute;
        const MjcfFeature* feature = FindMissing(parent.tag, child.tag, name, value);
        if (feature == nullptr || IsDeferred(parent, child, name)) return false;
        if (is_reported) ReportRemoval(child, name, value, *feature, parent.tag == "default");
        return true;
      });
      RemoveMissing(child, is_reported && (whole == nullptr || whole->effect != Effect::kMeaning));
    }
    std::erase_if(parent.children, [&](const xml::XmlElement& child) {
      return FindMissing(parent.tag, child.tag) != nullptr;
    });
  }

  /// Returns true for an attribute `inertia` of a mesh that stays in the tree, because
  /// AddMeshInertia() applies and removes it.
  bool IsDeferred(const xml::XmlElement& parent, const xml::XmlElement& element,
                  const std::string& attribute) const {
    return parent.tag == "asset" && element.tag == "mesh" && attribute == "inertia" &&
           replacements_->Find(&element, attribute) == "";
  }

  /// Returns true if `section` contains only settings of the whole model, and only the bodies of
  /// the file are used (Use::kBodies).
  bool IsUnused(const xml::XmlElement& parent, const xml::XmlElement& section) const {
    constexpr std::string_view kOfModel[] = {"option", "size", "visual", "statistic", "keyframe"};
    return use_ == Use::kBodies && parent.tag == "mujoco" &&
           std::ranges::find(kOfModel, section.tag) != std::end(kOfModel);
  }

  /// Warns that an attribute, or the element if `attribute` is empty, is removed. Adds an error
  /// instead if the removal changes the meaning of the model. Does nothing if the attribute was
  /// replaced.
  void ReportRemoval(const xml::XmlElement& element, const std::string& attribute,
                     const std::string& value, const MjcfFeature& feature, bool in_default) {
    std::string_view reason = kReasons[static_cast<std::size_t>(feature.effect)];
    if (const auto replaced = replacements_->Find(&element, attribute)) {
      if (replaced->empty()) return;
      reason = *replaced;
    } else if (feature.effect == Effect::kMeaning && IsNeutral(feature, value)) {
      reason = "with this value it changes nothing";
    } else if (feature.effect == Effect::kMeaning && in_default) {
      reason = "nothing in the file has it from there";
    }
    if (reason.empty()) return ReportMissing(element, attribute, feature);
    if (!IsNew(element, attribute)) return;
    findings_.Warn(
        Code::kMujocoLater, MarkOf(element, attribute),
        fmt::format("{} is left out: {} (MuJoCo {})", Description(element, attribute, feature),
                    reason, VersionText(feature.since)));
  }

  void ReportMissing(const xml::XmlElement& element, const std::string& attribute,
                     const MjcfFeature& feature) {
    if (!IsNew(element, attribute)) return;
    findings_.Add(Code::kMujocoLater, MarkOf(element, attribute),
                  fmt::format("{} needs MuJoCo {}", Description(element, attribute, feature),
                              VersionText(feature.since)),
                  HintFor(feature));
  }

  std::string HintFor(const MjcfFeature& feature) {
    const bool expands = feature.effect == Effect::kExpansion;
    if (expands || feature.effect == Effect::kInclusion) {
      return fmt::format("{}{}",
                         std::exchange(has_command_, true)
                             ? "the same command expands it"
                             : "the Python package mujoco 3.3.7 expands it: " + ConversionCommand(),
                         expands || use_ == Use::kWholeModel
                             ? fmt::format("; mjforge built with MuJoCo {} or later accepts it",
                                           VersionText(feature.since))
                             : "");
    }
    return use_ == Use::kBodies
               ? "what is attached must mean the same in MuJoCo 2.2, which has nothing like it"
               : fmt::format("this is MuJoCo {}; mjforge can be built with a later one",
                             engine::Version());
  }

  /// Returns a shell command that writes a copy of the file, without frames, replicates and
  /// attachments, into the same folder. The command removes the names and classes of frames,
  /// because MuJoCo 3.3.7 would keep frames that have one; MuJoCo 4.0 keeps all frames.
  std::string ConversionCommand() const {
    std::string file = sources_.Name(root_.mark.file);
    if (file.starts_with('<')) file = "FILE.xml";  // standard input has no file name
    return fmt::format(
        "python3 -c \"import mujoco; s = mujoco.MjSpec.from_file('{}'); [setattr(f, a, '') for f "
        "in s.frames for a in ('name', 'childclass')]; s.compile(); open('{}-flat.xml', "
        "'w').write(s.to_xml())\"",
        file, file.substr(0, file.rfind('.')));
  }

  /// Returns an element for messages or, if `attribute` is not empty, the attribute of the element,
  /// with its value if only this value is new: "'type=sdf' of geom 'head'".
  static std::string Description(const xml::XmlElement& element, const std::string& attribute,
                                 const MjcfFeature& feature) {
    if (attribute.empty()) return element.Description();
    const bool only_value = feature.names.find('=') != std::string_view::npos;
    const std::string* value = only_value ? element.Find(attribute) : nullptr;
    return fmt::format("'{}{}' of {}", attribute, value == nullptr ? "" : "=" + *value,
                       element.Description());
  }

  /// Returns true if no attribute of this name was reported before in the element's file, and
  /// stores the name. If `attribute` is empty, does the same for elements with the tag of this
  /// element.
  bool IsNew(const xml::XmlElement& element, const std::string& attribute) {
    const std::string& name = attribute.empty() ? '<' + element.tag : attribute;
    return reported_.emplace(element.mark.file, name).second;
  }

  diag::SourceMark MarkOf(const xml::XmlElement& element, const std::string& attribute) const {
    return attribute.empty() ? element.mark : xml::MarkOfAttribute(sources_, element, attribute);
  }

  xml::XmlElement& root_;
  int version_;
  Use use_;
  const diag::Sources& sources_;
  diag::Findings& findings_;
  const Replacements* replacements_ = nullptr;
  std::set<std::pair<std::uint32_t, std::string>> reported_;
  bool has_command_ = false;  // true: a hint already contains the conversion command
};

}  // namespace

bool BackportMjcf(xml::XmlElement& root, int version, Use use, const diag::Sources& sources,
                  diag::Findings& findings) {
  return Backporter(root, version, use, sources, findings).Run();
}

}  // namespace mjforge::backport
