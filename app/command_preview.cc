// `mjforge preview`: draws pictures, contact sheets and animations of objects.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <limits>
#include <memory>
#include <set>
#include <utility>

#include "child_process.h"
#include "commands.h"
#include "mjforge/batch/batch.h"
#include "mjforge/forge/forge.h"
#include "preview_captions.h"
#include "preview_options.h"
#include "spec_view.h"
#include "usage.h"
#include "watched_files.h"

namespace mjforge::app {
namespace {

// Returns true if `file` does not exist, is a picture made by mjforge, or `force` is set; otherwise
// adds a finding.
bool MayReplacePicture(const std::filesystem::path& file, bool force, diag::Findings& findings) {
  constexpr std::size_t kStart = 8192;  // contains the metadata, which precede the pixels
  const auto is_ours = [](std::string_view start) {
    const bool picture = start.starts_with("\x89PNG\r\n") || start.starts_with("GIF89a");
    return picture && start.substr(0, kStart).find("mjforge ") != start.npos;
  };
  return output::MayReplace(file, force, kStart, is_ours, findings);
}

// Returns a summary without a limit of findings, because the console limits the number it prints.
batch::FindingSummary VariantFindings() {
  return batch::FindingSummary(std::numeric_limits<std::size_t>::max());
}

// An object to draw, and the record for the picture's caption and metadata.
struct PreviewObject {
  std::unique_ptr<picture::Subject> subject;
  manifest::Record record;  // for an MJCF file, only the file's name without its ending
};

// Returns the names of all sources, and of the files in the findings.
std::set<std::string> NamesOf(const diag::Sources& sources, const diag::Findings& findings) {
  std::set<std::string> names;
  for (std::uint32_t i = 1; i <= sources.size(); ++i) names.insert(sources.Name(i));
  for (const diag::Finding& finding : findings)
    names.insert(finding.files.begin(), finding.files.end());
  return names;
}

std::string StemOf(const std::string& file) { return std::filesystem::path(file).stem().string(); }

class Preview {
 public:
  Preview(const PreviewOptions& options, Console& console)
      : options_(options),
        picture_(options.picture),
        console_(console),
        findings_(console.findings) {}

  /// Makes the picture. If `files` is not null, writes the names of all files that the picture
  /// depends on to `files`.
  ExitStatus operator()(std::FILE* files) {
    const std::optional<std::string> bytes = Make();
    if (files != nullptr) WriteFiles(files);
    const bool printed = options_.output == "-";
    if (bytes && !printed && MayReplacePicture(place_, options_.force, findings_))
      output::WriteSingleFile(place_, *bytes, findings_);
    const ExitStatus status = console_.Report();
    return bytes && printed ? Worse(status, PrintBytes(*bytes)) : status;
  }

 private:
  void WriteFiles(std::FILE* file) const {
    std::set<std::string> names = NamesOf(console_.sources, findings_);
    names.insert(assets_.begin(), assets_.end());
    for (const std::string& name : names) std::fwrite(name.c_str(), 1, name.size() + 1, file);
    std::fflush(file);
  }

  std::optional<std::string> Make() {
    std::vector<PreviewObject> objects = options_.is_file ? LoadFiles() : LoadVariants();
    if (objects.empty() || !Pose(objects)) return std::nullopt;
    // Checks the existing file before drawing, which may take long.
    if (options_.output != "-" && !MayReplacePicture(place_, options_.force, findings_))
      return std::nullopt;
    const auto renderer = picture::Renderer::Open(findings_);
    if (!renderer) return std::nullopt;
    if (options_.sweep) return DrawSweep(*renderer, objects.front());
    return options_.count > 1 ? DrawSheet(*renderer, objects) : DrawOne(*renderer, objects.front());
  }

  void ChoosePlace(const std::string& name) {
    place_ = options_.output.empty() ? name + (options_.sweep ? ".gif" : ".png") : options_.output;
  }

  std::vector<PreviewObject> LoadFiles() {
    ChoosePlace(options_.what == "-" ? "stdin" : StemOf(options_.what));
    std::vector<PreviewObject> objects;
    for (const std::string& what : options_.whats) {
      // Loads the file with the validator first, which reports errors with their places in the
      // file.
      if (!validate::Loader().Load(what, console_.sources, findings_) || findings_.HasErrors())
        return {};
      std::string why_not;
      auto subject = picture::Loader().LoadFile(what, why_not);
      if (!subject) {
        findings_.Add(diag::Code::kMujocoError, {}, fmt::format("MuJoCo refused it: {}", why_not));
        return {};
      }
      objects.push_back({std::move(subject), {}});
      objects.back().record.name = StemOf(what);
    }
    return objects;
  }

