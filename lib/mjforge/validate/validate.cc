#include "mjforge/validate/validate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/backport/backport.h"
#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/validate/collisions.h"
#include "mjforge/validate/compare.h"
#include "mjforge/validate/sweep.h"
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

/// The most constraints that one step of the object alone can have.
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

/// Default-sized arenas take most of a load's time to clear, and MuJoCo's stack follows njmax. One
/// body alone makes no contacts. Several seldom make more than a few; if they do, MuJoCo warns.
/// Without a line end, to keep the line numbers; empty where the object says sizes of its own.
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

/// `crowded`: so many bodies touch that there may be no room for their contacts,
/// which needs no second finding. True if there was one to add.
bool AddWarnings(const std::vector<std::string>& warnings, bool crowded, diag::SourceMark mark,
                 diag::Findings& findings) {
  bool any = false;
  for (const std::string& warning : warnings) {
    if (crowded && warning.find("buffer is full") != std::string::npos) continue;
    findings.Add(Code::kMujocoWarning, mark, fmt::format("MuJoCo warns: {}", OneLine(warning)));
    any = true;
  }
  return any;
}

/// MuJoCo gave up where it is asked for poses and contacts.
void AddFailure(const std::exception& error, diag::SourceMark mark, diag::Findings& findings) {
  findings.Add(Code::kMujocoError, mark,
               fmt::format("MuJoCo cannot place the bodies: {}", OneLine(error.what())));
}

/// Adds what touches at the joints' zero; true if there is any.
bool FindTouching(mjModel& m, const model::Object& object, diag::Findings& findings) {
  if (object.bodies.size() < 2) return false;
  try {
    return CheckSelfCollision(m, object, findings);
  } catch (const std::bad_alloc&) {
    throw;  // not MuJoCo's fault
  } catch (const std::exception& error) {
    AddFailure(error, MarkOf(object), findings);
    return true;
  }
}

/// Nothing, and a finding, if MuJoCo gives up.
std::optional<Sweep> TrySweep(mjModel& m, int frame, diag::SourceMark mark,
                              diag::Findings& findings) {
  try {
    return SweepModel(m, frame);
  } catch (const std::bad_alloc&) {
    throw;  // not MuJoCo's fault
  } catch (const std::exception& error) {
    AddFailure(error, mark, findings);
    return std::nullopt;
  }
}

/// Adds a finding for each kind of number that is not finite: MuJoCo silently loads "nan".
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
  // The first is enough.
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

// What MuJoCo's words do not say.
std::string HintFor(std::string_view reason) {
  if (reason.find("XML_ELEMENT_DEPTH_EXCEEDED") == std::string_view::npos) return {};
  return "MuJoCo 2.2 reads bodies nested at most 95 deep: attach some of them to the root";
}

}  // namespace

std::string MujocoVersion() { return engine::Version(); }

struct Loader::State {
  Engine engine;

  /// What MuJoCo says to the document; a refusal is a finding. It is loaded with the sizes of
  /// `hint` if MuJoCo has nothing to say about that.
  Loaded LoadDocument(const mjcf::MjcfDocument& document, const std::string& hint,
                      const model::Object& object, diag::Findings& findings);
  /// Without a model there is a finding. `start` is set once the file is read.
  engine::Model LoadFile(const std::filesystem::path& file, diag::Sources& sources,
                         diag::SourceMark& start, diag::Findings& findings);
};

Loader::Loader() : state_(std::make_unique<State>()) {}
Loader::~Loader() = default;

Loaded Loader::State::LoadDocument(const mjcf::MjcfDocument& document, const std::string& hint,
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
    if (loaded.model && loaded.warnings.empty()) return loaded;
  }
  Loaded loaded = engine.LoadText(document.text);
  if (loaded.model) return loaded;
  AddWarnings(loaded.warnings, false, MarkOf(object), findings);
  const Refusal refusal = engine::ParseRefusal(loaded.error);
  diag::SourceMark mark = document.Origin(refusal.line);
  if (!mark) mark = MarkOf(object);
  diag::Finding& finding =
      findings.Add(Code::kMujocoError, mark,
                   fmt::format("MuJoCo refused {}: {}",
                               engine::ElementOnLine(document.text, refusal.line), refusal.reason),
                   HintFor(refusal.reason));
  finding.notes.push_back({{}, fmt::format("MuJoCo said: {}", OneLine(loaded.error))});
  return loaded;
}

bool Loader::Validate(const mjcf::MjcfDocument& document, const model::Object& object,
                      diag::Findings& findings) {
  const Loaded loaded = state_->LoadDocument(document, SizeHint(object), object, findings);
  if (!loaded.model) return false;
  diag::Findings found;
  Comparison(*loaded.model, object, found).Run(document.lift);
  const bool crowded = found.empty() && FindTouching(*loaded.model, object, found);
  const bool as_meant = !found.HasErrors();
  const bool warned = AddWarnings(loaded.warnings, crowded, MarkOf(object), findings);
  findings.Append(std::move(found));
  return as_meant && !warned;
}

std::optional<Sweep> Loader::SweepJoints(const mjcf::MjcfDocument& document,
                                         const model::Object& object, diag::Findings& findings) {
  const Loaded loaded = state_->LoadDocument(document, {}, object, findings);
  if (!loaded.model) return std::nullopt;
  constexpr int kRoot = 1;
  return TrySweep(*loaded.model, kRoot, MarkOf(object), findings);
}

engine::Model Loader::State::LoadFile(const std::filesystem::path& file, diag::Sources& sources,
                                      diag::SourceMark& start, diag::Findings& findings) {
  const std::optional<backport::ModelFile> xml = backport::ReadModelFile(file, sources, findings);
  if (!xml) return nullptr;
  start = {xml->source, 1, 1};
  Loaded loaded = backport::LoadFile(engine, file, *xml);
  AddWarnings(loaded.warnings, false, start, findings);
  if (loaded.model) {
    CheckFinite(*loaded.model, start, findings);
    return std::move(loaded.model);
  }
  if (loaded.too_large_line > 0) {
    findings.Add(Code::kModelBadTexture,
                 xml::MarkOfLine(sources, xml->source, loaded.too_large_line), loaded.error);
    return nullptr;
  }
  const Refusal refusal = engine::ParseRefusal(loaded.error);
  const std::string element = xml->has_includes
                                  ? "the model"
                                  : engine::ElementOnLine(sources.Text(xml->source), refusal.line);
  diag::Finding& finding =
      findings.Add(Code::kMujocoError, xml::MarkOfLine(sources, xml->source, refusal.line),
                   fmt::format("MuJoCo refused {}: {}", element, refusal.reason),
                   xml->has_includes ? "the line may be in an included file" : "");
  finding.notes.push_back({{}, fmt::format("MuJoCo said: {}", OneLine(loaded.error))});
  return nullptr;
}

std::optional<CompiledModel> Loader::Load(const std::filesystem::path& file, diag::Sources& sources,
                                          diag::Findings& findings) {
  diag::SourceMark start;
  const engine::Model model = state_->LoadFile(file, sources, start, findings);
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
  const engine::Model model = state_->LoadFile(file, sources, start, of_loading);
  diag::Findings found;  // without what is left out, which does not move
  for (const diag::Finding& finding : of_loading) {
    if (model == nullptr || finding.code != Code::kMujocoLater) found.Add(finding);
  }
  // Numbers that are not finite would go round and round.
  const bool clean = found.empty();
  findings.Append(std::move(found));
  if (!model || !clean) return std::nullopt;
  constexpr int kWorld = 0;
  return TrySweep(*model, kWorld, start, findings);
}

}  // namespace mjforge::validate
