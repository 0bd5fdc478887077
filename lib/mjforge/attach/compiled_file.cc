#include "mjforge/attach/compiled_file.h"

#include <algorithm>
#include <span>
#include <string_view>

#include <fmt/format.h>

namespace mjforge::attach {
namespace {

using diag::Code;

struct TagKind {
  std::string_view tag;
  mjtObj kind;
};
constexpr TagKind kInBodies[] = {{"body", mjOBJ_BODY},       {"joint", mjOBJ_JOINT},
                                 {"freejoint", mjOBJ_JOINT}, {"geom", mjOBJ_GEOM},
                                 {"site", mjOBJ_SITE},       {"camera", mjOBJ_CAMERA},
                                 {"light", mjOBJ_LIGHT}};
constexpr TagKind kAssets[] = {{"mesh", mjOBJ_MESH},
                               {"skin", mjOBJ_SKIN},
                               {"hfield", mjOBJ_HFIELD},
                               {"texture", mjOBJ_TEXTURE},
                               {"material", mjOBJ_MATERIAL}};
constexpr TagKind kContacts[] = {{"pair", mjOBJ_PAIR}, {"exclude", mjOBJ_EXCLUDE}};
// Their elements are of one kind, whatever the tag.
constexpr TagKind kSections[] = {{"equality", mjOBJ_EQUALITY},
                                 {"tendon", mjOBJ_TENDON},
                                 {"actuator", mjOBJ_ACTUATOR},
                                 {"sensor", mjOBJ_SENSOR}};

const TagKind* Find(std::span<const TagKind> kinds, std::string_view tag) {
  const auto found = std::ranges::find(kinds, tag, &TagKind::tag);
  return found == kinds.end() ? nullptr : &*found;
}

void Replace(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

}  // namespace

std::string KindName(mjtObj kind) {
  const char* name = mju_type2Str(kind);
  return name == nullptr ? "element" : name;
}

std::unique_ptr<CompiledFile> CompiledFile::Read(const std::filesystem::path& file,
                                                 engine::Engine& engine, diag::Sources& sources,
                                                 diag::Findings& findings) {
  std::optional<XmlElement> root = ReadXml(file, sources, findings);
  if (!root) return nullptr;
  std::unique_ptr<CompiledFile> compiled(new CompiledFile);
  compiled->file_ = file;
  compiled->root_ = *std::move(root);
  compiled->engine_ = &engine;
  compiled->file_names_ = ResolveFiles(compiled->root_, file.parent_path(), findings);
  if (findings.HasErrors()) return nullptr;
  NameElements(compiled->root_);
  compiled->flat_ = Flatten(compiled->root_);
  if (!compiled->Load(findings)) return nullptr;
  compiled->MapElements();
  return compiled;
}

bool CompiledFile::Load(diag::Findings& findings) {
  engine::Loaded loaded = engine_->LoadText(flat_.text);
  for (const std::string& warning : loaded.warnings) {
    AddWarning(findings, Code::kMujocoWarning, {},
               fmt::format("MuJoCo warns about '{}': {}", file_.string(),
                           engine::OneLine(InWordsOfFile(warning))));
  }
  if (!loaded.model) {
    AddRefusal(loaded.error, findings);
    return false;
  }
  model_ = std::move(loaded.model);
  return true;
}

void CompiledFile::AddRefusal(const std::string& error, diag::Findings& findings) const {
  const engine::Refusal refusal = engine::ParseRefusal(InWordsOfFile(error));
  const XmlElement* element = flat_.OnLine(refusal.line);
  AddError(findings, Code::kMujocoError, element == nullptr ? diag::SourceMark{} : element->mark,
           fmt::format("MuJoCo refused {} of '{}': {}",
                       element == nullptr ? "the model" : element->Description(), file_.string(),
                       refusal.reason));
}

std::string CompiledFile::InWordsOfFile(std::string text) const {
  for (const auto& [absolute, shown] : file_names_) Replace(text, absolute, shown);
  for (const XmlElement* element : flat_.lines) {
    if (element->made_name.empty()) continue;
    Replace(text, fmt::format("'{}'", element->made_name),
            fmt::format("'' (line {})", element->mark.line));
  }
  return text;
}

void CompiledFile::Map(mjtObj kind, const XmlElement& element) {
  std::string name = element.made_name.empty() ? element.Name() : element.made_name;
  if (name.empty()) {
    // So MuJoCo names assets.
    if (const std::string* file = element.Find("file")) name = FileStem(*file);
  }
  if (!name.empty()) elements_.emplace(std::pair(static_cast<int>(kind), name), &element);
}

void CompiledFile::MapBodies(const XmlElement& parent) {
  for (const XmlElement& child : parent.children) {
    if (child.tag == "composite") composites_.push_back(&child);
    const TagKind* kind = Find(kInBodies, child.tag);
    if (kind == nullptr) continue;
    Map(kind->kind, child);
    if (kind->kind == mjOBJ_BODY) MapBodies(child);
  }
}

void CompiledFile::MapElements() {
  for (const XmlElement& section : root_.children) {
    if (section.tag == "worldbody") MapBodies(section);
    const TagKind* same = Find(kSections, section.tag);
    for (const XmlElement& element : section.children) {
      const TagKind* kind = same;
      if (section.tag == "asset") kind = Find(kAssets, element.tag);
      if (section.tag == "contact") kind = Find(kContacts, element.tag);
      if (kind != nullptr) Map(kind->kind, element);
    }
  }
}

const XmlElement* CompiledFile::ElementOf(mjtObj kind, int id) const {
  const char* name = mj_id2name(model_.get(), kind, id);
  if (name == nullptr) return nullptr;
  const auto found = elements_.find(std::pair(static_cast<int>(kind), std::string(name)));
  return found == elements_.end() ? nullptr : found->second;
}

std::string CompiledFile::NameOf(mjtObj kind, int id) const {
  const XmlElement* element = ElementOf(kind, id);
  if (element != nullptr && !element->made_name.empty()) return {};
  const char* name = mj_id2name(model_.get(), kind, id);
  return name == nullptr ? "" : name;
}

diag::SourceMark CompiledFile::MarkOf(mjtObj kind, int id) const {
  if (const XmlElement* element = ElementOf(kind, id)) return element->mark;
  const std::string name = NameOf(kind, id);
  const XmlElement* maker = composites_.empty() ? &root_ : composites_.front();
  std::size_t longest = 0;
  for (const XmlElement* composite : composites_) {
    const std::string* prefix = composite->Find("prefix");
    if (prefix == nullptr || !name.starts_with(*prefix) || prefix->size() <= longest) continue;
    longest = prefix->size();
    maker = composite;
  }
  return maker->mark;
}

std::string CompiledFile::Description(mjtObj kind, int id) const {
  if (const XmlElement* element = ElementOf(kind, id)) return element->Description();
  return fmt::format("{} '{}'", KindName(kind), NameOf(kind, id));
}

}  // namespace mjforge::attach
