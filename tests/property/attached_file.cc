#include "attached_file.h"

#include <utility>

#include "mjforge/assemble/assemble.h"
#include "mjforge/backport/backport.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/xml/xml.h"

namespace mjforge::attach {

namespace {

// Loads a file by the rules of MuJoCo 3 for masses and shapes of meshes.
engine::Loaded Load(engine::Engine& engine, const std::filesystem::path& file) {
  if (mjVERSION_HEADER >= 300) return backport::LoadFile(engine, file);
  diag::Sources sources;
  diag::Findings findings;
  std::optional<xml::XmlElement> root = xml::ReadXml(file, sources, findings);
  if (!root) return {};
  xml::ResolveFiles(*root, file.parent_path(), findings);
  backport::ApplyLaterRules(*root, [&](const std::string& text) { return engine.LoadText(text); });
  return engine.LoadText(xml::Flatten(*root).text);
}

}  // namespace

AttachedFile::AttachedFile(std::filesystem::path file)
    : file_(std::move(file)), own_(Load(engine_, file_)), reader_(sources_) {}

engine::Model AttachedFile::Attach(int body) {
  const std::string name = own().names + own().name_bodyadr[body];
  std::string yaml = "mjforge: 1\nname: zoo\njoints: none\nbodies:\n  - {name: it, mjcf: \"" +
                     file_.string() + "\"";
  if (!name.empty()) yaml += ", body: \"" + name + "\"";
  yaml += "}\n";
  diag::Sources sources;
  diag::Findings findings;
  std::optional<model::Object> object;
  const auto spec = spec::LoadSpecText("zoo.yaml", yaml, "/", {}, sources, findings);
  if (spec != nullptr) {
    auto values = sample::Sample(*spec, {.seed = 1, .index = 0}, sample::kRootStream, {}, findings);
    assemble::Assembler assembler(&reader_);
    if (values) object = assembler.Assemble(*values, {}, findings);
  }
  text_.clear();
  refused_ = false;
  for (const diag::Finding& finding : findings) {
    text_ += finding.message + "\n";
    refused_ |=
        finding.code == diag::Code::kAttachNotCarried && finding.severity == diag::Severity::kError;
  }
  if (!object) return nullptr;
  mjcf::MjcfDocument document;
  mjcf::WriteMjcf(*object, mjcf::Target::kMujoco, {}, document);
  engine::Engine engine;
  if (const auto problem = engine.SetAssets(document.assets)) {
    text_ += problem->message;
    return nullptr;
  }
  engine::Loaded loaded = engine.LoadText(document.text);
  text_ += loaded.error;
  if (!loaded.model) text_ += "\n" + document.text;
  return std::move(loaded.model);
}

}  // namespace mjforge::attach
