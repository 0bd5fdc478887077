// C interface of the library that the Python package loads with ctypes.
#include "interface.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iterator>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/bytes/bytes.h"
#include "mjforge/expr/expr.h"
#include "mjforge/forge/forge.h"
#include "mjforge/output/output.h"
#include "mjforge/xml/xml.h"
#include "no_throw.h"
#include "parameters_json.h"
#include "snapshots.h"
#include "table.h"
#include "text_view.h"

using namespace mjforge;
using python::View;

struct MjforgeMaker {
  diag::Sources sources;
  diag::Findings findings;
  std::optional<forge::Recipe> recipe;
  std::unique_ptr<forge::Generator> generator;
  forge::Variant variant;
  // Texts returned by the last calls, which are valid until the next call.
  std::string record;
  std::string findings_json;
  std::string files_json;
  std::string contents;
  std::string description;
  std::string inputs_json;
  std::string failure;
  // Files that MjforgeVariant::inputs has already listed: number of sources, and paths of assets.
  std::uint32_t known_sources = 0;
  std::set<std::string> known_assets;
};

struct MjforgeLines {
  explicit MjforgeLines(const char* file) : reader(bytes::LineReader::Open(file, why_not)) {}

  std::string why_not;                      // the reason if opening or reading fails
  std::optional<bytes::LineReader> reader;  // nullopt if the file cannot be opened
  std::string line;
};

struct MjforgeArchive {
  explicit MjforgeArchive(const char* file) : reader(file) {}

  output::ArchiveReader reader;
  // Texts returned by the last call, which are valid until the next call.
  std::string name;
  std::string content;
};

