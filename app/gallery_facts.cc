// Texts and tables about objects for the pages of a gallery: masses, sizes, joints, targets.
#include "gallery_facts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "console.h"

namespace mjforge::app {
namespace {

constexpr std::size_t kMaxRows = 40;  // rows per table

std::string Short(double number) {
  return std::abs(number) >= 100 ? fmt::format("{:.0f}", number)
                                 : fmt::format("{:.3g}", number + 0.0);  // avoids "-0"
}

// A unit in which numbers are shown.
struct Unit {
  double factor = 1;
  std::string_view name;
};

constexpr Unit kDegrees = {180 / std::numbers::pi, "deg"};

Unit UnitOfLength(double meters) {
  if (meters < 0.01) return {1000, "mm"};
  return meters < 1 ? Unit{100, "cm"} : Unit{1, "m"};
}

Unit UnitOfMass(double kilograms) { return kilograms < 1 ? Unit{1000, "g"} : Unit{1, "kg"}; }

// Smallest and largest of several numbers.
struct Range {
  double min = 0;
  double max = 0;

  std::string Text(const Unit& unit) const {
    const std::string low = Short(unit.factor * min);
    const std::string high = Short(unit.factor * max);
    return low == high ? fmt::format("{} {}", high, unit.name)
                       : fmt::format("{} to {} {}", low, high, unit.name);
  }
};

template <typename Measure>
Range RangeOf(const std::vector<manifest::Record>& variants, const Measure& measure) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Range range{kInfinity, -kInfinity};
  for (const manifest::Record& record : variants) {
    const double value = measure(record);
    range = {std::min(range.min, value), std::max(range.max, value)};
  }
  return range;
}

Eigen::Vector3d SidesOf(const model::Bounds& bounds) {
  return bounds.aabb.empty() ? Eigen::Vector3d::Zero().eval()
                             : (bounds.aabb.max - bounds.aabb.min).eval();
}

std::string MassText(const std::vector<manifest::Record>& variants) {
  const Range range =
      RangeOf(variants, [](const manifest::Record& record) { return record.mass_properties.mass; });
  return range.Text(UnitOfMass(range.max));
}

std::string SizeText(const std::vector<manifest::Record>& variants) {
  const Range range = RangeOf(
      variants, [](const manifest::Record& record) { return SidesOf(record.bounds).maxCoeff(); });
  return range.Text(UnitOfLength(range.max));
}

std::string JointText(const model::Joint& joint) {
  if (!joint.range) return std::string(joint.type);
  const Range range{(*joint.range)[0], (*joint.range)[1]};
  const double largest = std::max(std::abs(range.min), std::abs(range.max));
  const Unit unit = joint.type == "slide" ? UnitOfLength(largest) : kDegrees;
  return fmt::format("{}, {}", joint.type, range.Text(unit));
}

std::string RegionText(const model::Region& region) {
  const Eigen::Vector2d sides = 2 * region.half_size;
  std::string text = region.type == model::RegionType::kDisc
                         ? fmt::format("disc, {} wide", LengthText(sides[0]))
                         : fmt::format("{}, {} x {}", model::RegionTypeName(region.type),
                                       LengthText(sides[0]), LengthText(sides[1]));
  if (std::isfinite(region.height)) text += fmt::format(", {} high", LengthText(region.height));
  return text;
}

// Adds a table unless the table has no rows; rows after kMaxRows are not shown but counted.
void Add(report::FeatureTable table, std::vector<report::FeatureTable>& tables) {
  if (table.rows.empty()) return;
  if (const std::size_t count = table.rows.size(); count > kMaxRows) {
    table.rows.resize(kMaxRows);
    table.rows.emplace_back(fmt::format("and {} more", count - kMaxRows), "");
  }
  tables.push_back(std::move(table));
}

report::FeatureTable TableOf(const model::Object& object, std::string title,
                             std::string_view section) {
  report::FeatureTable table{std::move(title), {}};
  for (const model::Element& element : model::ElementsOf(object, section))
    table.rows.emplace_back(ShortName(object, element.name), element.tag);
  return table;
}

std::size_t CountJoints(const model::Object& object) {
  std::size_t count = 0;
  for (const model::Body& body : object.bodies) {
    count += static_cast<std::size_t>(std::ranges::count_if(
        body.joints, [](const model::Joint& joint) { return joint.type != "free"; }));
  }
  return count;
}

}  // namespace

