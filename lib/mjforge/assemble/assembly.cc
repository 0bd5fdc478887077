// Assembly: order in which the elements of a spec are added, and entries of `parts:` (parts,
// frames, specs).

#include "mjforge/assemble/assembly.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"
#include "mjforge/assemble/pose_reader.h"
#include "mjforge/assemble/views.h"
#include "mjforge/model/model.h"

namespace mjforge::assemble {

using diag::Code;

Scope::Scope(sample::Evaluator& evaluator, std::string name_prefix, int root,
             const model::Pose& X_BodyS)
    : values(evaluator),
      prefix(std::move(name_prefix)),
      body(root),
      X_BS(X_BodyS),
      parts(sample::Child(evaluator.root(), "parts")),
      materials(evaluator.spec().materials.size()) {}

std::optional<model::Object> Assembly::Run(sample::Evaluator& values,
                                           const Assembler::Options& options) {
  const std::size_t before = findings_.size();
  const spec::ObjectSpec& spec = values.spec();
  spec_ = &spec;
  place_seed_ = options.place_seed;
  assets_.SetFolder(spec.folder);
  const std::size_t left_out = left_out_.size();
  object_.left_out.assign(left_out_.begin(), left_out_.end());
  object_.name = options.name.empty() ? spec.name : options.name;
  if (!IsName(object_.name)) {
    findings_.Add(Code::kModelBadName, {},
                  fmt::format("object name {} is not a valid name", Quoted(object_.name)),
                  std::string(kNameRule));
  }
  model::Body& root = object_.bodies.emplace_back();
  root.name = options.root.empty() ? object_.name : options.root;
  bodies_.emplace(root.name, 0);
  Scope scope(values, options.prefix ? object_.name + "_" : std::string(), 0, model::Pose());
  if (!spec.parts.empty()) {
    root.mark = spec.parts.front().mark;
  } else if (!spec.bodies.empty()) {
    root.mark = spec.bodies.front().head.mark;
  }
  AddSpec(scope);
  if (left_out_.size() > left_out) return std::nullopt;  // the object is assembled again
  ReadStartForm(scope);
  ReadChecks(scope);
  if (!findings_.HasErrors(before)) Finish(scope);
  if (findings_.HasErrors(before) || values.failed()) return std::nullopt;
  ReportEmptySearches(empty_searches_, findings_);
  return std::move(object_);
}

std::optional<std::string> ReadName(Scope& scope, const spec::Entry& entry, sample::StreamId list,
                                    diag::Findings& findings) {
  std::optional<std::string> name = scope.values.Text(entry.name, list);
  if (!name || IsName(*name)) return name;
  findings.Add(Code::kModelBadName, entry.name.mark,
               fmt::format("{} name {} is not a valid name", entry.element->name, Quoted(*name)),
               std::string(kNameRule));
  return std::nullopt;
}

bool Assembly::HasRoomFor(std::string_view what, std::size_t count, diag::SourceMark mark) {
  if (is_full_) return false;
  is_full_ = count >= static_cast<std::size_t>(model::kMaxParts);
  if (is_full_) {
    findings_.Add(Code::kModelTooManyParts, mark,
                  fmt::format("the object has more than {} {}", model::kMaxParts, what));
  }
  return !is_full_;
}

void Assembly::AddSpec(Scope& scope) {
  const spec::ObjectSpec& spec = scope.values.spec();
  const std::size_t first_part = body().parts.size();
  const std::size_t first_body = object_.bodies.size();
  const std::size_t first_start = starts_.size();
  const std::size_t first_search = face_searches_.size();
  ReadTotalSize(scope);
  AddParts(scope, spec.parts, model::Pose());
  AddSites(scope, spec.sites, sample::Child(scope.values.root(), "sites"));
  AddRegions(scope, spec.regions, "", sample::Child(scope.values.root(), "regions"));
  AddViews(scope, spec.views, scope.values.root());
  if (!spec.bodies.empty()) AddBodies(scope);
  if (spec.mass) ScaleObject(scope, first_part, first_body);
  const std::size_t before = findings_.size();
  SetWholeProperties(scope);
  // Skips the joints after an error, because they would report the same error again.
  const bool has_all = !findings_.HasErrors(before);
  if (has_all) AddListedJoints(scope);
  if (!spec.sections.empty()) sections_.Add(scope, &spec == spec_);
  if (has_all && &spec == spec_) AddRootJoints(scope);
  ReadStarts(scope);
  ApplyStarts(scope, first_start, first_body);
  for (std::size_t i = first_search; i < face_searches_.size(); ++i) {
    FaceSearch& search = face_searches_[i];
    if (search.last_body > 0) continue;  // the search belongs to a nested spec
    search.root = current_body_;
    search.first_part = first_part;
    search.last_part = body().parts.size();
    search.first_body = first_body;
    search.last_body = object_.bodies.size();
  }
  if (!spec.has_place) return;
  SearchFaces(first_search);
  PlaceBodies(scope);
}

void Assembly::ReadTotalSize(Scope& scope) {
  const spec::ObjectSpec& spec = scope.values.spec();
  if (!spec.total_size) return;
  FieldReader reader(scope.values, findings_, "object", spec.name, scope.values.root());
  scope.total_size = reader.Vector<3>(*spec.total_size);
}

void Assembly::ReadStartForm(Scope& scope) {
  const spec::ObjectSpec& spec = scope.values.spec();
  if (!spec.start) return;
  FieldReader reader(scope.values, findings_, "object", spec.name, scope.values.root());
  const std::optional<std::string> word = reader.Word(*spec.start);
  if (!word) return;
  if (!object_.start_mark) object_.start_mark = spec.start->mark;
  object_.start_form = *word == "zero" ? model::StartForm::kZero : model::StartForm::kKeyframe;
}

void Assembly::AddParts(Scope& scope, const std::vector<spec::Entry>& entries,
                        const model::Pose& X_SF) {
  if (body().parts.empty()) body().parts.reserve(entries.size());
  for (const spec::Entry& entry : entries) {
    if (!repetition_.Count(entry, scope.values, part_count_)) continue;
    const sample::StreamId list =
        entry.is_frame ? sample::Child(scope.parts, "frames") : scope.parts;
    repetition_.ForEach(entry, scope.values, list, [&] {
      if (entry.is_frame) {
        AddFrame(scope, entry, X_SF);
      } else if (entry.nested != nullptr) {
        AddWeld(scope, entry, X_SF);
      } else {
        AddPart(scope, entry, X_SF);
      }
    });
  }
}

// Adds the parts of a frame. The name of a frame is optional: it only selects the random stream for
// draws in the frame's pose.
void Assembly::AddFrame(Scope& scope, const spec::Entry& entry, const model::Pose& X_SF) {
  const sample::StreamId frames = sample::Child(scope.parts, "frames");
  const std::string name = scope.values.Text(entry.name, frames).value_or("");
  FieldReader reader(scope.values, findings_, "frame", name,
                     sample::Child(frames, std::string_view(name)));
  const std::optional<model::Pose> X_FChild = ReadPose(reader, entry);
  // Checks the parts of the frame for other errors even if the pose of the frame is invalid.
  AddParts(scope, entry.children, X_SF * X_FChild.value_or(model::Pose()));
}

// Adds a spec that an entry of `parts:` names: its root elements become elements of the current
// body (welded). Counts empty specs, too, because the number of specs doubles with each level of
// nesting if each spec contains the next one twice.
void Assembly::AddWeld(Scope& scope, const spec::Entry& entry, const model::Pose& X_SF) {
  if (!HasRoomFor("specs in it", spec_count_++, entry.mark)) return;
  const std::optional<std::string> name = ReadName(scope, entry, scope.parts, findings_);
  if (!name) return;
  const sample::StreamId path = sample::Child(scope.parts, std::string_view(*name));
  FieldReader reader(scope.values, findings_, "part", *name, path);
  const std::optional<model::Pose> X_FW = ReadPose(reader, entry);

  if (!X_FW) return;
  std::optional<sample::Evaluator> nested = SampleNested(scope, entry, path);
  if (!nested) return;

  const model::Pose X_SW = X_SF * *X_FW;
  const bool corner = scope.places_corners();
  Scope inner(*nested, scope.prefix + *name + "_", static_cast<int>(current_body_),
              corner ? model::Pose{.q = X_SW.q} : scope.X_BS * X_SW);
  SetSubstitutes(scope, entry, path, inner);
  const ElementCounts before = {body().parts.size(), body().sites.size(), body().regions.size(),
                                body().elements.size(), object_.bodies.size()};
  AddSpec(inner);
  MarkRootJointsRemoved(inner);
  if (!corner) return;
  // Moves the added elements so that the lower corner of the box around their parts and bodies is
  // at the required position. The corner is known only after they were added.
  const model::Box3 box =
      model::SubtreeBounds(object_.bodies, current_body_, before.parts, before.bodies).aabb;
  if (box.empty()) return;
  Move(scope.X_BS * model::Pose{.p = FromCorner(X_SW.p, *scope.total_size, box.min)}, before,
       inner.body);
}

void Assembly::Move(const model::Pose& X_BC, const ElementCounts& from, int parent) {
  for (std::size_t i = from.parts; i < body().parts.size(); ++i) {
    body().parts[i].X_BG = X_BC * body().parts[i].X_BG;
  }
  for (std::size_t i = from.sites; i < body().sites.size(); ++i) {
    body().sites[i].X_BS = X_BC * body().sites[i].X_BS;
  }
  for (std::size_t i = from.regions; i < body().regions.size(); ++i) {
    body().regions[i].X_BR = X_BC * body().regions[i].X_BR;
  }
  for (std::size_t i = from.views; i < body().elements.size(); ++i) {
    MoveView(X_BC, body().elements[i]);
  }
  for (std::size_t i = from.bodies; i < object_.bodies.size(); ++i) {
    model::Body& moved = object_.bodies[i];
    if (moved.parent == parent) moved.X_PB = X_BC * moved.X_PB;
  }
}

// Scales the masses of a spec's parts and bodies so that they add up to the spec's `mass:`.
void Assembly::ScaleObject(Scope& scope, std::size_t first_part, std::size_t first_body) {
  const spec::ObjectSpec& spec = scope.values.spec();
  FieldReader reader(scope.values, findings_, "object", spec.name, scope.values.root());
  const std::optional<double> mass = reader.Number(*spec.mass);
  if (!mass) return;
  double sum = 0.0;
  for (std::size_t i = first_part; i < body().parts.size(); ++i) sum += body().parts[i].mass;
  for (std::size_t i = first_body; i < object_.bodies.size(); ++i) {
    sum += object_.bodies[i].mass_properties.mass;
  }
  if (!(sum > 0)) {
    if (part_count_ == 0) return;  // Finish() reports a lack of parts
    reader.Report(Code::kModelNoMass, *spec.mass, "cannot be reached: no part has mass");
    return;
  }
  const double factor = *mass / sum;
  model::ScaleMass(factor, object_.bodies, current_body_, first_part, first_body);
  for (const auto& [slot, body_mass] : scope.body_masses)
    scope.values.SetVariable(slot, body_mass * factor);
}

}  // namespace mjforge::assemble
