#include "mjforge/validate/validate.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/validate/compare.h"
#include "mjforge/validate/describe.h"
#include "mjforge/validate/engine.h"
#include "mjforge/validate/refusal.h"
#include "mjforge/validate/xml_file.h"

namespace mjforge::validate {
namespace {

using diag::Code;

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
/// contacts are not known beforehand, so they get MuJoCo's own sizes. Without a
/// line end, to keep the line numbers.
std::string SizeHint(const model::Object& object) {
  if (object.bodies.size() != 1) return {};
  return fmt::format("<size njmax=\"{}\" nconmax=\"0\"/>", CountConstraints(object.bodies.front()));
}

int LineOf(std::string_view text, std::string_view needle) {
  const std::size_t at = text.find(needle);
  if (at == std::string_view::npos) return 0;
  return 1 + static_cast<int>(std::ranges::count(text.substr(0, at), '\n'));
}

void AddWarnings(const std::vector<std::string>& warnings, diag::SourceMark mark,
                 diag::Findings& findings) {
  for (const std::string& warning : warnings) {
    findings.Add(Code::kMujocoWarning, mark, fmt::format("MuJoCo warns: {}", OneLine(warning)));
  }
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
  void AddError(const std::string& error, const mjcf::MjcfDocument& document,
                const model::Object& object, diag::Findings& findings);
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

void Loader::State::AddError(const std::string& error, const mjcf::MjcfDocument& document,
                             const model::Object& object, diag::Findings& findings) {
  const Refusal refusal = ParseRefusal(error);
  diag::SourceMark mark = document.Origin(refusal.line);
  if (!mark) mark = MarkOf(object);
  diag::Finding& finding =
      findings.Add(Code::kMujocoError, mark,
                   fmt::format("MuJoCo refused {}: {}", ElementOnLine(document.text, refusal.line),
                               refusal.reason));
  finding.notes.push_back({{}, fmt::format("MuJoCo said: {}", OneLine(error))});
}

bool Loader::Validate(const mjcf::MjcfDocument& document, const model::Object& object,
                      diag::Findings& findings) {
  if (!state_->SetAssets(document, findings)) return false;
  state_->text = document.text;
  if (document.size_position != std::string::npos) {
    state_->text.insert(document.size_position, SizeHint(object));
  }
  const Loaded loaded = state_->engine.LoadText(state_->text);
  const std::size_t before = findings.size();
  AddWarnings(loaded.warnings, MarkOf(object), findings);
  if (!loaded.model) {
    state_->AddError(loaded.error, document, object, findings);
    return false;
  }
  Comparison(*loaded.model, object, findings).Run(document.lift);
  return findings.size() == before;
}

std::optional<CompiledModel> Loader::Load(const std::filesystem::path& file, diag::Sources& sources,
                                          diag::Findings& findings) {
  const std::optional<XmlFile> xml = ReadXmlFile(file, sources, findings);
  if (!xml) return std::nullopt;
  const diag::SourceMark start{xml->source, 1, 1};
  const Loaded loaded = state_->engine.LoadFile(file);
  AddWarnings(loaded.warnings, start, findings);
  if (!loaded.model) {
    const Refusal refusal = ParseRefusal(loaded.error);
    const std::string element =
        xml->has_includes ? "the model" : ElementOnLine(sources.Text(xml->source), refusal.line);
    diag::Finding& finding =
        findings.Add(Code::kMujocoError, MarkOfLine(sources, xml->source, refusal.line),
                     fmt::format("MuJoCo refused {}: {}", element, refusal.reason),
                     xml->has_includes ? "the line may be one of an included file" : "");
    finding.notes.push_back({{}, fmt::format("MuJoCo said: {}", OneLine(loaded.error))});
    return std::nullopt;
  }
  CheckFinite(*loaded.model, start, findings);
  return Describe(*loaded.model);
}

}  // namespace mjforge::validate
