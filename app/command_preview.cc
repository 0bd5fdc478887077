#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.h"
#include "mjforge/forge/forge.h"
#include "preview_captions.h"
#include "preview_file.h"
#include "preview_options.h"
#include "usage.h"

namespace mjforge::app {
namespace {

// One object that is to be drawn, and what its picture says of it.
struct Sight {
  std::unique_ptr<picture::Subject> subject;
  manifest::Record record;  // empty for a file
};

class Preview {
 public:
  Preview(const PreviewOptions& options, PreviewRequest request)
      : options_(options), request_(std::move(request)), console_(options.report) {}

  ExitStatus operator()() {
    const std::optional<std::string> bytes = Make();
    const bool printed = options_.output == "-";
    if (bytes && !printed && MayReplacePicture(place_, options_.force, findings_))
      output::WriteFile(place_, *bytes, false, findings_);
    const ExitStatus status = StatusOf(findings_);
    console_.Show(std::move(findings_), sources_);
    return bytes && printed ? Worse(status, Print(*bytes)) : status;
  }

 private:
  std::optional<std::string> Make() {
    std::vector<Sight> sights = options_.is_file() ? LoadFile() : LoadVariants();
    if (sights.empty() || !Pose(sights)) return std::nullopt;
    // Before the work that would be in vain.
    if (options_.output != "-" && !MayReplacePicture(place_, options_.force, findings_))
      return std::nullopt;
    const auto renderer = picture::Renderer::Open(findings_);
    if (!renderer) return std::nullopt;
    if (options_.sweep) return DrawSweep(*renderer, sights.front());
    return options_.count > 1 ? DrawSheet(*renderer, sights) : DrawOne(*renderer, sights.front());
  }

  void ChoosePlace(const std::string& name) {
    place_ = options_.output.empty() ? name + ".png" : options_.output;
  }

  std::vector<Sight> LoadFile() {
    ChoosePlace(std::filesystem::path(options_.what).stem().string());
    std::vector<Sight> sights;
    // Says what is wrong with it, and where.
    if (!validate::Loader().Load(options_.what, sources_, findings_) || findings_.HasErrors())
      return sights;
    std::string why_not;
    auto subject = picture::Loader().LoadFile(options_.what, why_not);
    if (subject) {
      sights.push_back({std::move(subject), {}});
    } else {
      findings_.Add(diag::Code::kMujocoError, {}, fmt::format("MuJoCo refused it: {}", why_not));
    }
    return sights;
  }

  std::vector<Sight> LoadVariants() {
    std::vector<Sight> sights;
    recipe_ = forge::LoadRecipe(options_.what, MakeLoadOptions(options_.spec), sources_, findings_);
    if (!recipe_) return sights;
    ChoosePlace(recipe_->spec->name);
    forge::Options options;
    options.seed = options_.seed;
    options.validation = forge::Validation::kNone;
    forge::Generator generator(*recipe_, sources_, options);
    picture::Loader loader;
    forge::Variant variant;
    for (std::uint64_t i = 0; i < options_.count; ++i) {
      generator.Make(options_.first + i, variant);
      findings_.Append(variant.findings);
      if (!variant.ok()) continue;
      std::string why_not;
      auto subject = loader.LoadText(variant.document.text, variant.document.assets, why_not);
      if (subject) {
        sights.push_back({std::move(subject), variant.record});
      } else {
        Explain(variant, why_not);
      }
    }
    return sights;
  }

  // MuJoCo's refusal, at the place in the spec.
  void Explain(const forge::Variant& variant, const std::string& why_not) {
    diag::Findings found;
    validate::Loader().Validate(variant.document, *variant.object, found);
    if (!found.HasErrors())
      found.Add(diag::Code::kMujocoError, {}, fmt::format("MuJoCo refused it: {}", why_not));
    found.SetVariant(options_.seed, variant.record.index);
    findings_.Append(std::move(found));
  }

  bool Pose(std::vector<Sight>& sights) {
    for (Sight& sight : sights) {
      for (const auto& [name, value] : request_.joints) {
        const std::optional<int> joint = sight.subject->FindJoint(name, findings_);
        if (joint) sight.subject->SetJoint(*joint, value, findings_);
      }
      if (findings_.HasErrors() && !request_.joints.empty()) return false;
    }
    return true;
  }

