// Makes the pages of specs for `mjforge catalogue --html`: variants, pictures, films of joints.
#include "gallery_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "gallery_facts.h"
#include "mjforge/forge/forge.h"
#include "mjforge/output/output.h"
#include "spec_view.h"

namespace mjforge::app {
namespace {

constexpr std::uint64_t kSeed = 7;
constexpr std::uint64_t kTiles = 8;
constexpr std::uint64_t kMeasured = 24;  // variants for ranges of mass and size
constexpr std::size_t kFilms = 4;
constexpr int kFrames = 9;

constexpr std::pair kLarge = {640, 480};
constexpr std::pair kTile = {320, 240};
constexpr std::pair kCard = {256, 256};
constexpr int kQuality = 80;

report::Thumbnail Encode(const picture::Image& image) {
  return {picture::EncodeWebp(image, kQuality), image.width, image.height};
}

std::optional<report::Thumbnail> Draw(picture::Renderer& renderer, picture::Subject& subject,
                                      const picture::View& view, std::pair<int, int> size) {
  diag::Findings ignored;  // after an error, the page has one picture less
  const auto [width, height] = size;
  const picture::Options options = {.width = width, .height = height, .view = view};
  const auto image = renderer.Draw(subject, options, ignored);
  return image ? std::optional(Encode(*image)) : std::nullopt;
}

// Returns a joint's name without the number at its end, so that joints whose names differ only in
// this number get one film.
std::string_view WithoutNumber(std::string_view name) {
  while (!name.empty() && std::string_view("0123456789_").find(name.back()) != name.npos)
    name.remove_suffix(1);
  return name;
}

// Makes the HTML page of one spec. Draws each variant before loading the next variant, because one
// model with many objects may fill most of the memory in MuJoCo 2.2.
class PageMaker {
 public:
  /// `open` opens the renderer; returns null if there is no renderer.
  PageMaker(std::string name, forge::Recipe recipe, diag::Sources& sources,
            std::function<picture::Renderer*()> open)
      : name_(std::move(name)),
        recipe_(std::move(recipe)),
        view_(ViewOf(*recipe_.spec)),
        sources_(sources),
        open_(std::move(open)) {}

  /// Makes and draws variants; returns false if MuJoCo loads no variant. Adds the findings of all
  /// variants to `findings`.
  bool MakeVariants(diag::Findings& findings) {
    // Makes fewer variants of scenes, which take long.
    const std::uint64_t count = recipe_.spec->has_place ? kTiles : kMeasured;
    forge::Generator generator(recipe_, sources_, options_);
    forge::Variant variant;
    std::uint64_t failed = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      generator.Make(i, variant);
      findings.Append(variant.findings);
      const bool is_good =
          variant.ok() && ((i >= kTiles && typical_subject_ != nullptr) || Load(variant, findings));
      if (is_good) {
        page_.variants.push_back(variant.record);
      } else {
        ++failed;
      }
    }
    if (typical_subject_ == nullptr) return false;
    if (failed > 0) {
      page_.notices.push_back(fmt::format("{} of {} variants could not be made: {}", failed, count,
                                          findings.FirstError()->message));
    }
    return true;
  }

  /// Draws the variant of the large picture, and films of its joints.
  void DrawTypical(report::GalleryCard& card) {
    if (renderer_ == nullptr) return;
    const std::uint64_t index = typical_.record.index;
    if (auto large = Draw(*renderer_, *typical_subject_, view_, kLarge)) {
      page_.large = {*large, fmt::format("Variant {} of {}", index, name_),
                     fmt::format("Variant {} of seed {}", index, kSeed)};
    }
    card.picture = Draw(*renderer_, *typical_subject_, view_, kCard);
    DrawFilms(*renderer_, *typical_subject_);
  }

  std::string Finish(report::GalleryCard& card) {
    card.facts = ShortFacts(page_.variants, *typical_.object);
    card.has_page = true;
    page_.facts = FactsOf(page_.variants, typical_);
    page_.features = FeaturesOf(*typical_.object);
    page_.features.push_back(TargetsOf(recipe_, sources_, options_, typical_.record.index));
    page_.name = name_;
    page_.text = sources_.Text(1);
    page_.recipe = std::move(recipe_);
    return report::MakeSpecPage(std::move(page_));
  }

 private:
  bool Load(const forge::Variant& variant, diag::Findings& findings) {
    std::string why_not;
    auto subject = loader_.LoadText(variant.document.text, variant.document.assets, why_not);
    if (!subject) {
      findings.Add(diag::Code::kMujocoError, {}, fmt::format("MuJoCo refused it: {}", why_not));
      return false;
    }
    diag::Findings of_view;
    SetPoseOf(*recipe_.spec, *subject, of_view);
    if (!of_view.empty() && page_.notices.empty()) page_.notices.push_back(of_view[0].message);
    if (typical_subject_ == nullptr) renderer_ = open_();
    if (renderer_ != nullptr) DrawTile(variant.record.index, *subject);
    if (typical_subject_ == nullptr) {
      typical_ = variant;
      typical_subject_ = std::move(subject);
    }
    return true;
  }

