// Compiles an MJCF file, and maps its XML elements to the elements of the compiled model.
#include "mjforge/attach/compiled_file.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "mjforge/backport/backport.h"

namespace mjforge::attach {
namespace {

using diag::Code;

/// The kind of object (mjtObj) that MuJoCo compiles from an XML element.
struct CompiledKind {
  std::string_view section;
  std::string_view tag;  // empty if all elements of the section have this kind
  mjtObj kind;
};
constexpr CompiledKind kKinds[] = {
    {"worldbody", "body", mjOBJ_BODY},
    {"worldbody", "joint", mjOBJ_JOINT},
    {"worldbody", "freejoint", mjOBJ_JOINT},
    {"worldbody", "geom", mjOBJ_GEOM},
    {"worldbody", "site", mjOBJ_SITE},
    {"worldbody", "camera", mjOBJ_CAMERA},
    {"worldbody", "light", mjOBJ_LIGHT},
    {"worldbody", "composite", mjOBJ_UNKNOWN},  // compiled to objects of many kinds
    {"asset", "mesh", mjOBJ_MESH},
    {"asset", "skin", mjOBJ_SKIN},
    {"asset", "hfield", mjOBJ_HFIELD},
    {"asset", "texture", mjOBJ_TEXTURE},
    {"asset", "material", mjOBJ_MATERIAL},
    {"contact", "pair", mjOBJ_PAIR},
    {"contact", "exclude", mjOBJ_EXCLUDE},
    {"equality", "", mjOBJ_EQUALITY},
    {"tendon", "", mjOBJ_TENDON},
    {"actuator", "", mjOBJ_ACTUATOR},
    {"sensor", "", mjOBJ_SENSOR}};

/// Calls `use` with each element, and the element's kind (mjtObj), in a section and in its bodies,
/// frames and replicates.
template <typename Use>
void ForEachIn(XmlElement& parent, std::string_view section, const Use& use) {
  for (XmlElement& child : parent.children) {
    if (child.tag == "frame" || child.tag == "replicate") ForEachIn(child, section, use);
    const auto found = std::ranges::find_if(kKinds, [&](const CompiledKind& compiled) {
      return compiled.section == section && (compiled.tag.empty() || compiled.tag == child.tag);
    });
    if (found == std::end(kKinds)) continue;
    use(child, found->kind);
    if (found->kind == mjOBJ_BODY) ForEachIn(child, section, use);
  }
}

bool AnyNameBeginsWith(const std::string& prefix, const XmlElement& element) {
  return element.Name().starts_with(prefix) ||
         std::ranges::any_of(element.children,
                             [&](const auto& child) { return AnyNameBeginsWith(prefix, child); });
}

/// Generates a unique name for each element without a name, so that the element can be found in the
/// compiled model. Skips assets, which MuJoCo itself names.
void NameElements(XmlElement& root) {
  std::string prefix = "~";
  while (AnyNameBeginsWith(prefix, root)) prefix += '~';
  int count = 0;
  for (XmlElement& section : root.children) {
    if (section.tag == "asset") continue;
    ForEachIn(section, section.tag, [&](XmlElement& element, mjtObj kind) {
      if (kind == mjOBJ_UNKNOWN || !element.Name().empty()) return;
      element.generated_name = fmt::format("{}{}~", prefix, ++count);
    });
  }
}

void Replace(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

/// Rewrites the XML tree for MuJoCo 2.2, the release for which objects are written, even if this
/// build uses a later MuJoCo.
void Backport(XmlElement& root, const diag::Sources& sources, diag::Findings& findings) {
  diag::Findings found;
  backport::BackportMjcf(root, backport::kPortable, backport::Use::kBodies, sources, found);
  for (diag::Finding& finding : found) {
    finding.notes.push_back({std::exchange(finding.mark, {}), "here"});
  }
  findings.Append(std::move(found));
}

}  // namespace

std::string KindName(mjtObj kind) {
  const char* name = mju_type2Str(kind);
  return name == nullptr ? "element" : name;
}

std::unique_ptr<CompiledFile> CompiledFile::Read(const std::filesystem::path& file,
                                                 engine::Engine& engine, diag::Sources& sources,
                                                 diag::Findings& findings) {
  std::optional<XmlElement> root = xml::ReadXml(file, sources, findings);
  if (!root) return nullptr;
  Backport(*root, sources, findings);
  if (findings.HasErrors()) return nullptr;
  std::unique_ptr<CompiledFile> compiled(new CompiledFile);
  compiled->file_ = file;
  compiled->root_ = *std::move(root);
  compiled->engine_ = &engine;
  compiled->file_names_ = xml::ResolveFiles(compiled->root_, file.parent_path(), findings);
  if (findings.HasErrors() || !compiled->CheckFiles(findings)) return nullptr;
  backport::ApplyLaterRules(compiled->root_,
                            [&](const std::string& text) { return engine.LoadText(text); });
  NameElements(compiled->root_);
  compiled->flat_ = xml::Flatten(compiled->root_);
  compiled->Load(findings);
  if (!compiled->model_) return nullptr;
  compiled->MapElements();
  return compiled;
}

bool CompiledFile::CheckFiles(diag::Findings& findings) {
  flat_ = xml::Flatten(root_);
  const auto fault = engine::FindFileFault(flat_.text, {});
  if (!fault) return true;
  const XmlElement* element = flat_.lines[static_cast<std::size_t>(fault->line) - 1];
  AddError(findings, fault->code, element->mark,
           fmt::format("'{}' cannot be attached: {}", file_.string(),
                       WithOriginalNames(fault->message)));
  return false;
}

void CompiledFile::Load(diag::Findings& findings) {
  engine::Loaded loaded = engine_->LoadText(flat_.text);
  for (const std::string& warning : loaded.warnings) {
    AddWarning(findings, Code::kMujocoWarning, {},
               fmt::format("MuJoCo warns about '{}': {}", file_.string(),
                           engine::OneLine(WithOriginalNames(warning))));
  }
  model_ = std::move(loaded.model);
  if (model_) return;
  const engine::Refusal refusal = engine::ParseRefusal(WithOriginalNames(loaded.error));
  const auto line = static_cast<std::size_t>(engine::ParseRefusal(loaded.error, flat_.text).line);
  const XmlElement* element =
      line > 0 && line <= flat_.lines.size() ? flat_.lines[line - 1] : nullptr;
  AddError(findings, Code::kMujocoError, element == nullptr ? diag::SourceMark{} : element->mark,
           fmt::format("MuJoCo refused {} of '{}': {}",
                       element == nullptr ? "the model" : element->Description(), file_.string(),
                       refusal.reason));
}

std::string CompiledFile::WithOriginalNames(std::string text) const {
  for (const auto& [absolute, shown] : file_names_) Replace(text, absolute, shown);
  for (const XmlElement* element : flat_.lines) {
    if (element->generated_name.empty()) continue;
    Replace(text, fmt::format("'{}'", element->generated_name),
            fmt::format("'' (line {})", element->mark.line));
  }
  return text;
}

void CompiledFile::MapElements() {
  for (XmlElement& section : root_.children) {
    ForEachIn(section, section.tag, [this](const XmlElement& element, mjtObj kind) {
      if (kind == mjOBJ_UNKNOWN) {
        composites_.push_back(&element);
        return;
      }
      const std::string name =
          element.generated_name.empty() ? element.AssetName() : element.generated_name;
      if (!name.empty()) elements_.emplace(std::pair(static_cast<int>(kind), name), &element);
    });
  }
}

const XmlElement* CompiledFile::ElementOf(mjtObj kind, int id) const {
  const char* name = mj_id2name(model_.get(), kind, id);
  if (name == nullptr) return nullptr;
  const auto found = elements_.find(std::pair(static_cast<int>(kind), std::string(name)));
  return found == elements_.end() ? nullptr : found->second;
}

const XmlElement& CompiledFile::OriginOf(mjtObj kind, int id) const {
  if (const XmlElement* element = ElementOf(kind, id)) return *element;
  const char* name = mj_id2name(model_.get(), kind, id);
  const XmlElement* origin = composites_.empty() ? &root_ : composites_.front();
  std::size_t longest = 0;
  const auto compare = [&](const std::string& start, const XmlElement* element) {
    if (name == nullptr || start.size() <= longest || !std::string_view(name).starts_with(start))
      return;
    longest = start.size();
    origin = element;
  };
  for (const auto& [key, element] : elements_) {
    if (key.first == kind) compare(key.second, element);
  }
  for (const XmlElement* composite : composites_) {
    if (const std::string* prefix = composite->Find("prefix")) compare(*prefix, composite);
  }
  return *origin;
}

std::string CompiledFile::NameOf(mjtObj kind, int id) const {
  const char* name = mj_id2name(model_.get(), kind, id);
  return name == nullptr || !OriginOf(kind, id).generated_name.empty() ? "" : name;
}

std::string CompiledFile::Description(mjtObj kind, int id) const {
  if (const XmlElement* element = ElementOf(kind, id)) return element->Description();
  return fmt::format("{} '{}'", KindName(kind), NameOf(kind, id));
}

}  // namespace mjforge::attach