  std::optional<std::string> DrawOne(picture::Renderer& renderer, Sight& sight) {
    const auto image = renderer.Draw(*sight.subject, request_.picture, findings_);
    if (!image) return std::nullopt;
    return picture::EncodePng(*image, TextsOf(sight.record, ""));
  }

  std::optional<std::string> DrawSweep(picture::Renderer& renderer, Sight& sight) {
    constexpr int kDelay = 50;  // ms
    std::optional<int> joint;
    if (!request_.swept.empty()) {
      joint = sight.subject->FindJoint(request_.swept, findings_);
      if (!joint) return std::nullopt;
    }
    const std::vector<picture::Pose> poses = sight.subject->Sweep(joint, findings_);
    if (poses.empty()) return std::nullopt;
    const auto frames = renderer.DrawMotion(*sight.subject, poses, request_.picture, findings_);
    if (!frames) return std::nullopt;
    const picture::Texts texts = TextsOf(sight.record, "");
    return place_.extension() == ".gif" ? picture::EncodeGif(*frames, kDelay, texts)
                                        : picture::EncodeApng(*frames, kDelay, texts);
  }

  std::optional<std::string> DrawSheet(picture::Renderer& renderer, std::vector<Sight>& sights) {
    picture::Options tile = request_.picture;
    tile.background.transparent = true;
    std::vector<manifest::Record> records;
    std::vector<picture::Tile> tiles;
    for (Sight& sight : sights) {
      diag::Findings found;
      auto image = renderer.Draw(*sight.subject, tile, found);
      found.SetVariant(options_.seed, sight.record.index);
      findings_.Append(std::move(found));
      sight.subject.reset();
      if (!image) continue;
      tiles.push_back({*std::move(image), {}});
      records.push_back(sight.record);
    }
    if (tiles.empty()) return std::nullopt;
    const auto captions = Captions(records, *recipe_->spec);
    for (std::size_t i = 0; i < tiles.size(); ++i) tiles[i].caption = captions[i];
    const picture::Image sheet =
        picture::ContactSheet(renderer, tiles, request_.picture.background);
    return picture::EncodePng(sheet, TextsOf(records.front(), fmt::format("+{}", options_.count)));
  }

  // So that a picture can be traced to what it shows.
  picture::Texts TextsOf(const manifest::Record& record, const std::string& count) const {
    picture::Texts texts = {{"Software", std::string(PictureSoftware())}};
    if (recipe_) {
      texts.emplace_back("mjforge",
                         fmt::format("spec={} sha256={} seed={} index={}{}", record.spec,
                                     record.spec_sha256, record.seed, record.index, count));
    } else {
      texts.emplace_back("mjforge",
                         "file=" + std::filesystem::path(options_.what).filename().string());
    }
    return texts;
  }

  const PreviewOptions& options_;
  PreviewRequest request_;
  Console console_;
  diag::Sources sources_;
  diag::Findings findings_;
  std::optional<forge::Recipe> recipe_;
  std::filesystem::path place_;
};

}  // namespace

Action AddPreview(CLI::App& app) {
  CLI::App& command = *app.add_subcommand("preview", "Draw an object, or a sheet of variants");
  auto options = std::make_shared<PreviewOptions>();
  AddPreviewOptions(command, *options);
  AddExamples(command,
              "  mjforge preview hammer -n 16 -o hammers.png\n"
              "  mjforge preview hinged_box --joint hinge=45deg\n"
              "  mjforge preview faucet --sweep -o faucet.gif --size 320\n"
              "  mjforge preview robot.xml --layer collision --size 1280x720");
  return [options] {
    std::string why_not;
    std::optional<PreviewRequest> request = RequestOf(*options, why_not);
    if (!request) return WrongUsage(why_not, "preview");
    if (options->output == "-" && ::isatty(STDOUT_FILENO) != 0)
      return WrongUsage("-o -: a terminal cannot show a picture", "preview");
    return Preview(*options, *std::move(request))();
  };
}

}  // namespace mjforge::app