  std::vector<PreviewObject> LoadVariants() {
    std::vector<PreviewObject> objects;
    recipe_ = LoadRecipe(options_.what, options_.spec, console_);
    if (!recipe_) return objects;
    ChoosePlace(recipe_->spec->name);
    picture_.view = ViewOf(*recipe_->spec, picture_.view);
    forge::Generator generator(*recipe_, console_.sources,
                               {.seed = options_.spec.seed,
                                .place_seed = options_.spec.place_seed,
                                .validation = forge::Validation::kNone});
    picture::Loader loader;
    forge::Variant variant;
    batch::FindingSummary found = VariantFindings();
    for (std::uint64_t i = 0; i < options_.count; ++i) {
      generator.Make(options_.first + i, variant);
      found.Add(variant.findings, false);
      if (!variant.ok()) continue;
      for (const bytes::Asset& asset : variant.document.assets) assets_.insert(asset.file.string());
      std::string why_not;
      auto subject = loader.LoadText(variant.document.text, variant.document.assets, why_not);
      if (subject) {
        objects.push_back({std::move(subject), variant.record});
      } else {
        found.Add(Explain(variant, why_not), false);
      }
    }
    findings_.Append(found.Findings());
    return objects;
  }

  // Returns the reason why MuJoCo rejects a variant, as findings at their places in the spec.
  diag::Findings Explain(const forge::Variant& variant, const std::string& why_not) const {
    diag::Findings found;
    validate::Loader().Validate(variant.document, *variant.object, found);
    if (!found.HasErrors())
      found.Add(diag::Code::kMujocoError, {}, fmt::format("MuJoCo refused it: {}", why_not));
    found.SetVariant(options_.spec.seed, variant.record.index);
    return found;
  }

  bool Pose(std::vector<PreviewObject>& objects) {
    diag::Findings of_views;
    diag::Findings again;  // dropped: repeats the findings of the first variant with any
    for (PreviewObject& object : objects) {
      if (recipe_ && !options_.sweep)
        SetPoseOf(*recipe_->spec, *object.subject, of_views.empty() ? of_views : again);
    }
    findings_.Append(std::move(of_views));
    bool is_moved = true;
    for (const JointPosition& position : options_.poses) is_moved &= MoveJoint(position, objects);
    return is_moved;
  }

  // Moves a joint of all objects to a position. Adds an error if no object's joint can be moved,
  // and a warning if only some can, because variants differ in their joints. Returns false after an
  // error.
  bool MoveJoint(const JointPosition& position, std::vector<PreviewObject>& objects) {
    diag::Findings found;
    bool is_moved = false;
    for (PreviewObject& object : objects) {
      const std::optional<int> joint = object.subject->FindJoint(position.name, found);
      is_moved |= joint &&
                  IsInUnitOf(object.subject->joints()[*joint], position.dimension, found) &&
                  object.subject->SetJoint(*joint, position.value, found);
    }
    if (found.empty()) return true;
    diag::Finding finding = found[0];
    if (is_moved) finding.severity = diag::Severity::kWarning;
    findings_.Add(std::move(finding));
    return is_moved;
  }

  std::optional<std::string> DrawOne(picture::Renderer& renderer, PreviewObject& object) {
    const auto image = renderer.Draw(*object.subject, picture_, findings_);
    if (!image) return std::nullopt;
    return picture::EncodePng(*image, TextsOf(object.record, ""));
  }

  std::optional<std::string> DrawSweep(picture::Renderer& renderer, PreviewObject& object) {
    constexpr int kDelay = 50;  // ms
    std::optional<int> joint;
    if (!options_.swept.empty()) {
      joint = object.subject->FindJoint(options_.swept, findings_);
      if (!joint) return std::nullopt;
    }
    const std::vector<picture::JointPositions> poses = object.subject->Sweep(joint, findings_);
    if (poses.empty()) return std::nullopt;
    const auto frames = renderer.DrawMotion(*object.subject, poses, picture_, findings_);
    if (!frames) return std::nullopt;
    return picture::EncodeGif(*frames, kDelay, TextsOf(object.record, ""));
  }