  void DrawTile(std::uint64_t index, picture::Subject& subject) {
    if (auto drawn = Draw(*renderer_, subject, view_, kTile)) {
      page_.tiles.push_back({*drawn, fmt::format("Variant {} of {}", index, name_),
                             fmt::format("Variant {}", index)});
    }
  }

  void DrawFilms(picture::Renderer& renderer, picture::Subject& subject) {
    std::set<std::string_view> drawn;
    const std::vector<picture::Joint> joints = subject.joints();
    for (std::size_t i = 0; i < joints.size() && page_.films.size() < kFilms; ++i) {
      const picture::Joint& joint = joints[i];
      if (joint.IsMovable() && joint.limited && drawn.insert(WithoutNumber(joint.name)).second)
        DrawFilm(renderer, subject, static_cast<int>(i), joint);
    }
  }

  void DrawFilm(picture::Renderer& renderer, picture::Subject& subject, int number,
                const picture::Joint& joint) {
    diag::Findings ignored;  // after an error, the page has one film less
    // Undoes the film of another joint, and the pose of `view:`, in which this joint may pass
    // through a door.
    subject.Reset(picture::Pose::kStart);
    std::vector<picture::JointPositions> poses;
    for (int i = 0; i < kFrames; ++i) {
      const double share = static_cast<double>(i) / (kFrames - 1);
      poses.push_back({{number, joint.range[0] + share * (joint.range[1] - joint.range[0])}});
    }
    const auto frames = renderer.DrawMotion(
        subject, poses, {.width = kTile.first, .height = kTile.second, .view = view_}, ignored);
    if (!frames) return;
    const std::string name = ShortName(*typical_.object, joint.name);
    report::Film film{name, {}};
    for (std::size_t i = 0; i < frames->size(); ++i) {
      const double value = poses[i].front().second;
      const std::string text =
          joint.type == picture::Joint::Type::kSlide ? LengthText(value) : AngleText(value);
      film.frames.push_back(
          {Encode((*frames)[i]), fmt::format("{} with {} at {}", name_, name, text), text});
    }
    page_.films.push_back(std::move(film));
  }

  std::string name_;
  forge::Recipe recipe_;
  picture::View view_;
  diag::Sources& sources_;
  forge::Options options_ = {.seed = kSeed, .validation = forge::Validation::kNone};
  picture::Loader loader_;
  std::function<picture::Renderer*()> open_;
  picture::Renderer* renderer_ = nullptr;
  forge::Variant typical_;  // the variant in the large picture
  std::unique_ptr<picture::Subject> typical_subject_;
  report::SpecPage page_;
};

// Returns the first error of a spec as a finding about the spec, without a place in a file.
diag::Finding Problem(const std::string& name, const diag::Findings& findings) {
  const diag::Finding& first = *findings.FirstError();
  return {.code = first.code,
          .message = fmt::format("'{}': {}", name, first.message),
          .hint = first.hint};
}

}  // namespace

GalleryResult GalleryPages::Make(const std::string& name) {
  GalleryResult result;
  diag::Sources sources;
  diag::Findings findings;
  const spec::LoadOptions load = {.search_path = forge::SearchPath()};
  auto recipe = forge::LoadRecipe(name, load, sources, findings);
  diag::Findings drawing;
  picture::Renderer* renderer = nullptr;
  std::optional<PageMaker> maker;
  if (recipe)
    maker.emplace(name, *std::move(recipe), sources,
                  [&] { return renderer = OpenRenderer(drawing); });
  if (!maker || !maker->MakeVariants(findings)) {
    result.finding = Problem(name, findings);
    result.card.problem = result.finding->message;
    return result;
  }
  maker->DrawTypical(result.card);
  if (renderer == nullptr && !drawing.empty()) result.finding = drawing[0];
  const std::filesystem::path file = report::GalleryPageFile(name);
  output::MadeFolders folders;
  diag::Findings written;
  if (!folders.MakeBelow(folder_, file.parent_path(), written) ||
      !output::WriteFile(folder_ / file, maker->Finish(result.card), false, written)) {
    result.card.has_page = false;
    result.finding = Problem(name, written);
    result.card.problem = result.finding->message;
  }
  return result;
}

// Opens the renderer once; later calls return the same renderer.
picture::Renderer* GalleryPages::OpenRenderer(diag::Findings& findings) {
  if (!std::exchange(is_opened_, true)) renderer_ = picture::Renderer::Open(findings);
  return renderer_.get();
}

}  // namespace mjforge::app
