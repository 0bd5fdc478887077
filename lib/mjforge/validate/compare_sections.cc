#include "mjforge/validate/compare_sections.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/validate/compare.h"

namespace mjforge::validate {
namespace {

using model::Element;

std::string_view TextOf(const Element& element, std::string_view attribute) {
  const auto found = std::ranges::find(element.attributes, attribute, &model::Attribute::name);
  return found == element.attributes.end() ? std::string_view() : found->text;
}

/// Two names, whichever comes first.
using Names = std::pair<std::string_view, std::string_view>;
Names Unordered(std::string_view a, std::string_view b) { return std::minmax(a, b); }

class SectionComparison {
 public:
  SectionComparison(const mjModel& m, const model::Object& object, diag::Findings& findings)
      : m_(m), object_(object), findings_(findings) {}

  void Run() {
    Each("sensor", m_.nsensor, m_.name_sensoradr, &SectionComparison::Sensor);
    Each("actuator", m_.nu, m_.name_actuatoradr, &SectionComparison::Actuator);
    Each("tendon", m_.ntendon, m_.name_tendonadr, &SectionComparison::Tendon);
    Each("equality", m_.neq, m_.name_eqadr, &SectionComparison::Equality);
    Contacts("pair", "geom1", "geom2", CompiledPairs());
    Contacts("exclude", "body1", "body2", CompiledExcludes());
  }

 private:
  using Check = void (SectionComparison::*)(int id, const Element& element);

  std::string_view NameOf(int kind, int id) const {
    const char* name = id < 0 ? nullptr : mj_id2name(&m_, kind, id);
    return name == nullptr ? std::string_view() : name;
  }

  void Mismatch(diag::SourceMark mark, std::string message) {
    findings_.Add(diag::Code::kMujocoMismatch, mark, std::move(message), kMismatchHint);
  }

  bool Count(std::string_view what, int compiled, std::size_t meant, diag::SourceMark mark) {
    if (compiled == static_cast<int>(meant)) return true;
    Mismatch(mark, fmt::format("MuJoCo compiled {} elements of {}, not {}", compiled, what, meant));
    return false;
  }

  /// These sections MuJoCo keeps in the order of the file.
  void Each(std::string_view section, int count, const int* names, Check check) {
    const std::span<const Element> elements = model::ElementsOf(object_, section);
    const diag::SourceMark mark =
        elements.empty() ? object_.bodies.front().mark : elements.front().mark;
    if (!Count(section, count, elements.size(), mark)) return;
    for (int id = 0; id < count; ++id) {
      const Element& element = elements[static_cast<std::size_t>(id)];
      const std::string_view name = m_.names + names[id];
      if (name != element.name) {
        Mismatch(element.mark, fmt::format("MuJoCo compiled {} '{}' where '{}' was meant", section,
                                           name, element.name));
      } else {
        (this->*check)(id, element);
      }
    }
  }

  void Reference(const Element& element, std::string_view attribute, std::string_view meant,
                 std::string_view compiled) {
    if (compiled == meant) return;
    Mismatch(element.mark, fmt::format("MuJoCo compiled {} of {} '{}' as '{}', not '{}'", attribute,
                                       element.tag, element.name, compiled, meant));
  }

  void ReferenceIfAny(const Element& element, std::string_view attribute, std::string_view meant,
                      std::string_view compiled) {
    if (!meant.empty()) Reference(element, attribute, meant, compiled);
  }

  void Sensor(int id, const Element& element) {
    for (const model::Attribute& attribute : element.attributes) {
      if (attribute.refers.empty()) continue;
      const bool frame = attribute.name == "refname";
      const int kind = frame ? m_.sensor_reftype[id] : m_.sensor_objtype[id];
      Reference(element, attribute.name, attribute.text,
                NameOf(kind, frame ? m_.sensor_refid[id] : m_.sensor_objid[id]));
    }
  }

  void Actuator(int id, const Element& element) {
    const int* ids = m_.actuator_trnid + 2 * id;
    for (const auto& [kind, first, second] : compiled::kTransmissions) {
      ReferenceIfAny(element, first, TextOf(element, first), NameOf(kind, ids[0]));
      ReferenceIfAny(element, second, TextOf(element, second), NameOf(mjOBJ_SITE, ids[1]));
    }
  }

  void Tendon(int id, const Element& element) {
    if (!Count(fmt::format("the path of tendon '{}'", element.name), m_.tendon_num[id],
               element.children.size(), element.mark)) {
      return;
    }
    int at = m_.tendon_adr[id];
    for (const Element& child : element.children) {
      const compiled::Wrap wrap = compiled::WrapAt(m_, at++);
      // The attribute has the tag's name: <joint joint="..."/>.
      if (child.tag != "pulley") {
        Reference(element, child.tag, TextOf(child, child.tag), NameOf(wrap.kind, wrap.object));
      }
      ReferenceIfAny(element, "sidesite", TextOf(child, "sidesite"), NameOf(mjOBJ_SITE, wrap.side));
    }
  }

  void Equality(int id, const Element& element) {
    for (const auto& [tag, kind, first, second] : compiled::kEqualities) {
      if (tag == "weld") continue;  // its attributes are those of `connect`
      ReferenceIfAny(element, first, TextOf(element, first), NameOf(kind, m_.eq_obj1id[id]));
      ReferenceIfAny(element, second, TextOf(element, second), NameOf(kind, m_.eq_obj2id[id]));
    }
  }

  std::vector<Names> CompiledPairs() const {
    std::vector<Names> pairs;
    pairs.reserve(static_cast<std::size_t>(m_.npair));
    for (int i = 0; i < m_.npair; ++i) {
      pairs.push_back(
          Unordered(NameOf(mjOBJ_GEOM, m_.pair_geom1[i]), NameOf(mjOBJ_GEOM, m_.pair_geom2[i])));
    }
    return pairs;
  }

  std::vector<Names> CompiledExcludes() const {
    std::vector<Names> pairs;
    pairs.reserve(static_cast<std::size_t>(m_.nexclude));
    for (int i = 0; i < m_.nexclude; ++i) {
      // (body1 + 1) << 16 and body2 + 1, the lower number first.
      const int signature = m_.exclude_signature[i];
      pairs.push_back(Unordered(NameOf(mjOBJ_BODY, (signature >> 16) - 1),
                                NameOf(mjOBJ_BODY, (signature & 0xffff) - 1)));
    }
    return pairs;
  }

  /// MuJoCo sorts these by body, so they are compared as sets.
  void Contacts(std::string_view tag, std::string_view first, std::string_view second,
                const std::vector<Names>& compiled) {
    std::map<Names, int> left;
    for (const Names& names : compiled) ++left[names];
    std::size_t meant = 0;
    for (const Element& element : model::ElementsOf(object_, "contact")) {
      if (element.tag != tag) continue;
      ++meant;
      const std::string_view a = TextOf(element, first);
      const std::string_view b = TextOf(element, second);
      if (--left[Unordered(a, b)] < 0) {
        Mismatch(element.mark, fmt::format("MuJoCo compiled no {} for '{}' and '{}'", tag, a, b));
      }
    }
    Count(fmt::format("{} in contact", tag), static_cast<int>(compiled.size()), meant,
          object_.bodies.front().mark);
  }

  const mjModel& m_;
  const model::Object& object_;
  diag::Findings& findings_;
};

}  // namespace

void CompareSections(const mjModel& m, const model::Object& object, diag::Findings& findings) {
  if (object.bodies.empty()) return;
  SectionComparison(m, object, findings).Run();
}

}  // namespace mjforge::validate
