#include "mjforge/validate/validate.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/engine/engine.h"
#include "mjforge/validate/collisions.h"
#include "mjforge/validate/compare.h"
#include "mjforge/validate/describe.h"
#include "mjforge/validate/sweep.h"

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

/// Default-sized arenas take most of a load's time to clear. One body alone
/// makes no contacts, and MuJoCo's stack follows njmax. Of several bodies the
/// contacts are not known beforehand, nor are the rows of equalities and
/// tendons, so they get MuJoCo's own sizes. Without a line end, to keep the line
/// numbers.
std::string SizeHint(const model::Object& object) {
  if (object.bodies.size() != 1 || !object.sections.empty()) return {};
  return fmt::format("<size njmax=\"{}\" nconmax=\"0\"/>", CountConstraints(object.bodies.front()));
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
  } catch (const std::exception& error) {
    AddFailure(error, mark, findings);
    return std::nullopt;
  }
}

// What MuJoCo's words do not say.
std::string HintFor(std::string_view reason) {
  if (reason.find("XML_ELEMENT_DEPTH_EXCEEDED") == std::string_view::npos) return {};
  return "MuJoCo 2.2 reads bodies nested at most 95 deep: attach some of them to the root";
}

}  // namespace

std::string MujocoVersion() {
  const int version = mj_version();  // 222
  return fmt::format("{}.{}.{}", version / 100, version / 10 % 10, version % 10);
}

struct Loader::State {
  Engine engine;
  std::string text;  // the validated copy

  bool SetAssets(const mjcf::MjcfDocument& document, diag::Findings& findings);
  /// What MuJoCo says to `text`, which is the document's; a refusal is a finding.
  Loaded LoadDocument(const mjcf::MjcfDocument& document, const model::Object& object,
                      diag::Findings& findings);
  /// Without a model there is a finding. `start` is set once the file is read.
  engine::Model LoadFile(const std::filesystem::path& file, diag::Sources& sources,
                         diag::SourceMark& start, diag::Findings& findings);
};

Loader::Loader() : state_(std::make_unique<State>()) {}
Loader::~Loader() = default;

bool Loader::State::SetAssets(const mjcf::MjcfDocument& document, diag::Findings& findings) {
  const auto problem = engine.SetAssets(document.assets);
  if (!problem) return true;
  const std::string& name = document.assets[problem->asset].first;
  const diag::SourceMark mark = document.Origin(LineOf(document.text, '"' + name + '"'));
  findings.Add(problem->unreadable ? Code::kModelFileNotFound : Code::kMujocoError, mark,
               problem->message);
  return false;
}

Loaded Loader::State::LoadDocument(const mjcf::MjcfDocument& document, const model::Object& object,
                                   diag::Findings& findings) {
  if (!SetAssets(document, findings)) return {};
  Loaded loaded = engine.LoadText(text);
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
  state_->text = document.text;
  if (document.size_position != std::string::npos) {
    state_->text.insert(document.size_position, SizeHint(object));
  }
  const Loaded loaded = state_->LoadDocument(document, object, findings);
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
  state_->text = document.text;
  const Loaded loaded = state_->LoadDocument(document, object, findings);
  if (!loaded.model) return std::nullopt;
  constexpr int kRoot = 1;
  return TrySweep(*loaded.model, kRoot, MarkOf(object), findings);
}

engine::Model Loader::State::LoadFile(const std::filesystem::path& file, diag::Sources& sources,
                                      diag::SourceMark& start, diag::Findings& findings) {
  const std::optional<engine::XmlFile> xml = engine::ReadXmlFile(file, sources, findings);
  if (!xml) return nullptr;
  start = {xml->source, 1, 1};
  Loaded loaded = engine.LoadFile(file);
  AddWarnings(loaded.warnings, false, start, findings);
  if (loaded.model) {
    CheckFinite(*loaded.model, start, findings);
    return std::move(loaded.model);
  }
  const Refusal refusal = engine::ParseRefusal(loaded.error);
  const std::string element = xml->has_includes
                                  ? "the model"
                                  : engine::ElementOnLine(sources.Text(xml->source), refusal.line);
  diag::Finding& finding =
      findings.Add(Code::kMujocoError, engine::MarkOfLine(sources, xml->source, refusal.line),
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

std::optional<Sweep> Loader::SweepJoints(const std::filesystem::path& file, diag::Sources& sources,
                                         diag::Findings& findings) {
  diag::SourceMark start;
  diag::Findings found;
  const engine::Model model = state_->LoadFile(file, sources, start, found);
  // Numbers that are not finite would go round and round.
  const bool clean = found.empty();
  findings.Append(std::move(found));
  if (!model || !clean) return std::nullopt;
  constexpr int kWorld = 0;
  return TrySweep(*model, kWorld, start, findings);
}

}  // namespace mjforge::validate
