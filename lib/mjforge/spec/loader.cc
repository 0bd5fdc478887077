// Loading of an ObjectSpec: the spec itself, its imports, nested specs, and settings.

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/spec/context.h"
#include "mjforge/spec/locate.h"
#include "mjforge/spec/spec_files.h"

namespace mjforge::spec {
namespace {

namespace fs = std::filesystem;
using diag::Code;
using diag::SourceMark;

// State that a spec and its nested specs share while they are loaded.
struct LoadState {
  diag::Sources& sources;
  diag::Findings& findings;
  SpecFiles files;
  std::span<const SettingNode> settings;
  std::map<fs::path, std::shared_ptr<const ObjectSpec>> nested = {};
  std::map<fs::path, std::shared_ptr<const ObjectSpec>> imported = {};  // files with `params:`
};

class SpecLoader : public NestedLoader {
 public:
  explicit SpecLoader(LoadState& state) : state_(state) {}

  // Loads a spec. Returns null if the text is not a YAML mapping. After any other error, the result
  // must not be used.
  std::unique_ptr<ObjectSpec> Load(std::uint32_t source, const fs::path& file,
                                   const fs::path& folder, std::span<const SettingNode> settings) {
    const auto root = state_.files.Parse(file, source);
    if (!root) return nullptr;
    if (root->kind != YamlNode::Kind::kMap) {
      state_.findings.Add(Code::kSpecWrongType, root->mark,
                          fmt::format("a spec must be a mapping of keys, got {}", KindName(*root)),
                          "start with `mjforge: 1` and a `name:`");
      return nullptr;
    }
    auto spec = std::make_unique<ObjectSpec>();
    spec->file = state_.sources.Name(source);
    spec->mark = root->mark;
    spec->folder = folder;
    DeclareIndex(spec->names);
    const SpecFiles::OpenScope opened(state_.files, file);
    ReadObject(*root, *spec, settings);
    return spec;
  }

  std::shared_ptr<const ObjectSpec> LoadNested(const std::string& reference,
                                               SourceMark mark) override {
    const auto file = state_.files.Find(reference, folder_, mark);
    if (!file || state_.files.IsOpen(*file, mark)) return nullptr;
    if (const auto known = state_.nested.find(*file); known != state_.nested.end()) {
      return known->second;
    }
    const auto source = state_.files.Open(*file, mark);
    std::shared_ptr<const ObjectSpec> spec;
    if (source) spec = SpecLoader(state_).Load(*source, *file, file->parent_path(), {});
    state_.nested.emplace(*file, spec);
    return spec;
  }

  std::optional<std::uint32_t> OpenFile(const std::string& name, SourceMark mark) override {
    return state_.files.Open(Canonical(folder_ / name), mark);
  }

 private:
  void ReadObject(const YamlNode& text, ObjectSpec& spec, std::span<const SettingNode> settings) {
    folder_ = spec.folder;
    Context context{state_.sources, state_.findings, spec, *this,
                    ValueReader(spec.names, state_.sources, state_.findings)};
    const std::optional<YamlNode> meant = CheckKeys(kObjectElement, text, context);
    const YamlNode& root = meant ? *meant : text;
    ReadHead(root, context);
    if (const YamlNode* functions = root.Find("functions")) ReadFunctions(*functions, context);
    std::vector<ImportedFile> imports;
    if (const YamlNode* import = root.Find("import"))
      CollectImports(*import, folder_, imports, context);
    for (const ImportedFile& from : imports) {
      if (from.root.Find("params") != nullptr) spec.shared.push_back(Imported(from));
    }
    ReadParameters(root.Find("params"), root.Find("require"), settings, context);
    CheckFunctions(context);
    if (const YamlNode* materials = root.Find("materials")) {
      ReadMaterials(*materials, spec.folder, false, context);
    }
    if (const YamlNode* defaults = root.Find("defaults")) ReadDefaults(*defaults, context);
    for (const ImportedFile& from : imports) ReadImported(from, context);
    spec.parts = ReadEntries(kPartElement, root.Find("parts"), context);
    spec.sites = ReadEntries(kSiteElement, root.Find("sites"), context);
    spec.regions = ReadRegions(root.Find("regions"), context);
    spec.views = ReadViews(root, context);
    ReadMotion(root, settings, context);
    if (const YamlNode* contact = root.Find("contact")) ReadContact(*contact, context);
    if (const YamlNode* mjcf = root.Find("mjcf")) ReadSections(*mjcf, context);
    ReadChecks(root.Find("checks"), settings, context);
    if (const YamlNode* view = root.Find("view")) ReadView(*view, context);
    ReadWhole(root, settings, context);
    DropUnusedProperties(context);
    // Skips nested specs, because another spec may use only some of their materials.
    if (state_.files.depth() == 1) ReportUnused(root.Find("materials"), context);
    spec.draws |= context.values.draws();
  }

