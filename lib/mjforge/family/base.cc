// Line by line edits of the base MJCF of a family: inertias, mocap bodies, materials, poses and
// friction losses of joints.

#include "mjforge/family/base.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include "mjforge/expr/expr.h"

namespace mjforge::family {
namespace {

// Calls `visit` with each line, including its line end.
void ForEachLine(std::string_view text, const std::function<void(std::string_view)>& visit) {
  while (!text.empty()) {
    const std::size_t size = std::min(text.find('\n'), text.size() - 1) + 1;
    visit(text.substr(0, size));
    text.remove_prefix(size);
  }
}

// Returns the tag of the element that begins on a line ("body") or ends there ("/body"); an empty
// text for other lines.
std::string_view TagOf(std::string_view line) {
  const std::size_t at = line.find_first_not_of(' ');
  if (at == line.npos || line[at] != '<') return {};
  line.remove_prefix(at + 1);
  return line.substr(0, line.find_first_of(" />\n", 1));
}

// Returns a copy of the text after `change` has edited its lines. Calls `change` for each line with
// the tag of the element on the line (TagOf) and the line, which `change` may modify.
template <typename Change>
std::string WithLines(std::string_view text, const Change& change) {
  std::string out;
  ForEachLine(text, [&](std::string_view line) {
    std::string changed(line);
    change(TagOf(line), changed);
    out += changed;
  });
  return out;
}

std::string_view IndentOf(std::string_view line) { return line.substr(0, line.find('<')); }

template <typename Numbers>
std::string Attribute(std::string_view name, const Numbers& numbers) {
  std::string text = ' ' + std::string(name) + "=\"";
  for (const double number : numbers) {
    if (text.back() != '"') text += ' ';
    text += expr::ExactNumberText(number);
  }
  return text + '"';
}

// Sets an attribute of the element on this line to numbers; replaces an attribute with the same
// name.
template <typename Numbers>
void SetAttribute(std::string& line, std::string_view name, const Numbers& numbers) {
  const std::string text = Attribute(name, numbers);
  const std::size_t at = line.find(text.substr(0, text.find('"') + 1));
  if (at != line.npos) {
    const std::size_t end = line.find('"', line.find('"', at) + 1) + 1;
    line.replace(at, end - at, text);
  } else {
    line.insert(line.find('>') - (line[line.find('>') - 1] == '/' ? 1 : 0), text);
  }
}

// Makes the base MJCF of a family from the MJCF text of a variant: drops the comment about the
// variant, gives each body an <inertial> with the values that MuJoCo computed and, if `mocap` is
// true, makes children of the world without joints mocap bodies.
class BaseWriter {
 public:
  BaseWriter(const Numbers& numbers, bool mocap) : numbers_(numbers), mocap_(mocap) {}

  std::string operator()(std::string_view text) {
    ForEachLine(text, [&](std::string_view line) { Add(line); });
    return std::move(base_);
  }

 private:
  void Add(std::string_view line) {
    const std::string_view tag = TagOf(line);
    if (tag == "worldbody") is_in_world_ = true;
    if (tag == "/worldbody") is_in_world_ = false;
    // Skips the opening comment, which describes one variant, and <inertial> elements, because
    // BeginBody() writes an <inertial> for every body.
    if (tag.starts_with('!') || (is_in_world_ && tag == "inertial")) return;
    if (is_in_world_ && tag == "joint" && depth_ == 1) MakeFree();
    base_ += line;
    if (!is_in_world_) return;
    if (tag == "body") BeginBody(line);
    if (tag == "/body") --depth_;
  }

  void BeginBody(std::string_view line) {
    ++depth_;
    const bool has_mocap = line.find(" mocap=\"") != line.npos;
    if (mocap_ && depth_ == 1 && !has_mocap) {
      mocap_at_ = base_.rfind('>');
      base_.insert(mocap_at_, kMocap);
    }
    base_.append(IndentOf(line)).append("  <inertial");
    constexpr std::pair<std::string_view, std::string_view> kArrays[] = {
        {"pos", "body_ipos"},
        {"quat", "body_iquat"},
        {"mass", "body_mass"},
        {"diaginertia", "body_inertia"}};
    for (const auto& [attribute, array] : kArrays)
      base_ += Attribute(attribute, numbers_.NumbersOf(array, body_, numbers_.values));
    base_ += "/>\n";
    ++body_;
  }

  // Removes the attribute `mocap` that BeginBody() added to the current child of the world, because
  // the child has a joint.
  void MakeFree() {
    if (mocap_at_ == base_.npos) return;
    base_.erase(mocap_at_, kMocap.size());
    mocap_at_ = base_.npos;
  }

  static constexpr std::string_view kMocap = " mocap=\"true\"";

  const Numbers& numbers_;
  bool mocap_;
  std::string base_;
  std::size_t mocap_at_ = std::string::npos;
  bool is_in_world_ = false;
  int depth_ = 0;
  std::size_t body_ = 0;
};

}  // namespace

std::string BaseOf(const mjcf::MjcfDocument& document, const Numbers& numbers, bool mocap) {
  return BaseWriter(numbers, mocap)(document.text);
}

std::string WithPoses(std::string_view base, std::span<const NewPose> poses) {
  std::map<std::pair<std::string_view, std::size_t>, const NewPose*> by_number;
  for (const NewPose& pose : poses) by_number[{pose.tag, pose.number}] = &pose;
  std::map<std::string_view, std::size_t> numbers;  // counts of elements so far, by tag
  bool is_in_world = false;
  return WithLines(base, [&](std::string_view tag, std::string& line) {
    if (tag == "worldbody") is_in_world = true;
    if (tag == "/worldbody") is_in_world = false;
    if (!is_in_world || tag.empty()) return;
    const auto pose = by_number.find({tag, numbers[tag]++});
    if (pose == by_number.end()) return;
    SetAttribute(line, "pos", pose->second->pos);
    if (pose->second->quat) SetAttribute(line, "quat", *pose->second->quat);
  });
}

std::string WithFrictions(std::string_view base,
                          std::span<const std::pair<std::string, double>> joints) {
  return WithLines(base, [&](std::string_view tag, std::string& line) {
    if (tag != "joint") return;
    for (const auto& [name, friction] : joints) {
      if (line.find(" name=\"" + name + '"') != line.npos)
        SetAttribute(line, "frictionloss", std::array{friction});
    }
  });
}

std::string WithMaterials(std::string_view base, std::span<const Material> materials) {
  std::string missing;
  for (const Material& material : materials) {
    ForEachLine(material.elements, [&](std::string_view line) {
      // Adds a texture only once, even if several materials share it. `start` is the beginning of
      // the line with tag and name.
      const std::string_view start = line.substr(0, line.find('"', line.find('"') + 1) + 1);
      if (base.find(start) == base.npos && missing.find(start) == missing.npos) missing += line;
    });
  }
  std::string out(base);
  if (missing.empty()) return out;
  const std::size_t end = out.find("  </asset>\n");
  if (end != out.npos) return out.insert(end, missing);
  return out.insert(out.find("  <worldbody>\n"), "  <asset>\n" + missing + "  </asset>\n");
}

}  // namespace mjforge::family
