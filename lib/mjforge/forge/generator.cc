// Generator: draws, assembles, writes and validates one variant, and fills in its record.

#include <algorithm>

#include "mjforge/bytes/bytes.h"
#include "mjforge/forge/forge.h"
#include "mjforge/placing/placing.h"
#include "mjforge/static_checks/static_checks.h"

namespace mjforge::forge {
namespace {

// Returns the path of a file relative to a folder. Returns an empty path if file and folder share
// only the root folder, because such a path would differ between machines.
std::string RelativePath(const std::filesystem::path& file, const std::filesystem::path& folder) {
  std::error_code error;
  const auto absolute = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, error);
  if (error) return {};
  // Removes a final slash, which weakly_canonical() keeps if the folder does not exist yet.
  const auto root = absolute.has_filename() ? absolute : absolute.parent_path();
  const auto below = root.relative_path();
  if (!below.empty() && *below.begin() != *file.relative_path().begin()) return {};
  return file.lexically_relative(root).generic_string();
}

void RecordPlaces(const model::Object& object, manifest::Record& record) {
  record.left_out = object.left_out;
  const std::vector<model::Pose> X_WB = model::BodyPoses(object);
  for (std::size_t i = 0; i < object.bodies.size(); ++i) {
    const model::Body& body = object.bodies[i];
    if (body.place_name.empty()) continue;
    const Eigen::Vector4d quat = model::Wxyz(X_WB[i].q);
    record.places.push_back({body.name, body.place_name, X_WB[i].p, {quat.begin(), quat.end()}});
  }
}

// Adds masses, bounds and counts of elements to the record.
void RecordProperties(const model::Object& object, mjcf::Target target, manifest::Record& record) {
  record.mass_properties = object.mass_properties;
  record.bounds = object.bounds;
  record.nbody = 1;                                        // the world
  record.ngeom = mjcf::RulesOf(target).has_scene ? 1 : 0;  // the floor
  for (const model::Body& body : object.bodies) {
    ++record.nbody;
    record.njnt += static_cast<int>(body.joints.size());
    record.ngeom += static_cast<int>(model::GeomCount(body));
  }
}

}  // namespace

manifest::Record BatchRecord(const Recipe& recipe, const Options& options) {
  manifest::Record record;
  record.version = Version();
  record.seed = options.seed;
  record.place_seed = options.place_seed;
  record.spec = recipe.reference;
  if (options.folder && !recipe.file.empty())
    record.spec_file = RelativePath(recipe.file, *options.folder);
  if (options.folder && !recipe.snapshot.empty()) record.spec_file = options.snapshot_file;
  record.spec_sha256 = recipe.spec->sha256;
  record.settings = recipe.settings;
  record.target = mjcf::RulesOf(options.target).name;
  if (options.assets == mjcf::AssetForm::kFiles) record.assets_as = mjcf::kAssetForms[1];
  record.each = options.each;
  record.pad = options.pad;
  record.mocap = options.mocap;
  record.validate = options.validation;
  if (options.validation != Validation::kNone) record.mujoco = validate::MujocoVersion();
  record.on_invalid = options.on_invalid;
  record.layout = options.layout;
  if (options.layout == Layout::kOne || options.pad > 0) record.layout_first = options.layout_first;
  if (options.sampler != sample::Method::kRandom)
    record.sampler = sample::MethodName(options.sampler);
  if (sample::Sampler::NeedsBatch(*recipe.spec, options.sampler)) record.batch = options.batch;
  return record;
}

Generator::Generator(const Recipe& recipe, diag::Sources& sources, const Options& options)
    : recipe_(recipe),
      options_(options),
      loader_(options.validation == Validation::kNone ? nullptr
                                                      : std::make_unique<validate::Loader>()),
      laboratory_(options.validation == Validation::kPhysics
                      ? std::make_unique<physics::Laboratory>()
                      : nullptr),
      sources_(sources),
      common_(BatchRecord(recipe, options)),
      sampler_(*recipe.spec, options.sampler, options.seed, options.batch),
      attachments_(sources),
      placer_(placing::MakePlacer()),
      assembler_(&attachments_, placer_.get()) {}

void Generator::Reset(std::uint64_t index, std::uint64_t attempt, Variant& variant) {
  variant.object.reset();
  variant.placement.reset();
  variant.findings.clear();
  variant.structure = {};
  variant.numbers.reset();
  variant.record = common_;
  variant.record.index = index;
  variant.record.attempt = attempt;
  variant.record.name =
      options_.name.empty() ? recipe_.spec->name : ExpandName(options_.name, index);
}

void Generator::Make(std::uint64_t index, Variant& variant) {
  if (options_.pad > 0 && !options_.superset) options_.superset = FindSuperset();
  if (options_.layout == Layout::kOne && !reference_) FindReference();
  Outcome outcome = Attempt(index, options_.attempt, variant);
  const int resamples = options_.on_invalid == OnInvalid::kResample ? kMaxResamples : 0;
  for (int i = 0; i < resamples && outcome == Outcome::kFailed; ++i)
    outcome = Attempt(index, variant.record.attempt + 1, variant);
  Finish(outcome, variant);
}

void Generator::Fail(std::uint64_t index, diag::Finding finding, Variant& variant) {
  Reset(index, options_.attempt, variant);
  variant.findings.Add(std::move(finding));
  Finish(Outcome::kFailed, variant);
}

