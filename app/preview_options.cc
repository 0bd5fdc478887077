// Options of `mjforge preview`: declaration, conversion and checks.
#include "preview_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <tuple>

#include "completion.h"
#include "mjforge/expr/expr.h"

namespace mjforge::app {
namespace {

constexpr std::array<std::string_view, 5> kBackgrounds = {"studio", "transparent", "white", "gray",
                                                          "black"};
constexpr int kSizeOfOne = 640;
constexpr int kSizeOfTile = 320;  // also the size of the frames of an animation
// Limits of memory: all frames of an animation, or all tiles of a sheet, are in memory together.
constexpr int kMaxFrameSize = 800;
constexpr std::uint64_t kMaxPixels = 64'000'000;
constexpr std::uint64_t kMaxTiles = 400;

// Parses a size in pixels: "640" (a square) or "640x480".
std::optional<std::pair<int, int>> ParseSize(std::string_view text) {
  const std::size_t cross = text.find('x');
  const std::optional<std::uint64_t> width = output::ReadIndex(text.substr(0, cross));
  const std::optional<std::uint64_t> height =
      cross == text.npos ? width : output::ReadIndex(text.substr(cross + 1));
  const auto fits = [](std::uint64_t side) {
    return side >= picture::kMinSize && side <= picture::kMaxSize;
  };
  if (!width || !height || !fits(*width) || !fits(*height)) return std::nullopt;
  return std::pair(static_cast<int>(*width), static_cast<int>(*height));
}

// Parses a joint and its position: "hinge=45deg".
std::optional<JointPosition> ParseJoint(std::string_view text, std::string& why_not) {
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0)
    return diag::Refuse(why_not, fmt::format("--joint: '{}' is not of the form NAME=VALUE", text));
  expr::Error error;
  const auto value = expr::Expression::Compile(text.substr(equals + 1), expr::SymbolTable(), error);
  if (!value || !value->constant() || value->type() != expr::Type::kNumber ||
      !std::isfinite(*value->constant()))
    return diag::Refuse(
        why_not, fmt::format("--joint {}: {}", text, value ? "it is not a number" : error.message));
  return JointPosition{std::string(text.substr(0, equals)), *value->constant(), value->dimension()};
}

std::string CheckBackground(const std::string& text) {
  if (picture::ParseBackground(text)) return {};
  return fmt::format("'{}' is not one of studio, transparent, white, gray, black, #rrggbb", text);
}

// Returns the error message for a file name whose ending does not match the picture's format; empty
// if the ending matches.
std::string CheckFileName(const PreviewOptions& options) {
  const std::string ending = std::filesystem::path(options.output).extension().string();
  if (options.output == "-" || ending.empty() || ending == (options.sweep ? ".gif" : ".png"))
    return {};
  return fmt::format("-o {}: a picture is a .png, and with --sweep a .gif", options.output);
}

std::string CheckPixels(const PreviewOptions& options) {
  const picture::Options& picture = options.picture;
  const auto pixels = options.count * static_cast<std::uint64_t>(picture.width) *
                      static_cast<std::uint64_t>(picture.height);
  if (options.count > 1 && pixels > kMaxPixels)
    return fmt::format("--size {}: {} pictures of that size are too large for one sheet",
                       options.size, options.count);
  if (options.sweep && std::max(picture.width, picture.height) > kMaxFrameSize)
    return fmt::format("--size {}: with --sweep at most {} pixels a side", options.size,
                       kMaxFrameSize);
  return {};
}

// Returns the error message for the first argument WHAT that does not name an MJCF file; empty if
// all do. Standard input ("-") does not count as a file here.
std::string FindNoFile(const std::vector<std::string>& whats) {
  for (const std::string& what : whats) {
    if (what == "-" || !IsMjcf(what))
      return fmt::format("'{}' is not a FILE.xml: only files can be several", what);
  }
  return {};
}

std::string FindConflict(const PreviewOptions& options) {
  if (options.count > kMaxTiles)
    return fmt::format("-n {}: a sheet holds at most {} variants", options.count, kMaxTiles);
  if (options.watch && (options.what == "-" || options.output == "-"))
    return "--watch takes files, not standard input or output";
  if (options.sweep && options.count > 1) return "--sweep takes one object, not a sheet";
  if (std::string wrong = CheckFileName(options); !wrong.empty()) return wrong;
  if (options.whats.size() > 1) return FindNoFile(options.whats);
  if (!options.is_file) return {};
  return RefuseSpecOptions(options.what, options.spec, options.count > 1 || options.first > 0,
                           "-n, --first");
}

// Sets the size of the picture, or the default size. Returns an error message, or an empty text.
std::string SetSize(PreviewOptions& options) {
  const int usual = options.count > 1 || options.sweep ? kSizeOfTile : kSizeOfOne;
  const auto size = options.size.empty() ? std::pair(usual, usual) : ParseSize(options.size);
  if (!size) {
    return fmt::format("--size: '{}' is not of the form WxH, each {} to {}", options.size,
                       picture::kMinSize, picture::kMaxSize);
  }
  std::tie(options.picture.width, options.picture.height) = *size;
  return CheckPixels(options);
}

// Sets the positions of joints; with --sweep, a name without position is the joint to sweep.
// Returns an error message, or an empty text.
std::string SetJoints(PreviewOptions& options) {
  std::string why_not;
  for (const std::string& text : options.joints) {
    if (!options.sweep || text.find('=') != text.npos) {
      const auto joint = ParseJoint(text, why_not);
      if (!joint) return why_not;
      options.poses.push_back(*joint);
    } else if (options.swept.empty()) {
      options.swept = text;
    } else {
      return fmt::format("--sweep moves one joint, or all: '{}' or '{}'?", options.swept, text);
    }
  }
  return {};
}

void AddCamera(CLI::App& command, picture::View& view) {
  const auto add = [&](const char* name, std::optional<double>& value, double least, double most,
                       const char* what, const char* doc) {
    AddNumber(
        command, name, [&value](double number) { value = number; }, least, most, what, doc);
  };
  add("--azimuth", view.azimuth, -360, 360, "an angle from -360 to 360 degrees",
      "Camera's direction about z, degrees");
  add("--elevation", view.elevation, -90, 90, "an angle from -90 to 90 degrees",
      "Camera's tilt, degrees; -90 is from above");
  add("--distance", view.distance, 1e-9, 1e9, "a distance above 0 in metres",
      "Camera's distance from the middle, m [as fits]");
}

}  // namespace

