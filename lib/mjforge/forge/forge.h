// Generation of variants from a spec: draws parameters, builds the object, writes MJCF, validates.
// Most callers need no other header:
//
//   diag::Sources sources;
//   diag::Findings findings;
//   auto recipe = forge::LoadRecipe("hammer", {.search_path = forge::SearchPath()}, sources,
//                                   findings);
//   forge::Generator generator(*recipe, sources, {.seed = 7});
//   forge::Variant variant;
//   generator.Make(41, variant);  // variant.document.text is the MJCF
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/assemble/assemble.h"
#include "mjforge/attach/attach.h"
#include "mjforge/diag/diag.h"
#include "mjforge/files/files.h"
#include "mjforge/forge/variant.h"
#include "mjforge/manifest/manifest.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/output/output.h"
#include "mjforge/padding/padding.h"
#include "mjforge/physics/physics.h"
#include "mjforge/sample/sample.h"
#include "mjforge/spec/spec.h"
#include "mjforge/split/split.h"
#include "mjforge/structure/structure.h"
#include "mjforge/validate/validate.h"

namespace mjforge::forge {

/// Returns the version of mjforge: "0.1.0".
std::string_view Version();

/// Name and version of an outside library.
struct Library {
  std::string name;
  std::string version;
};
/// Returns the libraries whose version may change an object or the result of its validation.
std::vector<Library> Libraries();

/// Returns the folder of the bundled specs: share/mjforge/specs in any of the folders that contain
/// the program; nullopt if there is none.
std::optional<std::filesystem::path> CatalogueFolder();

/// Returns the folders in which specs are looked up by name: the folders of MJFORGE_PATH (separated
/// by colons), then `catalogue`, the folder of the bundled specs.
std::vector<std::filesystem::path> SearchPath(
    std::optional<std::filesystem::path> catalogue = CatalogueFolder());

/// A loaded spec from which variants are generated.
struct Recipe {
  std::unique_ptr<spec::ObjectSpec> spec;
  /// Name of the spec in records and comments: its name in the search path ("tools/hammer") or its
  /// file name. Independent of the machine, so that the same spec gives the same bytes in every
  /// folder.
  std::string reference;
  /// Path of the spec's file if `reference` is its file name; empty if `reference` is a name in the
  /// search path.
  std::filesystem::path file;
  /// Names and values of the applied settings: first from parameter files, then from the caller.
  /// Each name occurs once, with its last value.
  std::vector<std::pair<std::string, std::string>> settings;
  /// Text with the contents of all of the spec's files (spec::SnapshotText) if the spec was read
  /// from standard input, or from such a snapshot whose files were changed or removed since; else
  /// empty.
  std::string snapshot;
};

/// Loads the spec with this name or path (see spec::LoadSpec), or the spec in the snapshot file
/// `reference`.
std::optional<Recipe> LoadRecipe(const std::string& reference, const spec::LoadOptions& options,
                                 diag::Sources& sources, diag::Findings& findings);

/// Returns the thresholds of checks for a file that has no spec. Settings have names like
/// `checks.KEY`. Returns nullopt, after adding findings, if a setting is not a valid threshold.
std::optional<model::Checks> LoadChecks(const std::vector<spec::Setting>& settings,
                                        diag::Sources& sources, diag::Findings& findings);

/// Returns the name of a variant's object: `text` with every ${index} replaced.
std::string ExpandName(std::string_view text, std::uint64_t index);
/// Returns true if names that ExpandName() makes from `text` are valid; otherwise adds a finding.
bool CheckName(std::string_view text, diag::Findings& findings);

/// Returns a record with the fields that are equal in all variants of a batch.
manifest::Record BatchRecord(const Recipe& recipe, const Options& options);

/// Generates variants of a recipe. Keeps parsed and loaded files between variants. A generator's
/// memory does not grow with the number of variants.
class Generator {
 public:
  /// The recipe and its sources must outlive the generator. Attached XML files are added to the
  /// sources.
  Generator(const Recipe& recipe, diag::Sources& sources, const Options& options);

  /// Generates the variant with this index, and replaces the content of `variant`. The result
  /// depends only on the recipe, the options and the index.
  void Make(std::uint64_t index, Variant& variant);

  /// Returns all geoms and sites of the Options::pad variants from index Options::layout_first on,
  /// without variants that cannot be made. Stops early if `*stop` is true.
  std::shared_ptr<const padding::Superset> FindSuperset(const std::atomic<bool>* stop = nullptr);

