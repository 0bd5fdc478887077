#include "mjforge/engine/frames.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/engine/placed_elements.h"
#include "mjforge/engine/pose_reader.h"

namespace mjforge::engine {
namespace {

constexpr std::string_view kEnds[] = {"fromto"};

bool IsOneOf(std::string_view tag, std::initializer_list<std::string_view> tags) {
  return std::ranges::find(tags, tag) != tags.end();
}

class Composing {
 public:
  Composing(XmlElement& root, const diag::Sources& sources, diag::Findings& findings)
      : root_(root), elements_(root), reader_(elements_, sources, findings) {}

  bool IsGlobal() const { return elements_.Setting("coordinate", "local") == "global"; }

  void Run(const RefuseLater& refuse) {
    TakeFromClasses();
    for (Placed& placed : elements_.all()) {
      const XmlElement& element = *placed.element;
      const auto frame = frames_.find(placed.parent);
      if (element.tag == "frame") {
        Enter(placed);
      } else if (frame == frames_.end()) {
        continue;
      } else if (const Later* later = FindLater("frame", element.tag)) {
        refuse(element, *later);
      } else {
        SetClass(*placed.element, frame->second.child_class);
        Move(placed, frame->second.pose);
      }
    }
    for (XmlElement& section : root_.children) {
      if (section.tag == "worldbody") Dissolve(section);
    }
  }

 private:
  struct Frame {
    Pose pose;  // in its body
    std::string child_class;
  };

  /// What a class says in these words would come before what the element gets.
  void TakeFromClasses() {
    std::set<const XmlElement*> taken;
    for (Placed& placed : elements_.all()) {
      Inherit(placed, kOrientations, taken);
      Inherit(placed, kEnds, taken);
    }
    for (XmlElement& section : root_.children) {
      if (section.tag == "default") Clear(section, taken);
    }
  }

  /// Gives the element the word that its classes say last, if it says none of them itself.
  void Inherit(Placed& placed, std::span<const std::string_view> words,
               std::set<const XmlElement*>& taken) const {
    XmlElement& element = *placed.element;
    const auto says = [&](std::string_view word) { return element.Find(word) != nullptr; };
    const bool own = std::ranges::any_of(words, says);
    for (const XmlElement* layer : elements_.DefaultsOf(placed)) {
      for (const std::string_view word : words) {
        const std::string* text = layer->Find(word);
        if (text == nullptr) continue;
        taken.insert(layer);
        if (own) continue;
        RemoveOrientation(element);
        element.Set(word, *text);
      }
    }
  }

  static void RemoveOrientation(XmlElement& element) {
    for (const std::string_view word : kOrientations) element.Remove(word);
    element.Remove("quat");
  }

  static void Clear(XmlElement& section, const std::set<const XmlElement*>& taken) {
    for (XmlElement& child : section.children) {
      Clear(child, taken);
      if (!taken.contains(&child)) continue;
      for (const std::string_view word : kOrientations) child.Remove(word);
      for (const std::string_view word : kEnds) child.Remove(word);
    }
  }

  void Enter(const Placed& placed) {
    const XmlElement& element = *placed.element;
    const auto above = frames_.find(placed.parent);
    if (above == frames_.end() && !IsOneOf(placed.parent->tag, {"worldbody", "body"})) return;
    Frame frame = above == frames_.end() ? Frame() : above->second;
    const auto pos = reader_.Numbers<3>(element, "pos", element.Find("pos"), {});
    const auto quat = reader_.Orientation(element, element.Find("quat"));
    if (pos && quat) frame.pose = frame.pose * Pose{*pos, *quat};
    if (const std::string* inner = element.Find("childclass")) frame.child_class = *inner;
    frames_.emplace(&element, std::move(frame));
  }

  static void SetClass(XmlElement& element, const std::string& name) {
    if (name.empty()) return;
    if (element.tag == "body" && element.Find("childclass") == nullptr) {
      element.Set("childclass", name);
    }
    if (IsOneOf(element.tag, {"joint", "geom", "site", "camera", "light"}) &&
        element.Find("class") == nullptr) {
      element.Set("class", name);
    }
  }

  void Move(Placed& placed, const Pose& frame) {
    const std::string& tag = placed.element->tag;
    if (tag == "light") {
      MovePosition(placed, frame);
      Turn(placed, "dir", {0, 0, -1}, frame);
    } else if (tag == "joint") {
      const std::string type = elements_.Get(placed, "type", "hinge");
      if (type == "free") return;
      MovePosition(placed, frame);
      if (type != "ball") Turn(placed, "axis", {0, 0, 1}, frame);
    } else if (IsOneOf(tag, {"body", "geom", "site", "camera"})) {
      MovePose(placed, frame);
    }
  }

