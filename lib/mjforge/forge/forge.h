#pragma once

// The rooms in order: spec -> values -> object -> MJCF -> MuJoCo -> files. The
// only header that most callers need:
//
//   diag::Sources sources;
//   diag::Findings findings;
//   auto recipe = forge::LoadRecipe("hammer", {.search_path = forge::SearchPath()}, sources,
//                                   findings);
//   forge::Generator generator(*recipe, sources, {.seed = 7});
//   forge::Variant variant;
//   generator.Make(41, variant);  // variant.document.text is the MJCF

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/attach/attach.h"
#include "mjforge/diag/diag.h"
#include "mjforge/files/files.h"
#include "mjforge/manifest/manifest.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/output/output.h"
#include "mjforge/physics/physics.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"
#include "mjforge/validate/validate.h"

namespace mjforge::forge {

/// "0.1.0".
std::string_view Version();

struct Library {
  std::string name;
  std::string version;
};
/// The libraries whose version may change an object or its verdict.
std::vector<Library> Libraries();

/// The folder with the bundled specs: share/mjforge/specs beside a folder that
/// holds the program.
std::optional<std::filesystem::path> CatalogueFolder();

/// Where specs are looked for by name: the folders of MJFORGE_PATH (separated
/// by colons), then `catalogue`: the bundled ones.
std::vector<std::filesystem::path> SearchPath(
    std::optional<std::filesystem::path> catalogue = CatalogueFolder());

/// A spec that is ready for making variants.
struct Recipe {
  std::unique_ptr<spec::ObjectSpec> spec;
  /// How records and comments name the spec: its name in the search path
  /// ("tools/hammer"), or its file's name. Says nothing about this machine, so
  /// that the same spec gives the same bytes in every folder.
  std::string reference;
  /// The spec's file where `reference` is only its name; empty: `reference` leads to it, or
  /// nothing does.
  std::filesystem::path file;
  /// Parameters set from outside, files first; each name once.
  std::vector<std::pair<std::string, std::string>> settings;
};

/// As spec::LoadSpec.
std::optional<Recipe> LoadRecipe(const std::string& reference, const spec::LoadOptions& options,
                                 diag::Sources& sources, diag::Findings& findings);
/// The same of a text, whose files are looked for here: as LoadRecipe("-") of a process that gets
/// the text on standard input. Findings call it `name`.
std::optional<Recipe> LoadRecipeText(const std::string& name, std::string text,
                                     const spec::LoadOptions& options, diag::Sources& sources,
                                     diag::Findings& findings);

/// Thresholds set from outside, for a file that has no spec: names are `checks.` and a key.
std::optional<model::Checks> LoadChecks(const std::vector<spec::Setting>& settings,
                                        diag::Sources& sources, diag::Findings& findings);

/// The object's name for a variant: `text` with every ${index} replaced.
std::string ExpandName(std::string_view text, std::uint64_t index);
/// Whether names made from `text` are valid: [A-Za-z][A-Za-z0-9_]*. Else a finding.
bool CheckName(std::string_view text, diag::Findings& findings);

/// One variant and all that is known of it.
struct Variant {
  manifest::Record record;
  /// Null if it could not be built.
  std::shared_ptr<const model::Object> object;
  mjcf::MjcfDocument document;  // means nothing without an object
  diag::Findings findings;

  bool ok() const { return record.status == manifest::Status::kOk; }
};

using manifest::OnInvalid;
using manifest::Validation;

struct Options {
  std::uint64_t seed = 0;
  mjcf::Target target = mjcf::Target::kMujoco;
  mjcf::AssetForm assets = mjcf::AssetForm::kInline;
  std::string name;           // checked by CheckName; empty: the spec's
  std::uint64_t attempt = 0;  // draws before this one are not tried
  OnInvalid on_invalid = OnInvalid::kFail;
  sample::Method sampler = sample::Method::kRandom;
  std::uint64_t batch = 0;  // items of the batch; 0: not known (sample::Sampler)
  Validation validation = Validation::kLoad;
  /// Of the manifest: records name the spec's file from here. Nothing: they do not.
  std::optional<std::filesystem::path> folder;
};
inline constexpr int kMaxResamples = 100;

/// What the records of all variants have in common; the rest is empty.
manifest::Record BatchRecord(const Recipe& recipe, const Options& options);

/// Makes the members of one family. Keeps what they share and the memory they need, which does not
/// grow with their number.
class Generator {
 public:
  /// The recipe and its sources must outlive the generator. Attached XML files
  /// are added to the sources.
  Generator(const Recipe& recipe, diag::Sources& sources, const Options& options);

  /// Replaces the content of `variant`, which is a pure function of the index.
  void Make(std::uint64_t index, Variant& variant);

  /// Instead of making it, describes a failed variant with this finding.
  void Fail(std::uint64_t index, diag::Finding finding, Variant& variant);

  const Recipe& recipe() const { return recipe_; }

 private:
  enum class Outcome { kMade, kFailed, kHopeless };
  void Begin(std::uint64_t index, std::uint64_t attempt, Variant& variant);
  Outcome Attempt(std::uint64_t index, std::uint64_t attempt, Variant& variant);
  /// Assembles and writes the object of these parameters; false after an error.
  bool Assemble(sample::Evaluator& values, Variant& variant);
  void Judge(Variant& variant);
  bool HashAssets(Variant& variant);
  void End(Outcome outcome, Variant& variant);
  void Describe(const model::Object& object, manifest::Record& record) const;

  const Recipe& recipe_;
  Options options_;
  std::unique_ptr<validate::Loader> loader_;         // null: MuJoCo does not load it
  std::unique_ptr<physics::Laboratory> laboratory_;  // null: nothing is simulated
  const diag::Sources& sources_;
  diag::Sources record_sources_;  // names as records show them
  manifest::Record common_;       // BatchRecord
  sample::Sampler sampler_;
  files::Maker files_;
  attach::MjcfReader attachments_;
  model::Assembler assembler_;
  std::map<std::string, std::string> hashes_;  // of assets, by file
};

/// The recipe of a record: `spec`, or, if that is empty, the spec that it names, which is
/// looked for where the record says, here, in `folder` (the manifest's) and one folder up.
/// Nothing, and findings, if it is gone or has changed since.
std::optional<Recipe> LoadRecordedRecipe(const manifest::Record& record, const std::string& spec,
                                         const std::filesystem::path& folder,
                                         diag::Sources& sources, diag::Findings& findings);
/// How to regenerate a record's variant; nothing, and a finding about `what`, if it was made for an
/// unknown target or with an unknown sampler.
std::optional<Options> RecordedOptions(const manifest::Record& record, std::string_view what,
                                       diag::Findings& findings);

/// What to regenerate and compare.
struct ReplayRequest {
  std::string what;  // "out/manifest.jsonl:42" or "out/hammer_000042.xml"
  std::string spec;  // if not the one that the record names
};

/// Regenerates a variant from its record or from the comment in its file and compares the bytes.
/// Findings say what differs, or why the variant fails, now as before; true if there are no errors.
bool Replay(const ReplayRequest& request, diag::Sources& sources, diag::Findings& findings);

}  // namespace mjforge::forge