  /// Replaces `variant` by a failed variant with this finding, without generating it.
  void Fail(std::uint64_t index, diag::Finding finding, Variant& variant);

 private:
  // kRejected: the spec's requirements rejected all draws. Further attempts would fail, too.
  enum class Outcome { kOk, kFailed, kRejected };
  void Reset(std::uint64_t index, std::uint64_t attempt, Variant& variant);
  Outcome Attempt(std::uint64_t index, std::uint64_t attempt, Variant& variant);
  /// Assembles the object from drawn values; returns nullopt after an error.
  std::optional<model::Object> Assemble(sample::Evaluator& values, Variant& variant);
  /// Makes the object of a variant before padding (Options::pad) and before its piles are settled;
  /// returns nullopt after an error.
  std::optional<model::Object> Unpadded(std::uint64_t index, std::uint64_t attempt,
                                        Variant& variant);
  /// Simulates the piles of an object until they are at rest; returns false after an error.
  bool SettlePiles(model::Object& object, Variant& variant);
  /// Assembles the object from drawn values and writes its MJCF; returns false after an error.
  bool Build(sample::Evaluator& values, Variant& variant);
  void Validate(Variant& variant);
  /// Sets `reference_` for Layout::kOne: the first valid variant, whose structure all variants must
  /// have.
  void FindReference();
  /// Returns true if Options::layout allows the structure of a variant; otherwise adds a finding.
  bool CheckStructure(Variant& variant) const;
  // SplitScene() divides a scene into objects, WriteEach() writes all objects, WritePart() writes
  // one. All return false after an error.
  bool SplitScene(const model::Object& scene, Variant& variant);
  bool WriteEach(Variant& variant);
  bool WritePart(split::ScenePart& part, manifest::PlacedFile& placed, Variant& variant);
  /// Adds the SHA-256 of each asset to the record; returns false if an asset cannot be read.
  bool HashAssets(Variant& variant);
  void Finish(Outcome outcome, Variant& variant);

  const Recipe& recipe_;
  Options options_;
  std::unique_ptr<validate::Loader> loader_;         // null: variants are not loaded in MuJoCo
  std::unique_ptr<physics::Laboratory> laboratory_;  // null: variants are not simulated
  const diag::Sources& sources_;
  diag::Sources record_sources_;  // `sources_` with file names in place of paths
  manifest::Record common_;       // result of BatchRecord()
  sample::Sampler sampler_;
  files::Maker files_;
  attach::MjcfReader attachments_;
  std::unique_ptr<model::Placer> placer_;
  std::unique_ptr<physics::PileSettler> pile_settler_;  // null before the first pile
  assemble::Assembler assembler_;
  std::map<std::string, std::string> hashes_;  // hashes of assets, by file
  std::vector<split::ScenePart> parts_;        // objects of the current scene
  /// Layout::kOne: record and structure of the reference, the first valid variant. The structure is
  /// empty if none of the first kMaxReferences variants is valid.
  std::optional<std::pair<manifest::Record, structure::Structure>> reference_;
};

/// Loads the recipe of a record from `spec` or, if `spec` is empty, from the recorded spec. Looks
/// for the recorded spec at its recorded path, which is relative to `folder` (the manifest's
/// folder), then for its recorded name in the working directory, in `folder`, one folder up, and in
/// the search path. Returns nullopt, with findings, if the spec is missing or has changed.
std::optional<Recipe> LoadRecordedRecipe(const manifest::Record& record, const std::string& spec,
                                         const std::filesystem::path& folder,
                                         diag::Sources& sources, diag::Findings& findings);
/// Returns the options that regenerate a record's variant; nullopt, with a finding about `what`, if
/// the target, the sampler or the form of assets in the record is unknown.
std::optional<Options> RecordedOptions(const manifest::Record& record, std::string_view what,
                                       diag::Findings& findings);

/// A variant to regenerate and compare.
struct ReplayRequest {
  std::string what;  // a record ("out/manifest.jsonl:42") or a file ("out/hammer_000042.xml")
  std::string spec;  // spec to regenerate the variant from; empty: the recorded spec
};

/// Regenerates a variant from its record or from the comment in its file and compares the bytes.
/// Adds findings about differences, or, for a variant recorded as failed, the reasons of its
/// failure. Returns true if there are no errors.
bool Replay(const ReplayRequest& request, diag::Sources& sources, diag::Findings& findings);

}  // namespace mjforge::forge
