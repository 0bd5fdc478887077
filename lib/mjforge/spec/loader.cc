// Files -> ObjectSpec: the spec itself, its imports, the specs it welds in, and
// the settings given from outside.

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/spec/locate.h"
#include "mjforge/spec/reading.h"

namespace mjforge::spec {
namespace {

namespace fs = std::filesystem;
using diag::Code;
using diag::SourceMark;

std::string Sha256OfAll(std::span<const std::uint32_t> files, const diag::Sources& sources) {
  bytes::Sha256 sha256;
  for (const std::uint32_t file : files) sha256.Add(sources.Text(file));
  return sha256.Take();
}

// What a load reads and must not read twice, shared with the specs welded in.
struct Shared {
  diag::Sources& sources;
  diag::Findings& findings;
  std::span<const fs::path> search_path;
  std::vector<fs::path> open;             // specs and imports being read, outermost first
  std::vector<fs::path> files;            // all read, in order
  std::vector<std::uint32_t> source_ids;  // of `files`
  std::map<fs::path, std::shared_ptr<const ObjectSpec>> nested;
};

class SpecLoader : public NestedLoader {
 public:
  explicit SpecLoader(Shared& shared) : shared_(shared) {}

  // Nothing if the file is no spec at all; with errors in it, something to be thrown away.
  std::unique_ptr<ObjectSpec> Load(std::uint32_t source, const fs::path& file,
                                   const fs::path& folder, std::span<const NamedNode> settings) {
    const auto root = ParseYaml(source, shared_.sources, shared_.findings);
    if (!root) return nullptr;
    if (root->kind != YamlNode::Kind::kMap) {
      shared_.findings.Add(Code::kSpecWrongType, root->mark,
                           fmt::format("a spec must be a mapping of keys, got {}", KindName(*root)),
                           "start with `mjforge: 1` and a `name:`");
      return nullptr;
    }
    auto spec = std::make_unique<ObjectSpec>();
    spec->file = shared_.sources.Name(source);
    spec->mark = root->mark;
    spec->folder = folder;
    spec->names.Declare("index", expr::Type::kNumber);
    shared_.open.push_back(file);
    ReadObject(*root, *spec, settings);
    shared_.open.pop_back();
    return spec;
  }

  std::shared_ptr<const ObjectSpec> LoadNested(const std::string& reference,
                                               SourceMark mark) override {
    const auto file = Find(reference, folder_, mark);
    if (!file || IsOpen(*file, mark)) return nullptr;
    if (const auto known = shared_.nested.find(*file); known != shared_.nested.end()) {
      return known->second;
    }
    const auto source = Open(*file, mark);
    std::shared_ptr<const ObjectSpec> spec;
    if (source) spec = SpecLoader(shared_).Load(*source, *file, file->parent_path(), {});
    shared_.nested.emplace(*file, spec);
    return spec;
  }

 private:
  void ReadObject(const YamlNode& root, ObjectSpec& spec, std::span<const NamedNode> settings) {
    folder_ = spec.folder;
    Reading reading{shared_.sources, shared_.findings, spec, *this,
                    ValueReader(spec.names, shared_.sources, shared_.findings)};
    CheckKeys(ObjectElement(), root, reading);
    ReadHead(root, reading);
    if (const YamlNode* functions = root.Find("functions")) ReadFunctions(*functions, reading);
    ReadParameters(root.Find("params"), root.Find("require"), settings, reading);
    CheckFunctions(reading);
    if (const YamlNode* materials = root.Find("materials")) {
      ReadMaterials(*materials, spec.folder, false, reading);
    }
    if (const YamlNode* defaults = root.Find("defaults")) ReadDefaults(*defaults, reading);
    if (const YamlNode* import = root.Find("import")) ReadImports(*import, reading);
    if (const YamlNode* parts = root.Find("parts")) ReadParts(*parts, spec.parts, reading);
    if (const YamlNode* sites = root.Find("sites")) ReadSites(*sites, reading);
    const YamlNode* joints = root.Find("joints");
    for (const NamedNode& setting : settings) {
      if (setting.name == kRootJoints) joints = &setting.value;
    }
    if (joints != nullptr) ReadJoints(*joints, reading);
    if (const YamlNode* bodies = root.Find("bodies")) ReadBodies(*bodies, reading);
    if (const YamlNode* contact = root.Find("contact")) ReadContact(*contact, reading);
    if (const YamlNode* mjcf = root.Find("mjcf")) ReadSections(*mjcf, reading);
    ReadChecks(root.Find("checks"), settings, reading);
    ReadWhole(root, reading);
    DropUnusedProperties(reading);
    // Who welds a spec in may well need less of it.
    if (shared_.open.size() == 1) ReportUnused(root.Find("materials"), reading);
    if (reading.values.has_exact_choice()) spec.has_exact_choice = true;
  }