  // Reads joints, bodies, the start pose and expectations.
  static void ReadMotion(const YamlNode& root, std::span<const SettingNode> settings,
                         Context& context) {
    ObjectSpec& spec = context.spec;
    const YamlNode* joints = root.Find("joints");
    for (const SettingNode& setting : settings) {
      if (setting.name == kRootJoints) joints = &setting.value;
    }
    ReadBodiesAndJoints(root.Find("bodies"), joints, context);
    if (const YamlNode* pose = root.Find("pose")) spec.pose = ReadStarts(*pose, context);
    if (const YamlNode* expect = root.Find("expect")) ReadExpectations(*expect, context);
    if (joints != root.Find("joints")) RemoveJointPositions(root.Find("joints"), spec);
  }

  // Removes the positions of the root's own joints from the start state (`pose:`) and from
  // expectations (`at:`). Called if a setting replaces these joints by others.
  static void RemoveJointPositions(const YamlNode* joints, ObjectSpec& spec) {
    if (joints == nullptr) return;
    for (const YamlNode& joint : joints->items) {
      const YamlNode* name = joint.Find("name");
      if (name == nullptr) continue;
      const auto is_it = [&](const Value& joint) { return LiteralText(joint) == name->text; };
      std::erase_if(spec.pose, [&](const Entry& start) { return is_it(start.name); });
      for (Expectation& expectation : spec.expectations) {
        std::erase_if(expectation.at,
                      [&](const JointPosition& position) { return is_it(position.joint); });
      }
    }
  }

  void ReadHead(const YamlNode& root, Context& context) {
    CheckVersion(root, context);
    if (const YamlNode* name = root.Find("name")) {
      context.spec.name = context.values.ReadPlainText("name", *name);
      CheckName("object", context.spec.name, name->mark, context.findings);
    } else {
      context.findings.Add(Code::kSpecMissingKey, root.mark, "spec without a 'name'");
    }
    if (const YamlNode* description = root.Find("description")) {
      context.spec.description = context.values.ReadPlainText("description", *description);
    }
    if (root.Find("parts") == nullptr && root.Find("bodies") == nullptr) {
      context.findings.Add(Code::kSpecMissingKey, root.mark, "spec without 'parts' or 'bodies'");
    }
  }

  static void CheckVersion(const YamlNode& root, Context& context) {
    const YamlNode* format = root.Find("mjforge");
    if (format == nullptr) {
      context.findings.Add(Code::kSpecMissingKey, root.mark, "no format version",
                           "begin the file with `mjforge: 1`");
    } else if (format->kind != YamlNode::Kind::kScalar || format->quoted || format->text != "1") {
      const bool is_scalar = format->kind == YamlNode::Kind::kScalar;
      context.findings.Add(Code::kSpecVersion, format->mark,
                           fmt::format("format version '{}' is not known; this program reads 1",
                                       is_scalar ? format->text : FlowText(*format)),
                           format->quoted && format->text == "1" ? "drop the quotes" : "");
    }
  }