  void MovePosition(Placed& placed, const Pose& frame) {
    const auto pos = reader_.Numbers<3>(*placed.element, "pos", elements_.Find(placed, "pos"), {});
    if (pos) Set(placed, "pos", frame.At(*pos));
  }

  void Turn(Placed& placed, std::string_view attribute, const Point& usual, const Pose& frame) {
    const auto direction =
        reader_.Numbers<3>(*placed.element, attribute, elements_.Find(placed, attribute), usual);
    if (direction) Set(placed, attribute, frame.Turned(*direction));
  }

  void MovePose(Placed& placed, const Pose& frame) {
    XmlElement& element = *placed.element;
    if (elements_.Find(placed, "fromto") != nullptr && !MeasureEnds(placed)) return;
    const auto pos = reader_.Numbers<3>(element, "pos", elements_.Find(placed, "pos"), {});
    const auto quat = reader_.Orientation(element, elements_.Find(placed, "quat"));
    if (!pos || !quat) return;
    const Pose pose = frame * Pose{*pos, *quat};
    RemoveOrientation(element);
    Set(placed, "pos", pose.pos);
    Set(placed, "quat", pose.quat);
  }

  /// Says `fromto` as pos, zaxis and size: how far a box is turned about its axis depends on the
  /// frame. False if MuJoCo refuses it.
  bool MeasureEnds(Placed& placed) {
    XmlElement& element = *placed.element;
    const std::string type = elements_.Get(placed, "type", "sphere");
    const bool has_ends = IsOneOf(type, {"capsule", "cylinder", "box", "ellipsoid"});
    const auto pos = reader_.Numbers<3>(element, "pos", elements_.Find(placed, "pos"), {});
    const auto ends = reader_.Numbers<6>(element, "fromto", elements_.Find(placed, "fromto"), {});
    if (!has_ends || !pos || std::ranges::any_of(*pos, [](mjtNum n) { return n != 0; }) || !ends)
      return false;
    Point middle;
    Point axis;  // from the second end to the first
    for (std::size_t i = 0; i < 3; ++i) {
      middle[i] = ((*ends)[i] + (*ends)[i + 3]) / 2;
      axis[i] = (*ends)[i] - (*ends)[i + 3];
    }
    const mjtNum half = mju_norm3(axis.data()) / 2;
    std::vector<double> size = NumbersOf(elements_.Get(placed, "size", "0"));
    if (size.empty() || half < mjMINVAL) return false;
    const bool is_round = IsOneOf(type, {"capsule", "cylinder"});
    size = is_round ? std::vector{size[0], half} : std::vector{size[0], size[0], half};
    RemoveOrientation(element);
    element.Remove("fromto");
    element.Set("size", TextOf(size));
    Set(placed, "pos", middle);
    Set(placed, "zaxis", axis);
    return true;
  }

  template <typename Numbers>
  static void Set(Placed& placed, std::string_view attribute, const Numbers& numbers) {
    placed.element->Set(attribute, TextOf({numbers.begin(), numbers.end()}));
  }

  /// Puts what frames hold in their places.
  static void Dissolve(XmlElement& parent) {
    std::vector<XmlElement> children;
    for (XmlElement& child : parent.children) {
      if (IsOneOf(child.tag, {"body", "frame"})) Dissolve(child);
      if (child.tag == "frame") {
        std::ranges::move(child.children, std::back_inserter(children));
      } else {
        children.push_back(std::move(child));
      }
    }
    parent.children = std::move(children);
  }

  XmlElement& root_;
  PlacedElements elements_;
  PoseReader reader_;
  std::map<const XmlElement*, Frame> frames_;
};

}  // namespace

bool Contains(const XmlElement& root, std::string_view tag) {
  return std::ranges::any_of(root.children, [&](const XmlElement& child) {
    return child.tag == tag || Contains(child, tag);
  });
}

bool ComposeFrames(XmlElement& root, const diag::Sources& sources, diag::Findings& findings,
                   const RefuseLater& refuse) {
  if (!Contains(root, "frame")) return false;
  Composing composing(root, sources, findings);
  if (composing.IsGlobal()) return false;
  composing.Run(refuse);
  return true;
}

}  // namespace mjforge::engine