std::string LengthText(double meters) {
  const Unit unit = UnitOfLength(std::abs(meters));
  return meters == 0 ? "0" : fmt::format("{} {}", Short(unit.factor * meters), unit.name);
}

std::string AngleText(double radians) {
  return fmt::format("{} {}", Short(kDegrees.factor * radians), kDegrees.name);
}

std::string ShortName(const model::Object& object, const std::string& name) {
  const std::string prefix = object.name + "_";
  return name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

std::vector<report::Fact> FactsOf(const std::vector<manifest::Record>& variants,
                                  const forge::Variant& typical) {
  const model::Object& object = *typical.object;
  std::size_t geoms = 0;
  for (const model::Body& body : object.bodies) geoms += model::GeomCount(body);
  const Eigen::Vector3d sides = SidesOf(object.bounds);
  const Unit unit = UnitOfLength(sides.maxCoeff());
  const double mass = object.mass_properties.mass;
  const Unit mass_unit = UnitOfMass(mass);
  return {
      {"Mass", MassText(variants)},
      {"Longest side", SizeText(variants)},
      {"Variant in the large picture",
       fmt::format("{} x {} x {} {}, {} {}", Short(unit.factor * sides[0]),
                   Short(unit.factor * sides[1]), Short(unit.factor * sides[2]), unit.name,
                   Short(mass_unit.factor * mass), mass_unit.name)},
      {"Its elements", fmt::format("{}, {}, {}", Counted(object.bodies.size(), "body", "bodies"),
                                   Counted(CountJoints(object), "joint"), Counted(geoms, "geom"))},
      {"Its file",
       fmt::format("{:.3g} kB of MJCF", static_cast<double>(typical.document.text.size()) / 1000)}};
}

std::string ShortFacts(const std::vector<manifest::Record>& variants,
                       const model::Object& typical) {
  const std::size_t joints = CountJoints(typical);
  return fmt::format("{}, {}{}", MassText(variants), SizeText(variants),
                     joints > 0 ? ", " + Counted(joints, "joint") : "");
}

std::vector<report::FeatureTable> FeaturesOf(const model::Object& object) {
  report::FeatureTable joints{"Joints", {}};
  report::FeatureTable grasps{"Sites for grasps", {}};
  report::FeatureTable regions{"Regions where things can stand", {}};
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints)
      joints.rows.emplace_back(ShortName(object, joint.name), JointText(joint));
    for (const model::Site& site : body.sites) {
      const std::string name = ShortName(object, site.name);
      if (name.find("grasp") != name.npos)
        grasps.rows.emplace_back(name, "on " + ShortName(object, body.name));
    }
    for (const model::Region& region : body.regions)
      regions.rows.emplace_back(region.name, RegionText(region));
  }
  std::vector<report::FeatureTable> tables;
  Add(std::move(joints), tables);
  Add(TableOf(object, "Actuators", "actuator"), tables);
  Add(TableOf(object, "Sensors", "sensor"), tables);
  Add(std::move(grasps), tables);
  Add(std::move(regions), tables);
  return tables;
}

report::FeatureTable TargetsOf(const forge::Recipe& recipe, diag::Sources& sources,
                               const forge::Options& options, std::uint64_t index) {
  report::FeatureTable table{"Targets", {}};
  for (const mjcf::TargetRules& rules : mjcf::Targets()) {
    if (!rules.adapts()) {
      table.rows.emplace_back(rules.name, "yes");
      continue;
    }
    forge::Options adapted = options;
    adapted.target = rules.target;
    forge::Variant variant;
    forge::Generator(recipe, sources, adapted).Make(index, variant);
    const std::string note = variant.findings.empty() ? "" : variant.findings[0].message;
    table.rows.emplace_back(rules.name, variant.ok() && note.empty() ? "yes"
                                        : variant.ok()               ? "yes; " + note
                                                                     : "no: " + note);
  }
  return table;
}

}  // namespace mjforge::app