  void ReadHead(const YamlNode& root, Reading& reading) {
    CheckVersion(root, reading);
    if (const YamlNode* name = root.Find("name")) {
      reading.spec.name = reading.values.ReadPlainText("name", *name);
      CheckName("object", reading.spec.name, name->mark, reading.findings);
    } else {
      reading.findings.Add(Code::kSpecMissingKey, root.mark, "spec without a 'name'");
    }
    if (const YamlNode* description = root.Find("description")) {
      reading.spec.description = reading.values.ReadPlainText("description", *description);
    }
    if (root.Find("parts") == nullptr && root.Find("bodies") == nullptr) {
      reading.findings.Add(Code::kSpecMissingKey, root.mark, "spec without 'parts' or 'bodies'");
    }
  }

  static void CheckVersion(const YamlNode& root, Reading& reading) {
    const YamlNode* format = root.Find("mjforge");
    if (format == nullptr) {
      reading.findings.Add(Code::kSpecMissingKey, root.mark, "no format version",
                           "begin the file with `mjforge: 1`");
    } else if (format->kind != YamlNode::Kind::kScalar || format->quoted || format->text != "1") {
      const bool is_scalar = format->kind == YamlNode::Kind::kScalar;
      reading.findings.Add(Code::kSpecVersion, format->mark,
                           fmt::format("format version '{}' is not known; this program reads 1",
                                       is_scalar ? format->text : FlowText(*format)),
                           format->quoted && format->text == "1" ? "drop the quotes" : "");
    }
  }

  // mass, placement, total_size.
  void ReadWhole(const YamlNode& root, Reading& reading) {
    ObjectSpec& spec = reading.spec;
    for (Field& field : ReadFields(ObjectElement(), root, reading)) {
      if (field.info->id == Key::kMass)
        spec.mass = std::move(field);
      else if (field.info->id == Key::kTotalSize)
        spec.total_size = std::move(field);
      else if (field.info->id == Key::kPlacement) {
        if (LiteralText(field.value) == "corner") spec.placement = Placement::kCorner;
      }
    }
    if (spec.placement == Placement::kCorner && !spec.total_size) {
      reading.findings.Add(Code::kSpecMissingKey, root.mark,
                           "'placement: corner' needs 'total_size'");
    }
  }

  void ReadImports(const YamlNode& import, Reading& reading) {
    if (import.kind == YamlNode::Kind::kScalar) {
      ReadImport(import, reading);
    } else if (IsList(import, "files", reading)) {
      for (const YamlNode& item : import.items) ReadImport(item, reading);
    }
  }

