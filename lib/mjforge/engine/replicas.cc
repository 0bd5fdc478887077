#include "mjforge/engine/replicas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/engine/later_mjcf.h"
#include "mjforge/engine/placed_elements.h"
#include "mjforge/engine/pose_reader.h"

namespace mjforge::engine {
namespace {

/// More elements than this are not written out.
constexpr double kMostElements = 100'000;

/// What sections refer to: attributes, without a number at their end, and the kind of their target.
constexpr std::pair<std::string_view, std::string_view> kReferences[] = {
    {"body", "body"},         {"geom", "geom"},           {"site", "site"},
    {"joint", "joint"},       {"jointinparent", "joint"}, {"tendon", "tendon"},
    {"actuator", "actuator"}, {"camera", "camera"},       {"refsite", "site"},
    {"cranksite", "site"},    {"slidersite", "site"},     {"sidesite", "site"}};

/// In the order in which they may refer to each other.
constexpr std::string_view kSections[] = {"contact",  "tendon", "equality",
                                          "actuator", "sensor", "custom"};

using Name = std::pair<std::string, std::string>;  // of this kind

std::string KindOfReference(const XmlElement& element, std::string_view attribute) {
  if (attribute == "objname" || attribute == "refname") {
    const std::string* kind = element.Find(attribute == "objname" ? "objtype" : "reftype");
    if (kind == nullptr) return {};
    return *kind == "xbody" ? "body" : *kind;
  }
  if (attribute.ends_with('1') || attribute.ends_with('2')) attribute.remove_suffix(1);
  for (const auto& [name, kind] : kReferences) {
    if (name == attribute) return std::string(kind);
  }
  return {};
}

/// Calls `use` with the name and the text of each reference of an element, and those in it.
template <typename Element, typename Use>
void ForEachReference(Element& element, const Use& use) {
  for (auto& [attribute, text] : element.attributes) {
    const std::string kind = KindOfReference(element, attribute);
    if (!kind.empty() && !text.empty()) use(Name(kind, text), text);
  }
  for (auto& child : element.children) ForEachReference(child, use);
}

void AddNames(const XmlElement& parent, std::set<Name>& names) {
  for (const XmlElement& child : parent.children) {
    const std::string kind = child.tag == "freejoint" ? "joint" : child.tag;
    if (!child.Name().empty()) names.emplace(kind, child.Name());
    AddNames(child, names);
  }
}

/// Lengthens an attribute's text, if there is one.
void Lengthen(XmlElement& element, std::string_view attribute, const std::string& suffix) {
  const std::string* text = element.Find(attribute);
  if (text != nullptr && !text->empty()) element.Set(attribute, *text + suffix);
}

/// Of what stands in bodies. A target outside of the replicas is then one that there is not, as in
/// MuJoCo.
void Rename(XmlElement& element, const std::string& suffix) {
  Lengthen(element, "name", suffix);
  if (element.tag == "camera" || element.tag == "light") Lengthen(element, "target", suffix);
  for (XmlElement& child : element.children) Rename(child, suffix);
}

double SizeOf(const XmlElement& element) {
  double size = 1;
  for (const XmlElement& child : element.children) size += SizeOf(child);
  return size;
}

class Writer {
 public:
  Writer(XmlElement& root, const diag::Sources& sources, diag::Findings& findings,
         const RefuseLater& refuse)
      : root_(root),
        reader_(PlacedElements(root), sources, findings),
        findings_(findings),
        refuse_(refuse) {}

  void Run() {
    for (XmlElement& section : root_.children) {
      if (section.tag == "worldbody") WriteIn(section);
    }
  }

 private:
  void WriteIn(XmlElement& parent) {
    std::vector<XmlElement> children;
    for (XmlElement& child : parent.children) {
      if (child.tag == "body" || child.tag == "frame" || child.tag == "replicate") WriteIn(child);
      if (child.tag != "replicate") {
        children.push_back(std::move(child));
      } else {
        Write(child, children);
      }
    }
    parent.children = std::move(children);
  }

  void Write(const XmlElement& replicate, std::vector<XmlElement>& out) {
    RefuseJoints(replicate);
    RefuseComposites(replicate);
    const std::optional<Step> step = ReadStep(replicate);
    if (!step || made_ > kMostElements) return;
    std::set<Name> names;
    AddNames(replicate, names);
    const std::vector<Referring> referring = TakeReferring(names);
    double size = SizeOf(replicate);
    for (const Referring& one : referring) size += SizeOf(one.element);
    made_ += size * step->count;
    if (made_ > kMostElements) {
      return reader_.Refuse(replicate, "count",
                            fmt::format("makes more than {:.0f} elements", kMostElements));
    }
    const int copies = static_cast<int>(step->count);
    const std::string* separator = replicate.Find("sep");
    const std::string before = separator == nullptr ? "" : *separator;
    Pose pose;
    for (int i = 0; i < copies; ++i) {
      const std::string suffix =
          fmt::format("{}{:0{}}", before, i, fmt::formatted_size("{}", copies));
      Point turned;
      for (std::size_t axis = 0; axis < 3; ++axis) turned[axis] = i * step->angles[axis];
      pose.quat = reader_.FromEuler(replicate, turned).value_or(pose.quat);
      out.push_back(FrameOf(replicate, pose, suffix));
      pose.pos = pose.At(step->offset);
      for (const Referring& one : referring) AddCopy(one, names, suffix);
    }
  }

