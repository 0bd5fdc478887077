// Loader: loads documents and files in MuJoCo, and reports MuJoCo's errors and warnings as
// findings.
#include "mjforge/validate/validate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/backport/backport.h"
#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/validate/compare.h"
#include "mjforge/validate/joint_sweep.h"
#include "mjforge/validate/later_refusals.h"
#include "mjforge/validate/release_differences.h"
#include "mjforge/validate/self_collisions.h"
#include "mjforge/xml/xml.h"

namespace mjforge::validate {
namespace {

using diag::Code;
using engine::Engine;
using engine::Loaded;
using engine::OneLine;
using engine::Refusal;

diag::SourceMark MarkOf(const model::Object& object) {
  return object.bodies.empty() ? diag::SourceMark{} : object.bodies.front().mark;
}

/// Returns the largest number of constraint rows, in one step, of the limits and the dry friction
/// of the joints of a body.
int CountConstraints(const model::Body& body) {
  int rows = 0;
  for (const model::Joint& joint : body.joints) {
    if (joint.range) rows += 2;
    for (const model::Attribute& attribute : joint.attributes) {
      if (attribute.name == "frictionloss") rows += 6;
    }
  }
  return rows;
}

/// Returns a `<size>` element with small buffers, because clearing buffers of default size takes
/// most of the time of a load, and the size of MuJoCo's stack depends on njmax. A single body has
/// no contacts, and several bodies seldom have many; if they do, MuJoCo warns. The text has no line
/// end, so that line numbers stay the same; the text is empty if the object has a size element.
std::string SizeHint(const model::Object& object) {
  constexpr int kContacts = 12;
  constexpr int kRowsOfContact = 10;  // condim 6, pyramidal
  if (!model::ElementsOf(object, "size").empty()) return {};
  const int contacts = object.bodies.size() > 1 ? kContacts : 0;
  int rows = kRowsOfContact * contacts;
  for (const model::Body& body : object.bodies) rows += CountConstraints(body);
  rows += 6 * static_cast<int>(model::ElementsOf(object, "equality").size() +
                               model::ElementsOf(object, "tendon").size());
  return fmt::format("<size njmax=\"{}\" nconmax=\"{}\"/>", rows, contacts);
}

int LineOf(std::string_view text, std::string_view needle) {
  const std::size_t at = text.find(needle);
  if (at == std::string_view::npos) return 0;
  return 1 + static_cast<int>(std::ranges::count(text.substr(0, at), '\n'));
}

/// Returns true for a warning after which the model can still be used.
bool IsMinor(std::string_view warning) { return warning.starts_with(engine::kHullWarning); }

/// Adds a finding for each warning of MuJoCo, and for each memory limit of MuJoCo 2.2 that the
/// model exceeds. Leaves the memory limits out if `crowded`, because then findings about bodies
/// that touch explain them. Returns true if a finding is an error.
bool AddWarnings(const Loaded& loaded, bool crowded, diag::SourceMark mark,
                 diag::Findings& findings) {
  for (const std::string& warning : loaded.warnings) {
    diag::Finding& finding =
        findings.Add(Code::kMujocoWarning, mark, fmt::format("MuJoCo warns: {}", OneLine(warning)));
    if (IsMinor(warning)) finding.severity = diag::Severity::kWarning;
  }
  for (const auto& [effect, remedy] : loaded.shortages) {
    if (crowded) continue;
    findings.Warn(Code::kMujocoOlder, mark, fmt::format("MuJoCo {} {}", engine::Version(), effect),
                  fmt::format("later releases reserve memory as needed; write {} in `size` for "
                              "this one",
                              remedy));
  }
  return !std::ranges::all_of(loaded.warnings, IsMinor);
}

/// Returns the result of `compute`; adds a finding and returns nullopt if MuJoCo fails.
template <typename Compute>
auto Computed(const Compute& compute, diag::SourceMark mark, diag::Findings& findings) {
  std::optional<decltype(compute())> result;
  const std::optional<std::string> failure = engine::FailureOf([&] { result = compute(); });
  if (failure) {
    findings.Add(Code::kMujocoError, mark,
                 fmt::format("MuJoCo cannot place the bodies: {}", OneLine(*failure)));
  }
  return result;
}

/// Adds findings about bodies that touch at the start or in the zero configuration. Returns true if
/// it adds findings, including a failure of MuJoCo.
bool FindTouching(mjModel& m, const model::Object& object, diag::Findings& findings) {
  if (object.bodies.size() < 2) return false;
  return Computed([&] { return CheckSelfCollision(m, object, findings); }, MarkOf(object), findings)
      .value_or(true);
}

std::optional<Sweep> TrySweep(mjModel& m, int frame, diag::SourceMark mark,
                              diag::Findings& findings) {
  return Computed([&] { return SweepModel(m, frame); }, mark, findings);
}

/// Adds a finding about an element that MuJoCo rejects, with MuJoCo's own words as a note.
void AddRefusal(std::string_view element, const Loaded& loaded, diag::SourceMark mark,
                std::string hint, diag::Findings& findings) {
  diag::Finding& finding = findings.Add(
      Code::kMujocoError, mark,
      fmt::format("MuJoCo refused {}: {}", element, engine::ParseRefusal(loaded.error).reason),
      std::move(hint));
  finding.notes.push_back({{}, fmt::format("MuJoCo said: {}", OneLine(loaded.error))});
}

/// Adds a finding about a start keyframe that is too long for MuJoCo 2.2.
void AddKeyLimit(std::string_view key, diag::SourceMark mark, diag::Findings& findings) {
  findings.Add(
      Code::kMujocoOlder, mark,
      fmt::format("MuJoCo {} rejects {}, which has more than {} numbers", engine::Version(), key,
                  backport::kMaxKeyNumbers),
      "later releases have no such limit; `--start zero --target scene` writes no keyframe");
}

/// Adds an error for each array of mjModel with a number that is not finite, because MuJoCo loads
/// "nan" silently.
void CheckFinite(const mjModel& m, diag::SourceMark mark, diag::Findings& findings) {
  struct Numbers {
    std::string_view kind;
    std::string_view what;
    const mjtNum* first;
    int per_element;
    int elements;
    const int* names;
  };
  const Numbers all[] = {{"body", "mass", m.body_mass, 1, m.nbody, m.name_bodyadr},
                         {"body", "inertia", m.body_inertia, 3, m.nbody, m.name_bodyadr},
                         {"body", "pos", m.body_pos, 3, m.nbody, m.name_bodyadr},
                         {"body", "quat", m.body_quat, 4, m.nbody, m.name_bodyadr},
                         {"geom", "size", m.geom_size, 3, m.ngeom, m.name_geomadr},
                         {"geom", "pos", m.geom_pos, 3, m.ngeom, m.name_geomadr},
                         {"geom", "quat", m.geom_quat, 4, m.ngeom, m.name_geomadr},
                         {"geom", "friction", m.geom_friction, 3, m.ngeom, m.name_geomadr},
                         {"joint", "pos", m.jnt_pos, 3, m.njnt, m.name_jntadr},
                         {"joint", "axis", m.jnt_axis, 3, m.njnt, m.name_jntadr},
                         {"joint", "range", m.jnt_range, 2, m.njnt, m.name_jntadr},
                         {"site", "pos", m.site_pos, 3, m.nsite, m.name_siteadr}};
  // Returns the index of the first number that is not finite, or `count`.
  const auto first_bad = [](const mjtNum* first, int count) {
    return std::find_if(first, first + count, [](mjtNum n) { return !std::isfinite(n); }) - first;
  };
  const auto add = [&](const std::string& what) {
    findings.Add(Code::kMujocoWarning, mark,
                 fmt::format("MuJoCo loaded a {} that is not a finite number", what));
  };
  for (const auto& [kind, what, first, per_element, elements, names] : all) {
    const auto bad = first_bad(first, per_element * elements) / per_element;
    if (bad < elements) add(fmt::format("{} of {} '{}'", what, kind, m.names + names[bad]));
  }
  const auto bad = first_bad(m.qpos0, m.nq);
  if (bad < m.nq) add(fmt::format("start position {}", bad + 1));
}

CompiledModel Describe(const mjModel& m) {
  CompiledModel described;
  described.object = compiled::ObjectOf(m, {}, compiled::Nameless::kEmpty);
  described.body_geoms.assign(m.body_geomnum + 1, m.body_geomnum + m.nbody);
  described.joints = m.njnt;
  described.geoms = m.ngeom;
  described.sites = m.nsite;
  const auto add = [&](const std::string& kind, const int* names, int count) {
    for (int i = 0; i < count; ++i) described.elements.push_back({kind, m.names + names[i]});
  };
  add("camera", m.name_camadr, m.ncam);
  add("light", m.name_lightadr, m.nlight);
  add("pair", m.name_pairadr, m.npair);
  add("exclude", m.name_excludeadr, m.nexclude);
  add("equality", m.name_eqadr, m.neq);
  add("tendon", m.name_tendonadr, m.ntendon);
  add("actuator", m.name_actuatoradr, m.nu);
  add("sensor", m.name_sensoradr, m.nsensor);
  return described;
}

/// Returns a hint for errors that MuJoCo does not explain; empty for other errors.
std::string HintFor(std::string_view reason) {
  if (reason.starts_with("qhull error"))
    return "give the mesh some thickness, or let another shape collide in its place";
  if (reason.find("XML_ELEMENT_DEPTH_EXCEEDED") == std::string_view::npos) return {};
  return "MuJoCo 2.2 reads bodies nested at most 95 deep: attach some of them to the root";
}

/// Loads a document; adds a finding if MuJoCo rejects it. Inserts `hint`, a `<size>` element,
/// unless MuJoCo reports errors, shortages of memory or warnings with this element.
Loaded LoadDocument(Engine& engine, const mjcf::MjcfDocument& document, const std::string& hint,
                    const model::Object& object, diag::Findings& findings) {
  if (const auto problem = engine.SetAssets(document.assets)) {
    const std::string& name = document.assets[problem->asset].name;
    findings.Add(problem->code, document.Origin(LineOf(document.text, '"' + name + '"')),
                 problem->message);
    return {};
  }
  if (!hint.empty() && document.size_position != std::string::npos) {
    std::string text = document.text;
    text.insert(document.size_position, hint);
    Loaded loaded = engine.LoadText(text);
    if (loaded.model && loaded.shortages.empty() && std::ranges::all_of(loaded.warnings, IsMinor))
      return loaded;
  }
  Loaded loaded = engine.LoadText(document.text);
  if (loaded.model) return loaded;
  AddWarnings(loaded, false, MarkOf(object), findings);
  const Refusal refusal = engine::ParseRefusal(loaded.error, document.text);
  diag::SourceMark mark = document.Origin(refusal.line);
  if (!mark) mark = MarkOf(object);
  const std::string element = engine::ElementOnLine(document.text, refusal.line);
  if (element.starts_with("key ") && refusal.reason.ends_with("has too much data")) {
    AddKeyLimit(element, mark, findings);
  } else {
    AddRefusal(element, loaded, mark, HintFor(refusal.reason), findings);
  }
  return loaded;
}

/// Loads a file. Adds a finding and returns null if MuJoCo rejects the file. Sets `start` to the
/// place of the file's first character if the file can be read.
engine::Model LoadFile(Engine& engine, const std::filesystem::path& file, diag::Sources& sources,
                       diag::SourceMark& start, diag::Findings& findings) {
  const std::optional<backport::ModelFile> xml = backport::ReadModelFile(file, sources, findings);
  if (!xml) return nullptr;
  start = {xml->source, 1, 1};
  Loaded loaded = backport::LoadFile(engine, file, *xml);
  AddWarnings(loaded, false, start, findings);
  if (loaded.model) {
    CheckFinite(*loaded.model, start, findings);
    if (xml->differences)
      CompareReleases(*loaded.model, engine.LoadFile(file), xml->differences, findings);
    FindLaterRefusals(*loaded.model, start, findings);
    return std::move(loaded.model);
  }
  if (loaded.fault) {
    // A text that was backported has the lines of the source, but other columns.
    findings.Add(loaded.fault->code,
                 xml->backported ? xml::MarkOfLine(sources, xml->source, loaded.fault->line)
                                 : xml::MarkAt(sources, xml->source, loaded.fault->offset),
                 loaded.error);
    return nullptr;
  }
  const std::string_view text = xml->has_includes ? std::string_view() : sources.Text(xml->source);
  const Refusal refusal = engine::ParseRefusal(loaded.error, text);
  const std::string element = engine::ElementOnLine(text, refusal.line);
  AddRefusal(element, loaded, xml::MarkOfLine(sources, xml->source, refusal.line),
             xml->has_includes ? "the line may be in an included file" : HintFor(refusal.reason),
             findings);
  return nullptr;
}

}  // namespace

std::string MujocoVersion() { return engine::Version(); }

struct Loader::Impl {
  Engine engine;
};

Loader::Loader() : impl_(std::make_unique<Impl>()) {}
Loader::~Loader() = default;

bool Loader::Validate(const mjcf::MjcfDocument& document, const model::Object& object,
                      diag::Findings& findings, structure::Structure* structure,
                      family::Numbers* numbers) {
  const Loaded loaded = LoadDocument(impl_->engine, document, SizeHint(object), object, findings);
  if (!loaded.model) return false;
  if (structure != nullptr) *structure = structure::StructureOf(*loaded.model, object.name);
  // No check below solves constraints, whose buffers take most of the memory of a scene.
  engine::SetBufferSizes(*loaded.model, {});
  diag::Findings found;
  Comparison(*loaded.model, object, found).Run(document.lift);
  const bool crowded = found.empty() && FindTouching(*loaded.model, object, found);
  FindLaterRefusals(*loaded.model, object, found);
  if (numbers != nullptr && !found.HasErrors())
    *numbers = family::Read(*loaded.model, object, document);
  const bool as_meant = !found.HasErrors();
  const bool warned = AddWarnings(loaded, crowded, MarkOf(object), findings);
  findings.Append(std::move(found));
  return as_meant && !warned;
}

std::optional<Sweep> Loader::SweepJoints(const mjcf::MjcfDocument& document,
                                         const model::Object& object, diag::Findings& findings) {
  const Loaded loaded = LoadDocument(impl_->engine, document, {}, object, findings);
  if (!loaded.model) return std::nullopt;
  constexpr int kRoot = 1;
  return TrySweep(*loaded.model, kRoot, MarkOf(object), findings);
}

std::optional<CompiledModel> Loader::Load(const std::filesystem::path& file, diag::Sources& sources,
                                          diag::Findings& findings) {
  diag::SourceMark start;
  const engine::Model model = LoadFile(impl_->engine, file, sources, start, findings);
  if (!model) return std::nullopt;
  return Describe(*model);
}

std::optional<std::string> Loader::AdaptedText(const std::filesystem::path& file) {
  return backport::BackportedText(file);
}

std::optional<Sweep> Loader::SweepJoints(const std::filesystem::path& file, diag::Sources& sources,
                                         diag::Findings& findings) {
  diag::SourceMark start;
  diag::Findings of_loading;
  const engine::Model model = LoadFile(impl_->engine, file, sources, start, of_loading);
  diag::Findings found;  // only errors, because Load() reports warnings
  for (const diag::Finding& finding : of_loading) {
    if (finding.severity == diag::Severity::kError) found.Add(finding);
  }
  // Stops after an error, because some numbers of the model may not be finite.
  const bool clean = found.empty();
  findings.Append(std::move(found));
  if (!model || !clean) return std::nullopt;
  constexpr int kWorld = 0;
  return TrySweep(*model, kWorld, start, findings);
}

}  // namespace mjforge::validate
