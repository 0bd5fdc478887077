#include "preview_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "mjforge/expr/expr.h"

namespace mjforge::app {
namespace {

constexpr int kSizeOfOne = 640;
constexpr int kSizeOfTile = 320;  // and of an animation
// What is in memory at the same time: frames, and the tiles of a sheet.
constexpr int kLargestFrame = 800;
constexpr std::uint64_t kMostPixels = 64'000'000;

// "640", "640x480"
std::optional<std::pair<int, int>> ParseSize(std::string_view text) {
  const std::size_t cross = text.find('x');
  const std::optional<std::uint64_t> width = ParseWhole(text.substr(0, cross));
  const std::optional<std::uint64_t> height =
      cross == text.npos ? width : ParseWhole(text.substr(cross + 1));
  const auto fits = [](std::uint64_t side) {
    return side >= picture::kMinSize && side <= picture::kMaxSize;
  };
  if (!width || !height || !fits(*width) || !fits(*height)) return std::nullopt;
  return std::pair(static_cast<int>(*width), static_cast<int>(*height));
}

// "hinge=45deg"
std::optional<std::pair<std::string, double>> ParseJoint(std::string_view text,
                                                         std::string& why_not) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0) {
    why_not = fmt::format("--joint: '{}' is not of the form NAME=VALUE", text);
    return std::nullopt;
  }
  expr::Error error;
  const auto value = expr::Expression::Compile(text.substr(equals + 1), expr::Names(), error);
  if (!value || !value->constant() || value->type() != expr::Type::kNumber ||
      !std::isfinite(*value->constant())) {
    why_not = fmt::format("--joint {}: {}", text, value ? "it is not a number" : error.message);
    return std::nullopt;
  }
  return std::pair(std::string(text.substr(0, equals)), *value->constant());
}

std::string CheckBackground(const std::string& text) {
  if (picture::ParseBackground(text)) return {};
  return fmt::format("'{}' is not one of studio, transparent, white, gray, black, #rrggbb", text);
}

// The file's name says what is in it.
std::string WrongName(const PreviewOptions& options) {
  const std::string ending = std::filesystem::path(options.output).extension().string();
  if (options.output == "-" || ending.empty() || ending == ".png") return {};
  if (ending == ".gif" || ending == ".apng") {
    if (options.sweep) return {};
    return fmt::format("-o {}: a picture is a .png; {} is for --sweep", options.output, ending);
  }
  return fmt::format("-o {}: pictures are .png, with --sweep also .apng and .gif", options.output);
}

std::string TooLarge(const PreviewOptions& options, const picture::Options& picture) {
  const auto pixels = options.count * static_cast<std::uint64_t>(picture.width) *
                      static_cast<std::uint64_t>(picture.height);
  if (options.count > 1 && pixels > kMostPixels)
    return fmt::format("--size {}: {} pictures of that size are too large for one sheet",
                       options.size, options.count);
  if (options.sweep && std::max(picture.width, picture.height) > kLargestFrame)
    return fmt::format("--size {}: with --sweep at most {} pixels a side", options.size,
                       kLargestFrame);
  return {};
}

std::string Contradiction(const PreviewOptions& options) {
  if (options.count == 0) return "-n 0: there is nothing to draw";
  if (options.count > kMostTiles)
    return fmt::format("-n {}: a sheet holds at most {} variants", options.count, kMostTiles);
  if (options.sweep && options.count > 1) return "--sweep takes one object, not a sheet";
  if (std::string wrong = WrongName(options); !wrong.empty()) return wrong;
  if (!options.is_file()) return {};
  if (options.count > 1 || options.first > 0)
    return fmt::format("'{}' is one object: -n and --first take a spec", options.what);
  if (!options.spec.settings.empty() || !options.spec.parameter_files.empty())
    return fmt::format("'{}' has no parameters: --set, --root and --params take a spec",
                       options.what);
  return {};
}

}  // namespace

void AddPreviewOptions(CLI::App& command, PreviewOptions& options) {
  command.add_option("WHAT", options.what, "A spec or a FILE.xml")->required()->option_text(" ");
  AddWholeNumber(command, "-n,--count", options.count, "Variants; several make a contact sheet", 1);
  AddWholeNumber(command, "-s,--seed", options.seed, "Seed of all draws");
  AddWholeNumber(command, "--first", options.first, "Index of the first variant");
  command.add_option("-o,--output", options.output, "A file [./NAME.png] or - for standard output")
      ->option_text("OUT");
  const std::vector<std::string> layers(picture::LayerNames().begin(), picture::LayerNames().end());
  AddWord(command, "--layer", options.layer, layers, "Show");
  command.add_option("--joint", options.joints, "Where a joint stands (hinge=45deg)")
      ->option_text("NAME=VALUE")
      ->allow_extra_args(false);
  command.add_option("--size", options.size, "Pixels [640; of each of several, moving 320]")
      ->option_text("WxH");
  command
      .add_option("--background", options.background,
                  "studio, transparent, white, gray, black, #rrggbb")
      ->check(CheckBackground)
      ->option_text("COLOR [studio]");
  command.add_flag("--sweep", options.sweep, "Animate all joints, or --joint NAME");
  command.add_flag("--force", options.force, "Overwrite a file that mjforge did not make");
  AddSpecOptions(command, options.spec);
  AddReportOptions(command, options.report);
}

std::optional<PreviewRequest> RequestOf(const PreviewOptions& options, std::string& why_not) {
  why_not = Contradiction(options);
  if (!why_not.empty()) return std::nullopt;
  PreviewRequest request;
  request.picture.width = request.picture.height =
      options.count > 1 || options.sweep ? kSizeOfTile : kSizeOfOne;
  if (!options.size.empty()) {
    const auto size = ParseSize(options.size);
    if (!size) {
      why_not = fmt::format("--size: '{}' is not of the form WxH, each {} to {}", options.size,
                            picture::kMinSize, picture::kMaxSize);
      return std::nullopt;
    }
    request.picture.width = size->first;
    request.picture.height = size->second;
  }
  why_not = TooLarge(options, request.picture);
  if (!why_not.empty()) return std::nullopt;
  request.picture.layer = *picture::ParseLayer(options.layer);
  request.picture.background = *picture::ParseBackground(options.background);
  for (const std::string& text : options.joints) {
    if (options.sweep && text.find('=') == text.npos) {
      if (!request.swept.empty()) {
        why_not =
            fmt::format("--sweep moves one joint, or all: '{}' or '{}'?", request.swept, text);
        return std::nullopt;
      }
      request.swept = text;
      continue;
    }
    const auto joint = ParseJoint(text, why_not);
    if (!joint) return std::nullopt;
    request.joints.push_back(*joint);
  }
  return request;
}

}  // namespace mjforge::app
