// Adds the bodies of `bodies:`: inline bodies, other specs, and bodies of MJCF files.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/assembly.h"
#include "mjforge/assemble/names.h"
#include "mjforge/assemble/pose_reader.h"
#include "mjforge/assemble/whole_properties.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {
namespace {

using diag::Code;
using spec::Key;

// Clears the variables for properties of a body (NAME.mass) and for the parameters of its nested
// spec: if `if` leaves the body out, expressions must find no value.
void ClearProperties(const spec::BodyEntry& entry, sample::Evaluator& values) {
  ClearSlots(entry.first_property, spec::BodyPropertyNames().size(), values);
  for (std::size_t i = 0; i < entry.parameter_slots.size(); ++i) {
    const int slot = entry.parameter_slots[i];
    if (slot >= 0) values.ClearVariables(slot, -1, entry.head.nested->parameters[i].value);
  }
}

// Returns the position of a body's origin for `placement: corner`. `p` is the required position of
// the lower corner of the body's rotated bounding box, relative to the lower corner of the box that
// the spec declares by `total_size:` (half sizes). `min` and `max` bound the body in its own frame.
Eigen::Vector3d OriginFromCorner(const Eigen::Vector3d& p, const Eigen::Quaterniond& q,
                                 const Eigen::Vector3d& total_size, const Eigen::Vector3d& min,
                                 const Eigen::Vector3d& max) {
  const Eigen::Matrix3d R = q.toRotationMatrix();
  const Eigen::Vector3d center = R * ((min + max) / 2);
  const Eigen::Vector3d half = R.cwiseAbs() * ((max - min) / 2);
  const Eigen::Vector3d lower = center - half;
  return p - (total_size + lower);
}

// Adds the name of a chain's link to the prefix of names, so that the names of the link's parts,
// sites and views begin with the link's name.
void EnterLink(Scope& scope, const Link& link, const std::string& name) {
  if (link.chain == nullptr) return;
  scope.link = name + "_";
  scope.prefix += scope.link;
}

void LeaveLink(Scope& scope) {
  scope.prefix = scope.outer_prefix();
  scope.link.clear();
}

}  // namespace

void Assembly::AddBodies(Scope& scope) {
  const spec::ObjectSpec& spec = scope.values.spec();
  const sample::StreamId bodies = sample::Child(scope.values.root(), "bodies");
  for (const spec::BodyEntry& entry : spec.bodies) ClearProperties(entry, scope.values);
  for (const spec::BodyEntry& entry : spec.bodies) {
    repetition_.Expand(entry.head, scope.values, bodies, object_.bodies.size(),
                       [&] { AddBody(scope, entry, bodies); });
  }
}

void Assembly::ForEachJointed(Scope& scope, const JointedVisitor& visit) {
  for (const Scope::Jointed& jointed : scope.jointed) {
    scope.values.Restore(jointed.variables);
    visit(*jointed.entry, jointed.body);
  }
}

void Assembly::AddListedJoints(Scope& scope) {
  const std::size_t outer = current_body_;
  ForEachJointed(scope, [&](const spec::BodyEntry& entry, std::size_t index) {
    current_body_ = index;
    AddJoints(scope, entry.joints, JointsOf(scope, index));
  });
  current_body_ = outer;
}

sample::StreamId Assembly::JointsOf(const Scope& scope, std::size_t body) const {
  const std::string_view name =
      std::string_view(object_.bodies[body].name).substr(scope.prefix.size());
  const sample::StreamId bodies = sample::Child(scope.values.root(), "bodies");
  return sample::Child(sample::Child(bodies, name), "joints");
}

void Assembly::AddBody(Scope& scope, const spec::BodyEntry& entry, sample::StreamId bodies) {
  const std::optional<std::string> name = ReadName(scope, entry.head, bodies, findings_);
  if (!name || left_out_.contains(scope.prefix + *name)) return;
  const spec::Entry* links = entry.head.FindChild(spec::kChainElement);
  if (links == nullptr) {
    AddBody(scope, entry, *name, bodies, {});
    return;
  }
  FieldReader reader(scope.values, findings_, "body", *name,
                     sample::Child(bodies, std::string_view(*name)));
  const std::optional<Chain> chain = ReadChain(reader, *links);
  if (!chain) return;
  Link link = {.chain = &*chain};
  for (; link.number < chain->links && !is_full_; ++link.number) {
    const int index = static_cast<int>(object_.bodies.size());
    AddBody(scope, entry, fmt::format("{}_{}", *name, link.number), bodies, link);
    if (object_.bodies.size() == static_cast<std::size_t>(index)) return;
    link.previous = index;
  }
}