namespace {

// Returns the value that `find` finds for `word`; throws an exception that lists the known words if
// `find` finds nothing.
template <typename Find, typename Words>
auto FindWord(std::string_view option, std::string_view word, const Find& find,
              const Words& words) {
  const auto found = find(word);
  if (found) return *found;
  throw std::invalid_argument(diag::WithSuggestion(
      fmt::format("{}='{}' is not one of {}", option, word, fmt::join(words, ", ")), word, words));
}

spec::LoadOptions LoadOptionsOf(const MjforgeRequest& request) {
  spec::LoadOptions options;
  for (std::size_t i = 0; i < request.setting_count; ++i) {
    options.settings.push_back(
        {request.settings[2 * i], request.settings[2 * i + 1], std::string("set")});
  }
  options.parameter_files.assign(request.parameter_files,
                                 request.parameter_files + request.parameter_file_count);
  options.snapshot = &request.snapshot->snapshot;
  options.search_path = options.snapshot->search_path;
  return options;
}

forge::Options OptionsOf(const MjforgeRequest& request) {
  forge::Options options;
  options.seed = request.seed;
  options.batch = request.batch;
  if (request.place_seed != nullptr) options.place_seed = *request.place_seed;
  options.name = request.name;
  options.target = FindWord("target", request.target, mjcf::FindTarget, mjcf::TargetNames());
  options.assets =
      FindWord("assets", request.assets, manifest::Find<mjcf::AssetForm>, mjcf::kAssetForms);
  options.sampler = FindWord("sampler", request.sampler, sample::FindMethod, sample::MethodNames());
  options.on_invalid = FindWord("on_invalid", request.on_invalid, manifest::Find<forge::OnInvalid>,
                                manifest::kOnInvalid);
  options.validation = FindWord("validate", request.validate, manifest::Find<forge::Validation>,
                                manifest::kValidations);
  return options;
}

// Throws an exception if the batch is too large, or if its size is needed for draws but unknown.
void RequireBatch(const spec::ObjectSpec& spec, const forge::Options& options) {
  if (options.batch > sample::kMaxBatch)
    throw std::invalid_argument(
        fmt::format("batch={} is more than {}", options.batch, sample::kMaxBatch));
  if (options.batch > 0 || !sample::Sampler::NeedsBatch(spec, options.sampler)) return;
  const std::string what = spec.draws.exact ? "choices with 'exact: true' are exact"
                                            : fmt::format("sampler='{}' spreads the draws evenly",
                                                          sample::MethodName(options.sampler));
  throw std::invalid_argument(
      fmt::format("batch is missing: {} over a batch of N variants; give batch=N", what));
}

void Load(const MjforgeRequest& request, MjforgeMaker& maker) {
  const forge::Options options = OptionsOf(request);
  const spec::LoadOptions load = LoadOptionsOf(request);
  {
    const std::scoped_lock lock(request.snapshot->mutex);
    maker.recipe = forge::LoadRecipe(load.snapshot->spec, load, maker.sources, maker.findings);
  }
  if (!options.name.empty()) forge::CheckName(options.name, maker.findings);
  if (!maker.recipe || maker.findings.HasErrors()) return;
  RequireBatch(*maker.recipe->spec, options);
  maker.known_sources = maker.sources.size();
  maker.generator = std::make_unique<forge::Generator>(*maker.recipe, maker.sources, options);
}

std::string FindingsJson(const diag::Findings& findings, const diag::Sources& sources) {
  diag::Json json(nullptr);
  json.List(findings, [&](const diag::Finding& finding) {
    json.StartArray();
    json.Raw(diag::RenderJson(finding, sources));
    json.Value(diag::RenderText(finding, sources, /*color=*/false));
    json.EndArray();
  });
  return json.Take();
}

void SetFiles(const mjcf::MjcfDocument& document, MjforgeMaker& maker) {
  maker.contents.clear();
  diag::Json json(nullptr);
  json.List(document.assets, [&](const bytes::Asset& asset) {
    json.StartArray();
    json.Value(asset.name);
    json.Value(asset.file.string());
    json.Value(asset.made ? asset.made->size() : 0);
    json.EndArray();
    if (asset.made) maker.contents += *asset.made;
  });
  maker.files_json = json.Take();
}

using Inputs = std::vector<std::vector<std::string>>;  // path and SHA-256 of each file

// Adds the files that the maker's current variant uses and that no earlier variant used.
void AddInputs(MjforgeMaker& maker, Inputs& inputs) {
  const forge::Variant& variant = maker.variant;
  while (maker.known_sources < maker.sources.size()) {
    const std::uint32_t source = ++maker.known_sources;
    inputs.push_back({std::filesystem::absolute(maker.sources.Name(source)).string(),
                      bytes::Sha256Of(maker.sources.Text(source))});
  }
  for (const bytes::Asset& asset : variant.document.assets) {
    if (asset.made || !maker.known_assets.insert(asset.file.string()).second) continue;
    const auto hash = std::ranges::find(variant.record.assets, asset.name,
                                        &std::pair<std::string, std::string>::first);
    if (hash != variant.record.assets.end()) inputs.push_back({asset.file.string(), hash->second});
  }
}

// Returns the JSON of MjforgeVariant::inputs.
MjforgeText InputsJson(const Inputs& inputs, MjforgeMaker& maker) {
  diag::Json json(nullptr);
  json.Value(inputs);
  maker.inputs_json = inputs.empty() ? "" : json.Take();
  return View(maker.inputs_json);
}

int Make(MjforgeMaker& maker, std::uint64_t index, MjforgeVariant& made) {
  forge::Variant& variant = maker.variant;
  maker.generator->Make(index, variant);
  maker.record.clear();
  manifest::AppendRecord(maker.record, variant.record);
  maker.record.pop_back();  // removes the line end
  made.record = View(maker.record);
  if (!variant.findings.empty()) {
    maker.findings_json = FindingsJson(variant.findings, maker.sources);
    made.findings = View(maker.findings_json);
  }
  if (!variant.ok()) return 1;
  Inputs inputs;
  AddInputs(maker, inputs);
  made.inputs = InputsJson(inputs, maker);
  made.xml = View(variant.document.text);
  const model::Box3& box = variant.record.bounds.aabb;
  std::ranges::copy(box.min, std::begin(made.box));
  std::ranges::copy(box.max, std::begin(made.box) + 3);
  if (!variant.document.assets.empty()) {
    SetFiles(variant.document, maker);
    made.files = View(maker.files_json);
    made.contents = View(maker.contents);
  }
  return 0;
}

int Next(MjforgeArchive& archive, MjforgeText& name, MjforgeText& content) {
  std::string why_not;
  std::optional<std::string> member = archive.reader.Next(why_not);
  std::optional<std::string> bytes;
  if (member) bytes = archive.reader.Content(why_not);
  if (!member && why_not.empty()) return 1;
  archive.name = std::move(member).value_or("");
  archive.content = std::move(bytes).value_or(why_not);
  name = View(archive.name);
  content = View(archive.content);
  return why_not.empty() ? 0 : 2;
}

}  // namespace