  // Reads the fields of the whole object: `mass`, `placement`, `total_size`, `start` and `front`.
  void ReadWhole(const YamlNode& root, std::span<const SettingNode> settings, Context& context) {
    ObjectSpec& spec = context.spec;
    for (Field& field : ReadFields(kObjectElement, root, context)) {
      if (field.info->id == Key::kMass)
        spec.mass = std::move(field);
      else if (field.info->id == Key::kTotalSize)
        spec.total_size = std::move(field);
      else if (field.info->id == Key::kStart)
        spec.start = std::move(field);
      else if (field.info->id == Key::kFront)
        spec.front = std::move(field);
      else if (field.info->id == Key::kPlacement) {
        if (LiteralText(field.value) == "corner") spec.placement = Placement::kCorner;
      }
    }
    for (const SettingNode& setting : settings) {
      if (setting.name != kRootStart) continue;
      const FieldInfo& info = *kObjectElement.Find("start");
      spec.start = Field{&info, context.values.Read(info, setting.value), setting.value.mark};
    }
    if (spec.placement == Placement::kCorner && !spec.total_size) {
      context.findings.Add(Code::kSpecMissingKey, root.mark,
                           "'placement: corner' needs 'total_size'");
    }
  }

  // A parsed file that a spec imports.
  struct ImportedFile {
    fs::path file;
    YamlNode root;
  };

  // Appends the files that `import:` names, each followed by the files that it imports itself.
  // Skips files that were imported before, because n files that each import two others could
  // otherwise be read 2^n times.
  void CollectImports(const YamlNode& import, const fs::path& folder,
                      std::vector<ImportedFile>& files, Context& context) {
    for (const YamlNode& item : OneOrMore(import, "files", context))
      CollectImport(item, folder, files, context);
  }

  void CollectImport(const YamlNode& node, const fs::path& folder, std::vector<ImportedFile>& files,
                     Context& context) {
    const std::string reference = context.values.ReadPlainText("import", node);
    if (reference.empty()) {
      if (node.kind == YamlNode::Kind::kScalar)
        context.findings.Add(Code::kSpecNotFound, node.mark, "'' is no file to import");
      return;
    }
    const auto file = state_.files.Find(reference, folder, node.mark);
    if (!file || state_.files.IsOpen(*file, node.mark) || !imported_.insert(*file).second) return;
    const auto source = state_.files.Open(*file, node.mark);
    auto root = source ? state_.files.Parse(*file, *source) : std::nullopt;
    if (!root || !IsMap(*root, "keys", context)) return;
    if (auto meant = CheckKeys(kObjectElement, *root, context)) root = std::move(meant);
    CheckVersion(*root, context);
    const SpecFiles::OpenScope opened(state_.files, *file);
    const std::size_t at = files.size();
    files.push_back({*file, *std::move(root)});
    const YamlNode* import = files[at].root.Find("import");
    if (import == nullptr) return;
    const YamlNode others = *import;  // a copy, because appending to `files` moves the node
    CollectImports(others, file->parent_path(), files, context);
  }

  // Returns a spec with the parameters of an imported file, which all specs that import the file
  // share.
  std::shared_ptr<const ObjectSpec> Imported(const ImportedFile& from) {
    const auto& [file, root] = from;
    std::shared_ptr<const ObjectSpec>& known = state_.imported[file];
    if (known != nullptr) return known;
    // Paths of CSV tables in the imported file are relative to that file's folder.
    const fs::path folder = std::exchange(folder_, file.parent_path());
    auto spec = std::make_shared<ObjectSpec>();
    spec->name = file.stem().string();
    DeclareIndex(spec->names);
    Context context{state_.sources, state_.findings, *spec, *this,
                    ValueReader(spec->names, state_.sources, state_.findings)};
    if (const YamlNode* functions = root.Find("functions")) ReadFunctions(*functions, context);
    const YamlNode& params = *root.Find("params");
    std::vector<SettingNode> settings;
    for (const SettingNode& setting : state_.settings) {
      if (params.Find(setting.name.substr(0, setting.name.find('.'))) != nullptr)
        settings.push_back(setting);
    }
    ReadParameters(&params, root.Find("require"), settings, context);
    CheckFunctions(context);
    spec->draws = context.values.draws();
    folder_ = folder;
    return known = spec;
  }

  // Reads the materials and defaults of an imported file. Expressions in them cannot use parameters
  // of the importing file.
  void ReadImported(const ImportedFile& from, Context& context) {
    expr::SymbolTable names;
    DeclareIndex(names);
    Context inner{state_.sources, state_.findings, context.spec, *this,
                  ValueReader(names, state_.sources, state_.findings)};
    if (const YamlNode* materials = from.root.Find("materials"))
      ReadMaterials(*materials, from.file.parent_path(), true, inner);
    if (const YamlNode* defaults = from.root.Find("defaults")) ReadDefaults(*defaults, inner);
    context.values.AddUses(inner.values);
    context.spec.draws |= inner.values.draws();
  }