void Assembly::AddBody(Scope& scope, const spec::BodyEntry& entry, const std::string& name,
                       sample::StreamId bodies, const Link& link) {
  if (!HasRoomFor("bodies", object_.bodies.size(), entry.head.mark)) return;
  const sample::StreamId path = sample::Child(bodies, std::string_view(name));
  FieldReader reader(scope.values, findings_, "body", name, path);
  const std::size_t index = object_.bodies.size();
  const auto [twin, is_new] = bodies_.emplace(scope.prefix + name, static_cast<int>(index));
  if (!is_new) {
    ReportRepeatedName("body", twin->first, entry.head.mark,
                       object_.bodies[static_cast<std::size_t>(twin->second)].mark, {}, findings_);
    return;
  }
  {
    model::Body& body = object_.bodies.emplace_back();
    body.name = twin->first;
    body.mark = entry.head.mark;
  }
  const bool is_inner_link = link.number > 0;
  // A body without a valid parent remains, so that its content is checked, too. A body with
  // `place:` is a child of the world until PlaceBodies() finds its parent.
  if (is_inner_link)
    object_.bodies[index].parent = link.previous;
  else if (!entry.place)
    object_.bodies[index].parent = ParentOf(scope, reader, entry.head);

  const model::Bounds bounds = AddContents(scope, entry, reader, name, link);
  if (is_inner_link)
    object_.bodies[index].X_PB.p = -link.chain->pitch * Eigen::Vector3d::UnitZ();
  else if (!entry.place)
    SetBodyPose(scope, reader, entry.head, bounds, object_.bodies[index]);
}

model::Bounds Assembly::AddContents(Scope& scope, const spec::BodyEntry& entry, FieldReader& reader,
                                    const std::string& name, const Link& link) {
  // The parts, sites and joints that are added next belong to the last body.
  const std::size_t index = object_.bodies.size() - 1;
  const sample::StreamId path = reader.path();
  const bool by_corner = scope.places_corners();
  const std::size_t outer = std::exchange(current_body_, index);
  const model::Pose X_BS = std::exchange(scope.X_BS, model::Pose());
  const auto total_size = std::exchange(scope.total_size, std::nullopt);
  FillBody(scope, entry, reader, name, link);
  model::Bounds bounds;
  if (by_corner || entry.first_property >= 0) bounds = model::SubtreeBounds(object_.bodies, index);
  SetProperties(scope, entry, bounds, index);
  EnterLink(scope, link, name);
  AddSites(scope, entry.sites, sample::Child(path, "sites"));
  AddRegions(scope, entry.regions, name + "_", sample::Child(path, "regions"));
  AddViews(scope, entry.views, path);
  LeaveLink(scope);
  AddOwnJoints(entry, link);
  if (link.number == 0 && !entry.joints.empty())
    scope.jointed.push_back({&entry, index, scope.values.Save(entry.head)});
  ReadAttributes(reader, entry.head, object_.bodies[index].attributes);
  current_body_ = outer;
  scope.X_BS = X_BS;
  scope.total_size = total_size;
  return bounds;
}

// Adds the joints between a chain's link and the previous link, or the free joint of a free body.
// The first link of a chain has these joints only if its entry has no key `joints:`.
void Assembly::AddOwnJoints(const spec::BodyEntry& entry, const Link& link) {
  if (link.chain != nullptr && (link.number > 0 || !entry.has_joints))
    body().joints = JointsOfLink(*link.chain, body().name, entry.head.mark);
  else if (entry.is_free)
    body().joints.emplace_back().name = body().name + "_joint0";
}