MjforgeMaker* MjforgeOpen(const MjforgeRequest* request) {
  std::unique_ptr<MjforgeMaker> maker(python::NewOrNull<MjforgeMaker>());
  if (!maker) return nullptr;
  try {
    Load(*request, *maker);
  } catch (const std::bad_alloc&) {
    return nullptr;
  } catch (const std::exception& error) {
    maker->failure = error.what();
  }
  return maker.release();
}

void MjforgeClose(MjforgeMaker* maker) { delete maker; }

MjforgeText MjforgeFindings(MjforgeMaker* maker) {
  maker->findings_json = FindingsJson(maker->findings, maker->sources);
  return View(maker->findings_json);
}

MjforgeText MjforgeDescription(MjforgeMaker* maker) {
  const spec::ObjectSpec& spec = *maker->recipe->spec;
  maker->description = diag::JsonObject(expr::AppendExactNumber, [&](diag::Json& json) {
    json.Member("name", spec.name);
    json.Member("description", spec.description);
    json.Member("sha256", spec.sha256);
    if (spec.files.front() == bytes::kStandardInput) {
      json.Member("path", nullptr);
    } else {
      json.Member("path", spec.files.front().string());
    }
    json.Key("view");
    json.Raw(spec::ViewJson(spec.view));
    json.Key("parameters");
    python::WriteParameters(json, spec);
  });
  return View(maker->description);
}

int MjforgeMake(MjforgeMaker* maker, std::uint64_t index, MjforgeVariant* variant) {
  *variant = {};
  try {
    return Make(*maker, index, *variant);
  } catch (const std::bad_alloc&) {
    maker->failure.assign("not enough memory");
  } catch (const std::exception& error) {
    maker->failure = error.what();
  }
  return 2;
}

std::size_t MjforgeMakeRows(MjforgeMaker* maker, std::uint64_t index, std::uint64_t step,
                            std::size_t count, MjforgeTable* table, MjforgeText* inputs) {
  std::size_t made = 0;
  Inputs used;
  try {
    for (; made < count; ++made, index += step) {
      maker->generator->Make(index, maker->variant);
      if (!maker->variant.ok()) break;
      AddInputs(*maker, used);
      std::string record;
      manifest::AppendRecord(record, maker->variant.record);
      if (!table->columns.Add(std::move(record))) break;
    }
  } catch (const std::exception&) {
    // Ignores the error: the caller calls MjforgeMake for this variant to get the reason.
  }
  *inputs = InputsJson(used, *maker);
  return made;
}

MjforgeText MjforgeFailure(MjforgeMaker* maker) { return View(maker->failure); }

MjforgeArchive* MjforgeOpenArchive(const char* file) {
  return python::NewOrNull<MjforgeArchive>(file);
}

void MjforgeCloseArchive(MjforgeArchive* archive) { delete archive; }

int MjforgeNextMember(MjforgeArchive* archive, MjforgeText* name, MjforgeText* content) {
  try {
    return Next(*archive, *name, *content);
  } catch (const std::exception&) {
    *content = View("not enough memory");
    return 2;
  }
}

MjforgeLines* MjforgeOpenLines(const char* file) { return python::NewOrNull<MjforgeLines>(file); }

void MjforgeCloseLines(MjforgeLines* lines) { delete lines; }

int MjforgeNextLine(MjforgeLines* lines, MjforgeText* line) {
  try {
    if (lines->reader && lines->reader->Next(lines->line, lines->why_not)) {
      *line = View(lines->line);
      return 0;
    }
    *line = View(lines->why_not);
    if (lines->reader && lines->reader->is_truncated()) return 3;
    return lines->why_not.empty() ? 1 : 2;
  } catch (const std::exception&) {
    *line = View("not enough memory");
    return 2;
  }
}

MjforgeText MjforgeElements(const char* mjcf, std::size_t size) {
  thread_local std::string elements;
  elements = python::NoThrow(std::string(), [&] {
    return xml::ElementsJson({mjcf, size}).value_or("");
  });
  return View(elements);
}

const char* MjforgeVersion() { return forge::Version().data(); }