  void ReadImport(const YamlNode& node, Reading& reading) {
    const std::string reference = reading.values.ReadPlainText("import", node);
    const auto file = reference.empty() ? std::nullopt : Find(reference, folder_, node.mark);
    if (!file || IsOpen(*file, node.mark) || !imported_.insert(*file).second) return;
    const auto source = Open(*file, node.mark);
    const auto root = source ? ParseYaml(*source, shared_.sources, shared_.findings) : std::nullopt;
    if (!root || !IsMap(*root, "keys", reading)) return;
    CheckKeys(ObjectElement(), *root, reading);
    CheckVersion(*root, reading);
    // What is imported must stand alone: it sees no parameter of the importer.
    expr::Names names;
    names.Declare("index", expr::Type::kNumber);
    Reading inner{shared_.sources, shared_.findings, reading.spec, *this,
                  ValueReader(names, shared_.sources, shared_.findings)};
    shared_.open.push_back(*file);
    const fs::path folder = std::exchange(folder_, file->parent_path());
    if (const YamlNode* materials = root->Find("materials")) {
      ReadMaterials(*materials, folder_, true, inner);
    }
    if (const YamlNode* defaults = root->Find("defaults")) ReadDefaults(*defaults, inner);
    if (const YamlNode* import = root->Find("import")) ReadImports(*import, inner);
    folder_ = folder;
    shared_.open.pop_back();
    reading.values.AddUses(inner.values);
    if (inner.values.has_exact_choice()) reading.spec.has_exact_choice = true;
  }

  std::optional<fs::path> Find(const std::string& reference, const fs::path& folder,
                               SourceMark mark) {
    const auto found = Locate(reference, folder, shared_.search_path);
    if (!found) {
      shared_.findings.Add(Code::kSpecNotFound, mark, fmt::format("cannot find '{}'", reference),
                           NotFoundHint(reference, shared_.search_path));
      return std::nullopt;
    }
    std::error_code error;
    const fs::path canonical = fs::weakly_canonical(*found, error);
    return error ? *found : canonical;
  }

  bool IsOpen(const fs::path& file, SourceMark mark) {
    const auto first = std::ranges::find(shared_.open, file);
    if (first == shared_.open.end()) return false;
    std::string chain;
    for (auto it = first; it != shared_.open.end(); ++it) chain += it->filename().string() + " -> ";
    shared_.findings.Add(
        Code::kSpecImportCycle, mark,
        fmt::format("file refers to itself: {}{}", chain, file.filename().string()));
    return true;
  }

  std::optional<std::uint32_t> Open(const fs::path& file, SourceMark mark) {
    if (const auto known = std::ranges::find(shared_.files, file); known != shared_.files.end()) {
      return shared_.source_ids[static_cast<std::size_t>(known - shared_.files.begin())];
    }
    std::string why_not;
    auto text = bytes::ReadStart(file, kMaxYamlBytes + 1, why_not);
    if (!text) {
      shared_.findings.Add(Code::kYamlCannotRead, mark,
                           fmt::format("cannot read '{}': {}", DisplayName(file), why_not));
      return std::nullopt;
    }
    const std::uint32_t source = shared_.sources.Add(DisplayName(file), std::move(*text));
    shared_.files.push_back(file);
    shared_.source_ids.push_back(source);
    return source;
  }