void Assembly::FillBody(Scope& scope, const spec::BodyEntry& entry, FieldReader& reader,
                        const std::string& name, const Link& link) {
  const std::size_t index = current_body_;
  const sample::StreamId path = reader.path();
  if (entry.head.nested != nullptr) {
    std::optional<sample::Evaluator> nested = SampleNested(scope, entry.head, path);
    if (!nested) return;
    Scope inner(*nested, scope.prefix + name + "_", static_cast<int>(index), model::Pose());
    SetSubstitutes(scope, entry.head, path, inner);
    AddSpec(inner);
    object_.bodies[index].front = FrontOf(inner);
    // A body that is free in both specs keeps its free joint, which has the same name in both.
    const bool keeps_joint =
        entry.is_free && link.number == 0 && nested->spec().root_joints == spec::RootJoints::kFree;
    if (!keeps_joint) MarkRootJointsRemoved(inner);
    for (std::size_t i = 0; i < entry.parameter_slots.size(); ++i) {
      const int slot = entry.parameter_slots[i];
      if (slot >= 0) scope.values.Assign(slot, nested->Parameter(i));
    }
  } else if (entry.head.Find(Key::kMjcf) != nullptr) {
    part_count_ += attacher_.Add(scope, reader, entry.head, name, index);
    if (part_count_ > 0) HasRoomFor("parts", part_count_ - 1, entry.head.mark);
  } else {
    const sample::StreamId outer = std::exchange(scope.parts, sample::Child(path, "parts"));
    EnterLink(scope, link, name);
    AddParts(scope, entry.parts, model::Pose());
    LeaveLink(scope);
    scope.parts = outer;
  }
  assets_.SumMass(object_.bodies[index]);
  const spec::Field* field = entry.head.Find(Key::kMass);
  const std::optional<double> mass = field == nullptr ? std::nullopt : reader.Number(*field);
  if (!mass) return;
  const double sum = model::SubtreeMass(object_.bodies, index).mass;
  if (sum > 0) {
    model::ScaleMass(*mass / sum, object_.bodies, current_body_, body().parts.size(), index);
  } else {
    reader.Report(Code::kModelNoMass, *field, "cannot be reached: no part has mass");
  }
}

int Assembly::ParentOf(Scope& scope, FieldReader& reader, const spec::Entry& entry) {
  const spec::Field* field = entry.Find(Key::kParent);
  if (field == nullptr) return scope.body;
  const std::optional<std::string> name = reader.Text(*field);
  if (!name || *name == scope.values.spec().name) return scope.body;
  const auto found = bodies_.find(scope.prefix + *name);
  const auto own = static_cast<int>(object_.bodies.size()) - 1;
  if (found != bodies_.end() && found->second != own) return found->second;
  if (left_out_.contains(scope.prefix + *name)) {
    findings_.Add(
        Code::kSpecBadParent, field->value.mark,
        fmt::format("{}: its parent {} was left out, because there was no room for it",
                    reader.Owner(), Quoted(*name)),
        "in place of `parent:`, `place:` at it and `fewer: true` leave out this one, too");
    return scope.body;
  }
  std::vector<std::string_view> names = {scope.values.spec().name};
  for (const auto& [full, index] : bodies_) {
    if (full.starts_with(scope.prefix) && index != scope.body && index != own) {
      names.push_back(std::string_view(full).substr(scope.prefix.size()));
    }
  }
  diag::Finding& finding =
      findings_.Add(Code::kSpecBadParent, field->value.mark,
                    fmt::format("{}: no earlier body {}", reader.Owner(), Quoted(*name)),
                    diag::DidYouMean(*name, names));
  finding.notes.push_back({entry.mark, "parents come before children; this one is defined here"});
  return scope.body;
}

double Assembly::FrontOf(Scope& scope) {
  const spec::ObjectSpec& spec = scope.values.spec();
  if (!spec.front) return 0;
  FieldReader reader(scope.values, findings_, "object", spec.name, scope.values.root());
  const auto direction = reader.Vector<2>(*spec.front);
  if (!direction) return 0;
  if (direction->isZero(0)) reader.Report(Code::kModelBadRotation, *spec.front, "is zero");
  return std::atan2((*direction)[0], -(*direction)[1]);
}

void Assembly::SetProperties(Scope& scope, const spec::BodyEntry& entry,
                             const model::Bounds& bounds, std::size_t index) {
  if (entry.first_property < 0) return;
  const double mass = model::SubtreeMass(object_.bodies, index).mass;
  SetMeasures(bounds, mass, entry.first_property, scope.values);
  scope.body_masses.emplace_back(entry.first_property + static_cast<int>(spec::BodyProperty::kMass),
                                 mass);
}

void Assembly::SetBodyPose(Scope& scope, FieldReader& reader, const spec::Entry& entry,
                           const model::Bounds& bounds, model::Body& body) {
  const std::optional<model::Pose> X_PB = ReadPose(reader, entry);
  if (!X_PB) return;
  body.X_PB = *X_PB;
  if (body.parent != scope.body) return;
  if (scope.places_corners() && !bounds.aabb.empty()) {
    body.X_PB.p =
        OriginFromCorner(X_PB->p, X_PB->q, *scope.total_size, bounds.aabb.min, bounds.aabb.max);
  }
  body.X_PB = scope.X_BS * body.X_PB;
}

}  // namespace mjforge::assemble
