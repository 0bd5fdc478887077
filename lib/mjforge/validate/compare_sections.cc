// Comparison of compiled sensors, actuators, tendons, equalities, pairs and excludes with those of
// the object.
#include <algorithm>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/validate/compare.h"

namespace mjforge::validate {
namespace {

using model::Element;

/// An unordered pair of names.
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
    Pairs();
    Excludes();
  }

 private:
  using Check = void (SectionComparison::*)(int id, const Element& element);

  std::string_view NameOf(int kind, int id) const {
    const char* name = id < 0 ? nullptr : mj_id2name(&m_, kind, id);
    return name == nullptr ? std::string_view() : name;
  }

  bool Count(std::string_view what, int compiled, std::size_t meant, diag::SourceMark mark) {
    return SameCount(fmt::format("elements of {}", what), compiled, meant, mark, findings_);
  }

  /// Compares the elements of a section in the order of the file, which MuJoCo keeps: the names,
  /// and then the references with `check`.
  void Each(std::string_view section, int count, const int* names, Check check) {
    const std::span<const Element> elements = model::ElementsOf(object_, section);
    const diag::SourceMark mark =
        elements.empty() ? object_.bodies.front().mark : elements.front().mark;
    if (!Count(section, count, elements.size(), mark)) return;
    for (int id = 0; id < count; ++id) {
      const Element& element = elements[static_cast<std::size_t>(id)];
      const ComparedElement subject = {section, element.name, {}, element.mark};
      if (SameName(m_.names + names[id], subject, findings_)) (this->*check)(id, element);
    }
  }

  void Reference(const Element& element, std::string_view attribute, std::string_view meant,
                 std::string_view compiled) {
    if (compiled == meant) return;
    AddMismatch(element.mark,
                fmt::format("MuJoCo compiled {} of {} '{}' as '{}', not '{}'", attribute,
                            element.tag, element.name, compiled, meant),
                findings_);
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
      // Reads the reference from the attribute named like the tag: <joint joint="..."/>.
      if (child.tag != "pulley") {
        Reference(element, child.tag, TextOf(child, child.tag), NameOf(wrap.kind, wrap.object));
      }
      ReferenceIfAny(element, "sidesite", TextOf(child, "sidesite"), NameOf(mjOBJ_SITE, wrap.side));
    }
  }

  void Equality(int id, const Element& element) {
    for (const auto& [tag, kind, first, second] : compiled::kEqualities) {
      if (tag == "weld") continue;  // has the attributes of `connect`
      ReferenceIfAny(element, first, TextOf(element, first), NameOf(kind, m_.eq_obj1id[id]));
      ReferenceIfAny(element, second, TextOf(element, second), NameOf(kind, m_.eq_obj2id[id]));
    }
  }

  void Pairs() {
    std::map<Names, int> left;
    for (int i = 0; i < m_.npair; ++i) {
      ++left[Unordered(NameOf(mjOBJ_GEOM, m_.pair_geom1[i]), NameOf(mjOBJ_GEOM, m_.pair_geom2[i]))];
    }
    Contacts("pair", "geom1", "geom2", m_.npair, std::move(left));
  }

  void Excludes() {
    std::map<Names, int> left;
    for (int i = 0; i < m_.nexclude; ++i) {
      const auto [body1, body2] = engine::ExcludedBodies(m_, i);
      ++left[Unordered(NameOf(mjOBJ_BODY, body1), NameOf(mjOBJ_BODY, body2))];
    }
    Contacts("exclude", "body1", "body2", m_.nexclude, std::move(left));
  }

  /// Compares pairs or excludes as sets, because MuJoCo sorts them by body.
  void Contacts(std::string_view tag, std::string_view first, std::string_view second, int count,
                std::map<Names, int> left) {
    std::size_t meant = 0;
    for (const Element& element : model::ElementsOf(object_, "contact")) {
      if (element.tag != tag) continue;
      ++meant;
      const std::string_view a = TextOf(element, first);
      const std::string_view b = TextOf(element, second);
      if (--left[Unordered(a, b)] < 0) {
        AddMismatch(element.mark, fmt::format("MuJoCo compiled no {} for '{}' and '{}'", tag, a, b),
                    findings_);
      }
    }
    Count(fmt::format("{} in contact", tag), count, meant, object_.bodies.front().mark);
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