  std::optional<std::string> DrawSheet(picture::Renderer& renderer,
                                       std::vector<PreviewObject>& objects) {
    picture::Options tile = picture_;
    tile.background.transparent = true;
    std::vector<manifest::Record> records;
    std::vector<picture::Tile> tiles;
    batch::FindingSummary all = VariantFindings();
    for (PreviewObject& object : objects) {
      diag::Findings found;
      auto image = renderer.Draw(*object.subject, tile, found);
      if (recipe_) found.SetVariant(options_.spec.seed, object.record.index);
      all.Add(found, false);
      object.subject.reset();
      if (!image) continue;
      tiles.push_back({*std::move(image), {}});
      records.push_back(object.record);
    }
    findings_.Append(all.Findings());
    if (tiles.empty()) return std::nullopt;
    if (recipe_) {
      const auto captions = MakeCaptions(records, *recipe_->spec, tile.width);
      for (std::size_t i = 0; i < tiles.size(); ++i) tiles[i].caption = captions[i];
    } else {
      for (std::size_t i = 0; i < tiles.size(); ++i) tiles[i].caption = {records[i].name};
    }
    const picture::Image sheet = picture::ContactSheet(renderer, tiles, picture_.background);
    return picture::EncodePng(sheet, TextsOf(records.front(), fmt::format("+{}", options_.count)));
  }

  // Returns the metadata of the picture: spec, seed and index of the object, or its MJCF file.
  picture::Texts TextsOf(const manifest::Record& record, const std::string& count) const {
    const std::string places =
        record.place_seed ? fmt::format(" place-seed={}", *record.place_seed) : "";
    const std::string shown =
        recipe_ ? fmt::format("spec={} sha256={} seed={}{} index={}{}", record.spec,
                              record.spec_sha256, record.seed, places, record.index, count)
                : "file=" + std::filesystem::path(options_.what).filename().string();
    return {{"Software", fmt::format("mjforge {}", forge::Version())}, {"mjforge", shown}};
  }

  const PreviewOptions& options_;
  picture::Options picture_;  // options of the command line, completed by the spec's view
  Console& console_;
  diag::Findings& findings_;  // findings of the console
  std::optional<forge::Recipe> recipe_;
  std::filesystem::path place_;
  std::set<std::string> assets_;  // files that the variants refer to
};

ExitStatus DrawInChild(const PreviewOptions& options, Console& console,
                       std::FILE* files = nullptr) {
  return RunInChild(options.what, options.time_limit, console,
                    [&] { return Preview(options, console)(files); });
}

// Returns the files to watch that can be found without generating a variant: the MJCF files, or the
// files that are read to load the spec.
std::vector<std::filesystem::path> FilesOf(const PreviewOptions& options) {
  std::vector<std::filesystem::path> files(options.whats.begin(), options.whats.end());
  if (options.is_file) return files;
  Console silent{MessageOptions()};
  LoadRecipe(options.what, options.spec, silent);
  const std::set<std::string> names = NamesOf(silent.sources, silent.findings);
  files.insert(files.end(), names.begin(), names.end());
  return files;
}

// Returns the names that a child process wrote to `file`, each with a zero byte behind it.
std::vector<std::filesystem::path> ReadNames(std::FILE* file) {
  std::vector<std::filesystem::path> names;
  std::string name;
  std::rewind(file);
  for (int byte = std::getc(file); byte != EOF; byte = std::getc(file)) {
    if (byte != 0) {
      name += static_cast<char>(byte);
    } else if (!name.empty()) {
      names.emplace_back(std::exchange(name, {}));
    }
  }
  return names;
}

// Draws again after each change of a file, until a signal ends the process.
[[noreturn]] void Watch(const PreviewOptions& options, Console& console) {
  std::vector<std::filesystem::path> drawn;  // files that the last picture depends on
  while (true) {
    WatchedFiles files(FilesOf(options));
    for (const std::filesystem::path& file : drawn) files.Add(file);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> names(std::tmpfile(), std::fclose);
    const bool is_drawn = DrawInChild(options, console, names.get()) == ExitStatus::kDone;
    if (names) drawn = ReadNames(names.get());
    for (const std::filesystem::path& file : drawn) files.Add(file);
    console.PrintLine(fmt::format("mjforge: note: {}waiting for a change (Ctrl-C ends)",
                                  is_drawn ? "drawn; " : ""));
    files.Wait();
  }
}

}  // namespace

Action AddPreview(CLI::App& command) {
  auto options = std::make_shared<PreviewOptions>();
  AddPreviewOptions(command, *options);
  return [options](Console& console) {
    const std::string why_not = ResolvePreviewOptions(*options);
    if (!why_not.empty()) return WrongUsage(why_not, "preview");
    if (options->output == "-" && ::isatty(STDOUT_FILENO) != 0)
      return WrongUsage("-o -: a terminal cannot show a picture", "preview");
    if (options->watch) Watch(*options, console);
    return DrawInChild(*options, console);
  };
}

}  // namespace mjforge::app
