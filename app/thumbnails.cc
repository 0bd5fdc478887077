// Draws thumbnails of variants for report pages, from their files, from archives, or made again.
#include "thumbnails.h"

#include <system_error>
#include <utility>

#include "mjforge/output/output.h"
#include "spec_view.h"

namespace mjforge::app {
namespace {

// Width in pixels, larger than the picture on the page, for screens of high resolution.
constexpr int kWidth = 320;
constexpr int kHeight = 240;
constexpr int kQuality = 75;  // about 5 kB; lower qualities have visible blocks

}  // namespace

Thumbnails::Thumbnails(std::filesystem::path manifest, std::string spec, diag::Sources& sources)
    : manifest_(std::move(manifest)), spec_(std::move(spec)), sources_(sources) {}

std::optional<report::Thumbnail> Thumbnails::Draw(const manifest::Record& record) {
  if (!Open()) return std::nullopt;
  const std::unique_ptr<picture::Subject> subject = Load(record);
  if (subject == nullptr) return std::nullopt;
  diag::Findings ignored;  // after an error, the page has one picture less
  picture::Options options = {.width = kWidth, .height = kHeight};
  if (const forge::Recipe* recipe = RecipeOf(record)) {
    options.view = ViewOf(*recipe->spec);
    SetPoseOf(*recipe->spec, *subject, ignored);
  }
  const std::optional<picture::Image> image = renderer_->Draw(*subject, options, ignored);
  if (!image) return std::nullopt;
  return report::Thumbnail{picture::EncodeWebp(*image, kQuality), kWidth, kHeight};
}

// Opens the renderer when the first picture is drawn, because pages without pictures need none.
bool Thumbnails::Open() {
  if (std::exchange(opened_, true)) return renderer_ != nullptr;
  diag::Findings found;
  renderer_ = picture::Renderer::Open(found);
  for (const diag::Finding& finding : found)
    findings_.Warn(finding.code, finding.mark, finding.message, finding.hint);
  return renderer_ != nullptr;
}

std::unique_ptr<picture::Subject> Thumbnails::Load(const manifest::Record& record) {
  if (record.file.empty()) return MakeAgain(record, {});
  if (!record.archive.empty()) return LoadFromArchive(record);
  if (record.each) return MakeAgain(record, record.sha256);  // the record's file is the placement
  std::string why_not;
  const std::filesystem::path file = manifest_.parent_path() / record.file;
  return bytes::IsFile(file) ? loader_.LoadFile(file, why_not) : nullptr;
}

// Makes the object again from the spec, because that is faster than reading all earlier members of
// the archive. Reads the archive if the object is not the same.
std::unique_ptr<picture::Subject> Thumbnails::LoadFromArchive(const manifest::Record& record) {
  const std::filesystem::path archive = manifest_.parent_path() / record.archive;
  if (!bytes::IsFile(archive)) return nullptr;
  if (auto subject = MakeAgain(record, record.sha256)) return subject;
  diag::Findings ignored;
  const std::optional<std::string> text = output::ReadMember(archive, record.file, ignored);
  std::string why_not;
  return text ? loader_.LoadText(*text, {}, why_not) : nullptr;
}

const forge::Recipe* Thumbnails::RecipeOf(const manifest::Record& record) {
  if (!std::exchange(looked_for_recipe_, true)) {
    diag::Findings ignored;  // the report already has these findings
    recipe_ = forge::LoadRecordedRecipe(record, spec_, manifest_.parent_path(), sources_, ignored);
  }
  const bool is_its_own = recipe_ && recipe_->spec->sha256 == record.spec_sha256;
  return is_its_own ? &*recipe_ : nullptr;
}

std::unique_ptr<picture::Subject> Thumbnails::MakeAgain(const manifest::Record& record,
                                                        const std::string& sha256) {
  const forge::Recipe* recipe = RecipeOf(record);
  diag::Findings ignored;
  auto options = forge::RecordedOptions(record, record.name, ignored);
  if (recipe == nullptr || !options) return nullptr;
  options->validation = forge::Validation::kNone;
  forge::Generator generator(*recipe, sources_, *options);
  forge::Variant variant;
  generator.Make(record.index, variant);
  if (!variant.object || (!sha256.empty() && variant.record.sha256 != sha256)) return nullptr;
  std::string why_not;
  return loader_.LoadText(variant.document.text, variant.document.assets, why_not);
}

}  // namespace mjforge::app