  Shared& shared_;
  fs::path folder_;
  // What is imported twice says nothing new; where each file imports two others, all would be read
  // 2^n times.
  std::set<fs::path> imported_;
};

// A setting is read as the YAML line `name: text`, so that marks fit what is shown.
void ParseSetting(const Setting& setting, std::vector<NamedNode>& out, diag::Sources& sources,
                  diag::Findings& findings) {
  const std::uint32_t source = sources.Add(setting.origin, setting.name + ": " + setting.text);
  auto root = ParseYaml(source, sources, findings);
  if (!root) return;
  if (root->kind != YamlNode::Kind::kMap || root->pairs.size() != 1) {
    findings.Add(Code::kSpecWrongType, root->mark, "expected name=value");
    return;
  }
  auto& pair = root->pairs.front();
  out.push_back({std::move(pair.key), std::move(pair.value)});
}

void ParseParameterFile(const fs::path& file, std::vector<NamedNode>& out, diag::Sources& sources,
                        diag::Findings& findings) {
  std::string why_not;
  auto text = bytes::ReadStart(file, kMaxYamlBytes + 1, why_not);
  if (!text) {
    findings.Add(Code::kYamlCannotRead, {},
                 fmt::format("cannot read '{}': {}", file.string(), why_not));
    return;
  }
  auto root = ParseYaml(sources.Add(DisplayName(file), std::move(*text)), sources, findings);
  if (!root) return;
  if (root->kind != YamlNode::Kind::kMap) {
    findings.Add(Code::kSpecWrongType, root->mark,
                 fmt::format("expected a mapping with parameters, got {}", KindName(*root)));
    return;
  }
  for (auto& pair : root->pairs) out.push_back({std::move(pair.key), std::move(pair.value)});
}

std::vector<NamedNode> ParseSettings(const LoadOptions& options, diag::Sources& sources,
                                     diag::Findings& findings) {
  std::vector<NamedNode> settings;
  for (const fs::path& file : options.parameter_files) {
    ParseParameterFile(file, settings, sources, findings);
  }
  for (const Setting& setting : options.settings)
    ParseSetting(setting, settings, sources, findings);
  return settings;
}

std::unique_ptr<ObjectSpec> LoadFrom(std::uint32_t source, const fs::path& file,
                                     const fs::path& folder, const LoadOptions& options,
                                     diag::Sources& sources, diag::Findings& findings) {
  diag::Findings own;
  Shared shared{.sources = sources,
                .findings = own,
                .search_path = options.search_path,
                .open = {},
                .files = {file},
                .source_ids = {source},
                .nested = {}};
  const std::vector<NamedNode> settings = ParseSettings(options, sources, own);
  auto spec = SpecLoader(shared).Load(source, file, folder, settings);
  if (spec != nullptr) {
    spec->files = shared.files;
    spec->sha256 = Sha256OfAll(shared.source_ids, sources);
    for (const NamedNode& setting : settings) {
      spec->settings.emplace_back(setting.name, FlowText(setting.value));
    }
  }
  const bool failed = own.HasErrors();
  own.Sort();
  own.Unique();
  findings.Append(std::move(own));
  return failed ? nullptr : std::move(spec);
}

}  // namespace

std::unique_ptr<ObjectSpec> LoadSpecText(const std::string& name, std::string text,
                                         const fs::path& folder, const LoadOptions& options,
                                         diag::Sources& sources, diag::Findings& findings) {
  const std::uint32_t source = sources.Add(name, std::move(text));
  return LoadFrom(source, fs::path(name), folder, options, sources, findings);
}

std::unique_ptr<ObjectSpec> LoadSpec(const std::string& reference, const LoadOptions& options,
                                     diag::Sources& sources, diag::Findings& findings) {
  fs::path file = reference;
  if (reference != "-") {
    const auto found = Locate(reference, {}, options.search_path);
    std::error_code error;
    if (found) {
      file = *found;
    } else if (!fs::is_directory(file, error)) {
      findings.Add(Code::kYamlCannotRead, {}, fmt::format("cannot find the spec '{}'", reference),
                   NotFoundHint(reference, options.search_path));
      return nullptr;
    }
  }
  std::string why_not;
  auto text = bytes::ReadStart(file, kMaxYamlBytes + 1, why_not);
  if (!text) {
    findings.Add(Code::kYamlCannotRead, {},
                 fmt::format("cannot read '{}': {}", reference, why_not));
    return nullptr;
  }
  std::error_code error;
  const fs::path canonical = reference == "-" ? file : fs::weakly_canonical(file, error);
  const fs::path folder = reference == "-" ? fs::path(".") : file.parent_path();
  const std::uint32_t source = sources.Add(DisplayName(file), std::move(*text));
  return LoadFrom(source, error ? file : canonical, folder, options, sources, findings);
}

}  // namespace mjforge::spec