void AddPreviewOptions(CLI::App& command, PreviewOptions& options) {
  AddArguments(command, "WHAT", options.whats,
               "A spec or a FILE.xml; several files make a contact sheet",
               std::string(kSpecs) + " .xml");
  AddWholeNumber(command, "-n,--count", options.count, "Variants; several make a contact sheet", 1);
  AddWholeNumber(command, "--first", options.first, "Index of the first variant");
  AddSpecOptions(command, options.spec);
  command
      .add_option("-o,--output", options.output,
                  "A file [./NAME.png; --sweep: ./NAME.gif] or - for standard output")
      ->option_text("OUT")
      ->check(Offers(".png .gif"));
  AddWord(command, "--layer", options.layer, picture::LayerNames(), "Show");
  command.add_option("--joint", options.joints, "Set a joint's position (hinge=45deg)")
      ->option_text("NAME=VALUE")
      ->allow_extra_args(false)
      ->check(Offers("<joint>"));
  AddCamera(command, options.picture.view);
  command.add_option("--size", options.size, "Pixels [640; several or --sweep: 320 each]")
      ->option_text("WxH");
  command
      .add_option("--background", options.background,
                  fmt::format("{}, #rrggbb", fmt::join(kBackgrounds, ", ")))
      ->check(CheckBackground)
      ->check(Offers(fmt::format("{}", fmt::join(kBackgrounds, " "))))
      ->option_text("COLOR [studio]");
  command.add_flag("--sweep", options.sweep, "Animate all joints, or --joint NAME");
  command.add_flag("--watch", options.watch, "Draw again when the spec or an import is saved");
  AddTimeLimit(command, options.time_limit);
  command.add_flag("--force", options.force, "Overwrite a file that mjforge did not make");
}

std::string ResolvePreviewOptions(PreviewOptions& options) {
  options.what = options.whats.front();
  options.is_file = IsMjcf(options.what);
  const bool several = options.whats.size() > 1;
  if (several && (options.count > 1 || options.first > 0))
    return "-n and --first take a spec, not several files";
  if (several) options.count = options.whats.size();
  options.picture.layer = *picture::ParseLayer(options.layer);
  options.picture.background = *picture::ParseBackground(options.background);
  std::string why_not = FindConflict(options);
  if (why_not.empty()) why_not = SetSize(options);
  return why_not.empty() ? SetJoints(options) : why_not;
}

}  // namespace mjforge::app