  LoadState& state_;
  fs::path folder_;
  std::set<fs::path> imported_;
};

// Parses a setting as the YAML line `name: text`, so that positions match the line shown in
// findings.
void ParseSetting(const Setting& setting, std::vector<SettingNode>& out, diag::Sources& sources,
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

void ParseParameterFile(const fs::path& file, Snapshot* snapshot, std::vector<SettingNode>& out,
                        diag::Sources& sources, diag::Findings& findings) {
  const auto source = ReadSource(snapshot == nullptr ? file : Canonical(file), file.string(), {},
                                 snapshot, sources, findings, &Snapshot::parameter_texts);
  diag::Findings found;
  auto root = source ? ParseYaml(*source, sources, found) : std::nullopt;
  for (diag::Finding& finding : found) {
    if (finding.code == Code::kYamlEmpty) finding.hint = "write parameters, as in `width: 30cm`";
  }
  findings.Append(std::move(found));
  if (!root) return;
  if (root->kind != YamlNode::Kind::kMap) {
    findings.Add(Code::kSpecWrongType, root->mark,
                 fmt::format("expected a mapping with parameters, got {}", KindName(*root)));
    return;
  }
  for (auto& pair : root->pairs) out.push_back({std::move(pair.key), std::move(pair.value)});
}

std::vector<SettingNode> ParseSettings(const LoadOptions& options, diag::Sources& sources,
                                       diag::Findings& findings) {
  std::vector<SettingNode> settings;
  for (const fs::path& file : options.parameter_files) {
    ParseParameterFile(file, options.snapshot, settings, sources, findings);
  }
  for (const Setting& setting : options.settings)
    ParseSetting(setting, settings, sources, findings);
  return settings;
}

std::unique_ptr<ObjectSpec> LoadFrom(std::uint32_t source, const fs::path& file,
                                     const fs::path& folder, const LoadOptions& options,
                                     diag::Sources& sources, diag::Findings& findings) {
  diag::Findings own;
  const std::vector<SettingNode> settings = ParseSettings(options, sources, own);
  LoadState state{.sources = sources,
                  .findings = own,
                  .files = SpecFiles(options, file, source, sources, own),
                  .settings = settings};
  auto spec = SpecLoader(state).Load(source, file, folder, settings);
  if (spec != nullptr) {
    spec->files = state.files.all();
    spec->sha256 = state.files.Sha256();
    for (const SettingNode& setting : settings) {
      spec->settings.emplace_back(setting.name, FlowText(setting.value));
    }
  }
  const bool failed = own.HasErrors();
  own.Sort();
  own.Unique();
  // A name that is unknown in many places has one cause: the place that should declare it.
  own.Fold(Code::kExprUnknownName, 3);
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
  Snapshot* const snapshot = options.snapshot;
  const fs::path base = snapshot == nullptr ? fs::path() : snapshot->folder;
  fs::path file = reference;
  if (reference != bytes::kStandardInput) {
    const auto found = FindFile(reference, base, options);
    std::error_code error;
    if (found) {
      file = *found;
    } else if (!fs::is_directory(file, error)) {
      findings
          .Add(Code::kYamlCannotRead, {}, fmt::format("cannot find the spec '{}'", reference),
               NotFoundHint(reference, options.search_path))
          .files = Candidates(reference, base, options.search_path);
      return nullptr;
    }
  }
  const bool is_text = reference == bytes::kStandardInput;
  const fs::path key = snapshot == nullptr || is_text ? file : Canonical(file);
  const auto source = ReadSource(key, reference, {}, snapshot, sources, findings);
  if (!source) return nullptr;
  if (is_text)
    return LoadFrom(*source, file, base.empty() ? "." : base, options, sources, findings);
  return LoadFrom(*source, Canonical(file), file.parent_path(), options, sources, findings);
}

}  // namespace mjforge::spec