  struct Step {
    double count = 0;
    Point offset;
    Point angles;
  };

  std::optional<Step> ReadStep(const XmlElement& replicate) {
    const std::string* text = replicate.Find("count");
    if (text == nullptr) reader_.Refuse(replicate, "count", "is missing");
    const auto count = reader_.Numbers<1>(replicate, "count", text, {});
    const auto offset = reader_.Numbers<3>(replicate, "offset", replicate.Find("offset"), {});
    const auto angles = reader_.Numbers<3>(replicate, "euler", replicate.Find("euler"), {});
    if (text == nullptr || !count || !offset || !angles) return std::nullopt;
    if ((*count)[0] != std::floor((*count)[0])) {
      reader_.Refuse(replicate, "count", "must be a whole number");
      return std::nullopt;
    }
    if (!reader_.FromEuler(replicate, *angles)) return std::nullopt;
    return Step{std::max((*count)[0], 0.0), *offset, *angles};
  }

  static XmlElement FrameOf(const XmlElement& replicate, const Pose& pose,
                            const std::string& suffix) {
    XmlElement frame;
    frame.tag = "frame";
    frame.mark = replicate.mark;
    frame.Set("pos", TextOf({pose.pos.begin(), pose.pos.end()}));
    frame.Set("quat", TextOf({pose.quat.begin(), pose.quat.end()}));
    if (const std::string* name = replicate.Find("childclass")) frame.Set("childclass", *name);
    frame.children = replicate.children;
    for (XmlElement& child : frame.children) Rename(child, suffix);
    return frame;
  }

  /// What acts on a body would be there once for each copy.
  void RefuseJoints(const XmlElement& parent) {
    for (const XmlElement& child : parent.children) {
      if (child.tag == "frame") RefuseJoints(child);
      if (child.tag != "joint" && child.tag != "freejoint" && child.tag != "inertial") continue;
      if (!reader_.IsNew(child, "")) continue;
      findings_.Add(diag::Code::kMujocoError, child.mark,
                    fmt::format("{} stands in a replicate, but not in a body that is replicated",
                                child.Description()));
    }
  }

  /// 2.2 knows the parts of each by the same names.
  void RefuseComposites(const XmlElement& parent) {
    for (const XmlElement& child : parent.children) {
      if (child.tag == "composite") refuse_(child, *FindLater("replicate", child.tag));
      RefuseComposites(child);
    }
  }

  /// An element of another section that is there for each copy.
  struct Referring {
    XmlElement* section = nullptr;
    XmlElement element;
  };

  /// Takes away what refers to what is replicated, and adds its names to those.
  std::vector<Referring> TakeReferring(std::set<Name>& names) {
    std::vector<Referring> all;
    for (const std::string_view tag : kSections) {
      std::vector<Referring> taken;
      for (XmlElement& section : root_.children) {
        if (section.tag != tag) continue;
        std::vector<XmlElement> kept;
        for (XmlElement& element : section.children) {
          switch (ReachOf(tag, element, names)) {
            case Reach::kOutside:
              kept.push_back(std::move(element));
              break;
            case Reach::kReplicas:
              taken.push_back({nullptr, std::move(element)});
              break;
            case Reach::kCut:
              WarnOfCut(element);
          }
        }
        section.children = std::move(kept);
        for (Referring& one : taken) one.section = &section;  // the last of this kind
      }
      for (Referring& one : taken) {
        if (!one.element.Name().empty()) names.emplace(tag, one.element.Name());
        all.push_back(std::move(one));
      }
    }
    return all;
  }

  enum class Reach { kOutside, kReplicas, kCut };

  /// Contacts, tendons and sensors may join what is replicated with what is not.
  static Reach ReachOf(std::string_view section, const XmlElement& element,
                       const std::set<Name>& names) {
    int inside = 0;
    int all = 0;
    ForEachReference(element, [&](const Name& name, const std::string&) {
      inside += static_cast<int>(names.contains(name));
      ++all;
    });
    if (inside == 0) return Reach::kOutside;
    const bool may_join = section == "contact" || section == "tendon" || section == "sensor";
    return inside == all || may_join ? Reach::kReplicas : Reach::kCut;
  }

  void WarnOfCut(const XmlElement& element) {
    if (!reader_.IsNew(element, "")) return;
    findings_.Warn(
        diag::Code::kMujocoLater, element.mark,
        fmt::format("{} is left out, as in MuJoCo {}: it joins what is replicated with "
                    "something else",
                    element.Description(), VersionText(FindLater("body", "replicate")->since)));
  }

  static void AddCopy(const Referring& one, const std::set<Name>& names,
                      const std::string& suffix) {
    XmlElement& copy = one.section->children.emplace_back(one.element);
    Lengthen(copy, "name", suffix);
    ForEachReference(copy, [&](const Name& name, std::string& text) {
      if (names.contains(name)) text += suffix;
    });
  }

  XmlElement& root_;
  PoseReader reader_;
  diag::Findings& findings_;
  const RefuseLater& refuse_;
  double made_ = 0;
};

}  // namespace

bool WriteReplicas(XmlElement& root, const diag::Sources& sources, diag::Findings& findings,
                   const RefuseLater& refuse) {
  if (!Contains(root, "replicate")) return false;
  Writer(root, sources, findings, refuse).Run();
  return true;
}

}  // namespace mjforge::engine
