// Reads MJCF files, and makes attachments of their bodies, for use in specs.
#include "mjforge/attach/attach.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/attach/body_reader.h"
#include "mjforge/attach/finite_check.h"
#include "mjforge/attach/section_reader.h"

namespace mjforge::attach {
namespace {

namespace fs = std::filesystem;
using diag::Code;

/// An MJCF file and the findings about the file. The pointers are null after an error.
struct File {
  std::unique_ptr<CompiledFile> compiled;
  std::unique_ptr<MeshReader> meshes;
  diag::Findings findings;
};

struct Result {
  std::unique_ptr<model::Attachment> attachment;
  diag::Findings findings;  // about the body, not about the whole file
};

/// Adds copies of findings about a file at `mark`, the place in the spec that attaches the file.
void AddAt(const diag::Findings& stored, diag::SourceMark mark, diag::Findings& findings) {
  for (const diag::Finding& finding : stored) {
    diag::Finding& shown = findings.Add(finding.code, mark, finding.message, finding.hint);
    shown.severity = finding.severity;
    shown.notes = finding.notes;
  }
}

/// Returns true if the XML contains a body of this name. If the compiled model lacks a body of the
/// XML, MuJoCo fused the body with its parent.
bool IsFused(const XmlElement& element, const std::string& body) {
  if (element.tag == "body" && element.Name() == body) return true;
  return std::ranges::any_of(element.children,
                             [&](const XmlElement& child) { return IsFused(child, body); });
}

/// Returns MuJoCo's id of the body with this name. If there is none, adds a finding and returns
/// nullopt.
std::optional<int> FindBody(const CompiledFile& file, const std::string& body,
                            diag::Findings& findings) {
  const mjModel& m = file.model();
  if (m.nbody < 2) {
    AddError(findings, Code::kAttachNoBody, file.root().mark,
             fmt::format("'{}' has no body", file.file().string()),
             "elements directly in its worldbody cannot be attached; put them into a body");
    return std::nullopt;
  }
  if (body.empty()) return 1;
  std::vector<std::string> names;
  for (int id = 1; id < m.nbody; ++id) {
    names.push_back(file.NameOf(mjOBJ_BODY, id));
    if (names.back() == body) return id;
  }
  std::vector<std::string_view> views(names.begin(), names.end());
  std::erase(views, "");
  std::string hint = diag::DidYouMean(body, views);
  if (IsFused(file.root(), body)) {
    hint = "the file's compiler setting fusestatic merges it with its parent";
  }
  if (hint.empty() && views.empty())
    hint = "its bodies have no names; without `body:` the first is used";
  AddError(findings, Code::kAttachNoBody, {},
           fmt::format("'{}' has no body '{}'", file.file().string(), body), std::move(hint));
  return std::nullopt;
}

void WarnOfModelSettings(const CompiledFile& file, diag::Findings& findings) {
  const auto warn = [&](const XmlElement& element, std::string_view what) {
    AddWarning(
        findings, Code::kAttachNotCarried, element.mark,
        fmt::format("the {} of '{}' is not carried over", what, file.file().string()),
        "it would apply to the whole model; if you want that, write it under `mjcf:` in the spec");
  };
  std::set<std::string> seen;
  for (const XmlElement& section : file.root().children) {
    const bool empty = section.children.empty() && section.attributes.empty();
    if (empty || !seen.insert(section.tag).second) continue;
    if (section.tag == "option") warn(section, "option");
    if (section.tag == "custom") warn(section, "custom data");
    if (section.tag == "keyframe") {
      AddWarning(findings, Code::kAttachNotCarried, section.mark,
                 fmt::format("the keyframes of '{}' are not carried over", file.file().string()),
                 "a keyframe is a state of the whole model");
    }
  }
}

void WarnOfSkins(const CompiledFile& file, const NameScope& scope, diag::Findings& findings) {
  const mjModel& m = file.model();
  for (int i = 0; i < m.nskin; ++i) {
    bool inside = false;
    for (int bone = 0; bone < m.skin_bonenum[i]; ++bone) {
      inside |= scope.Contains(mjOBJ_BODY, m.skin_bonebodyid[m.skin_boneadr[i] + bone]);
    }
    if (!inside) continue;
    AddWarning(findings, Code::kAttachNotCarried, file.MarkOf(mjOBJ_SKIN, i),
               fmt::format("{} of '{}' is not carried over", file.Description(mjOBJ_SKIN, i),
                           file.file().string()),
               "a skin has no effect on motion; the bodies are shown without it");
  }
}

std::unique_ptr<model::Attachment> ReadBody(const File& file, const std::string& body,
                                            diag::Findings& findings) {
  const CompiledFile& compiled = *file.compiled;
  const std::optional<int> root = FindBody(compiled, body, findings);
  if (!root) return nullptr;
  NameScope scope(compiled, *root, findings);
  auto attachment = std::make_unique<model::Attachment>();
  AssetReader assets(compiled, *file.meshes, scope, *attachment);
  ReadBodies(compiled, scope, assets, *attachment, findings);
  SectionReader sections(compiled, scope, *attachment, findings);
  ReadTendons(sections, assets);
  ReadContacts(sections);
  ReadEqualities(sections);
  ReadActuators(sections);
  ReadSensors(sections);
  sections.Finish();
  WarnOfSkins(compiled, scope, findings);
  CheckFinite(*attachment, compiled.file(), findings);
  if (findings.HasErrors()) return nullptr;
  return attachment;
}

}  // namespace

struct MjcfReader::State {
  explicit State(diag::Sources& sources_of_run) : sources(sources_of_run) {}

  diag::Sources& sources;
  engine::Engine engine;
  std::map<std::string, File> files;  // by canonical path
  std::map<std::pair<std::string, std::string>, Result> results;

  File& Read(const std::string& key, const fs::path& file) {
    const auto [place, is_new] = files.try_emplace(key);
    File& read = place->second;
    if (!is_new) return read;
    read.compiled = CompiledFile::Read(file, engine, sources, read.findings);
    if (!read.compiled) return read;
    read.meshes = std::make_unique<MeshReader>(*read.compiled, read.findings);
    WarnOfModelSettings(*read.compiled, read.findings);
    return read;
  }
};

MjcfReader::MjcfReader(diag::Sources& sources) : state_(std::make_unique<State>(sources)) {}
MjcfReader::~MjcfReader() = default;

const model::Attachment* MjcfReader::Attach(const fs::path& file, const std::string& body,
                                            diag::SourceMark mark, diag::Findings& findings) {
  const std::string key = xml::CanonicalName(file);
  const File& read = state_->Read(key, file);
  AddAt(read.findings, mark, findings);
  if (read.findings.HasErrors()) return nullptr;
  const auto [place, is_new] = state_->results.try_emplace({key, body});
  Result& result = place->second;
  if (is_new) result.attachment = ReadBody(read, body, result.findings);
  AddAt(result.findings, mark, findings);
  return result.attachment.get();
}

}  // namespace mjforge::attach