void Generator::Finish(Outcome outcome, Variant& variant) {
  manifest::Record& record = variant.record;
  if (outcome != Outcome::kOk) {
    const bool skips = options_.on_invalid == OnInvalid::kSkip;
    record.status = skips ? manifest::Status::kSkipped : manifest::Status::kFailed;
  } else {
    record.file = record.Folder() + output::PathInFolder(record.name, record.index,
                                                         record.each ? output::kPlacementEnding
                                                                     : output::kObjectEnding);
    record.sha256 = bytes::Sha256Of(variant.output().text);
  }
  variant.findings.SetVariant(options_.seed, record.index);
  while (record_sources_.size() < sources_.size()) {  // files attached since the last call
    const std::filesystem::path file = sources_.Name(record_sources_.size() + 1);
    record_sources_.Add(file.filename().string(), {});
  }
  for (const diag::Finding& finding : variant.findings) {
    record.findings.push_back(diag::RenderJson(finding, record_sources_));
  }
}

Generator::Outcome Generator::Attempt(std::uint64_t index, std::uint64_t attempt,
                                      Variant& variant) {
  Reset(index, attempt, variant);
  manifest::Record& record = variant.record;
  const spec::ObjectSpec& spec = *recipe_.spec;
  const sample::DrawKey key = {options_.seed, index, attempt};
  std::optional<sample::Evaluator> values =
      sample::Sample(spec, key, sample::kRootStream, {}, variant.findings, &sampler_);
  if (!values) {
    // If the requirements of the spec rejected all draws (kSampleRejected), further attempts would
    // fail, too.
    const bool rejected =
        std::ranges::count(variant.findings, diag::Code::kSampleRejected, &diag::Finding::code) > 0;
    return rejected ? Outcome::kRejected : Outcome::kFailed;
  }
  record.attempt = values->key().attempt;
  record.params.reserve(spec.parameters.size());
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    record.params.emplace_back(spec.parameters[i].name, values->Parameter(i));
  }
  if (!Build(*values, variant) || !files_.Make(*variant.object, variant.document, variant.findings))
    return Outcome::kFailed;
  RecordProperties(*variant.object, options_.target, record);
  if (spec.has_place) RecordPlaces(*variant.object, record);
  Validate(variant);
  if (variant.findings.HasErrors() || (options_.each && !WriteEach(variant)))
    return Outcome::kFailed;
  return HashAssets(variant) ? Outcome::kOk : Outcome::kFailed;
}

// Simulates piles even without validation, because the poses at rest are part of the file.
bool Generator::SettlePiles(model::Object& object, Variant& variant) {
  if (object.piles.empty()) return true;
  if (!pile_settler_) pile_settler_ = std::make_unique<physics::PileSettler>();
  variant.record.pile_mujoco = validate::MujocoVersion();
  if (!pile_settler_->Settle(object, variant.findings)) return false;
  model::MeasureAtStart(object);
  return true;
}

std::optional<model::Object> Generator::Assemble(sample::Evaluator& values, Variant& variant) {
  const mjcf::TargetRules& rules =
      mjcf::RulesOf(options_.each ? mjcf::Target::kMujoco : options_.target);
  return assembler_.Assemble(values,
                             {.name = variant.record.name,
                              .prefix = rules.has_prefix && !options_.each,
                              .root = std::string(rules.root),
                              .place_seed = options_.place_seed},
                             variant.findings);
}

bool Generator::Build(sample::Evaluator& values, Variant& variant) {
  const manifest::Record& record = variant.record;
  const mjcf::Target target = options_.each ? mjcf::Target::kMujoco : options_.target;
  std::optional<model::Object> object = Assemble(values, variant);
  if (!object || !SettlePiles(*object, variant)) return false;
  if (options_.each && !SplitScene(*object, variant)) return false;
  // Drops warnings about the scene with --each, because WritePart() adds the warnings about each
  // object.
  diag::Findings of_scene;
  mjcf::Adapt(*object, target, options_.each ? of_scene : variant.findings);
  if (of_scene.HasErrors()) variant.findings.Append(std::move(of_scene));
  if (options_.superset) options_.superset->Complete(*object);
  variant.object = std::make_shared<const model::Object>(*std::move(object));
  if (variant.findings.HasErrors()) return false;
  mjcf::Provenance provenance = record;
  if (record.name == recipe_.spec->name) provenance.name.clear();
  if (options_.each) provenance.assets_as.clear();
  mjcf::WriteMjcf(*variant.object, target, provenance, variant.document);
  return true;
}

void Generator::Validate(Variant& variant) {
  static_checks::CheckExpectations(*variant.object, variant.findings);
  if (!loader_) return;
  family::Numbers* const numbers = options_.family ? &variant.numbers.emplace() : nullptr;
  const bool is_valid = loader_->Validate(variant.document, *variant.object, variant.findings,
                                          &variant.structure, numbers);
  variant.record.structure = variant.structure.Key();
  if (is_valid && CheckStructure(variant) && laboratory_) {
    variant.record.physics =
        laboratory_->Examine(variant.document, *variant.object, variant.findings);
  }
}

bool Generator::HashAssets(Variant& variant) {
  for (const auto& [name, file, content] : variant.output().assets) {
    std::string made;
    std::string& hash = content ? made : hashes_[file.string()];
    if (content) {
      hash = bytes::Sha256Of(*content);
    } else if (hash.empty()) {
      const auto bytes = output::ReadFile(file, bytes::kMaxAsset, variant.findings);
      if (!bytes) return false;
      hash = bytes::Sha256Of(*bytes);
    }
    const std::pair<std::string, std::string> asset(name, hash);
    std::vector<std::pair<std::string, std::string>>& assets = variant.record.assets;
    if (std::ranges::find(assets, asset) == assets.end()) assets.push_back(asset);
  }
  return true;
}

}  // namespace mjforge::forge
