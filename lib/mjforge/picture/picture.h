// Pictures of MuJoCo models, rendered by MuJoCo without a display.
//
//   auto renderer = picture::Renderer::Open(findings);
//   picture::Loader loader;
//   std::string why_not;
//   auto subject = loader.LoadFile("hammer.xml", why_not);
//   auto image = renderer->Draw(*subject, {.width = 640, .height = 640}, findings);
//   std::string png = picture::EncodePng(*image, {});

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/picture/image.h"

namespace mjforge::picture {

/// Parts of a model that a picture shows.
enum class Layer {
  kVisual,     // geoms of the groups 0 to 2, which a viewer shows by default
  kCollision,  // geoms that can collide, each in a different color
  kBounds,     // bounding box of the colliding geoms; top, bottom and horizontal radius
  kInertia,    // boxes with the same inertia as the bodies, and their centres of mass
  kJoints,     // axes, ranges and names of the joints
  kRegions     // areas on which other objects can stand: box and cylinder sites of group 5
};
/// Names of the layers, in the order of the enumeration.
std::span<const std::string_view> LayerNames();
std::optional<Layer> ParseLayer(std::string_view name);

/// A vertical gradient, or no background at all.
struct Background {
  using Color = std::array<std::uint8_t, 3>;
  Color top = {250, 251, 252};
  Color bottom = {221, 225, 230};
  bool transparent = false;
};
/// Reads "studio" (the default), "transparent", "white", "black", "gray" or "#rrggbb".
std::optional<Background> ParseBackground(std::string_view text);
/// Puts the background behind the image.
void PutBehind(const Background& background, Image& image);

/// Limits of the width and the height of a picture, in pixels.
inline constexpr int kMinSize = 16;
inline constexpr int kMaxSize = 4096;

/// Position of the camera, in the terms of MuJoCo's mjvCamera. The default camera looks from the
/// front, right and above, and is as close as possible with all shapes in the picture.
struct View {
  std::optional<double> azimuth;    // deg, viewing direction about z; 0: along x, 90: along y
  std::optional<double> elevation;  // deg, viewing direction; -90: down, 90: up
  std::optional<double> distance;   // m, from the eye to the center of the shown shapes
  double zoom = 1;                  // divides the distance at which all shapes are in the picture
};

struct Options {
  int width = 640;
  int height = 640;
  Layer layer = Layer::kVisual;
  Background background = {};
  View view = {};
  /// Draws faster, without shadows and with one sample per pixel: for pictures that are soon
  /// replaced by better pictures.
  bool quick = false;
};

/// A joint of a subject and its position; rad for hinges, m for slides.
struct Joint {
  enum class Type { kFree, kBall, kSlide, kHinge };
  std::string name;
  Type type = Type::kHinge;
  bool limited = false;
  std::array<double, 2> range = {0, 0};
  double value = 0;  // position of a hinge or slide

  /// Returns true for joints whose position is one number: hinges and slides.
  bool IsMovable() const { return type == Type::kHinge || type == Type::kSlide; }
};

/// Positions of some joints: pairs of a joint's number (MuJoCo's id) and its position (rad or m).
using JointPositions = std::vector<std::pair<int, double>>;

/// Poses of a model: its start pose, and the start pose with hinges, slides and balls at zero.
enum class Pose { kStart, kZero };

/// A model to be drawn, and its current pose, which is Pose::kStart at first.
class Subject {
 public:
  struct State;
  explicit Subject(std::unique_ptr<State> state);
  ~Subject();

  void Reset(Pose pose);

  std::vector<Joint> joints() const;
  /// Returns the number (MuJoCo's id) of the joint with this name. The name's prefix ("hammer_")
  /// may be left out if only one joint fits. Returns nullopt, and adds a finding, if no joint or
  /// several joints fit.
  std::optional<int> FindJoint(std::string_view name, diag::Findings& findings) const;
  /// Moves a hinge (rad) or slide (m). Returns false, and adds a finding, if the joint is neither a
  /// hinge nor a slide, or if the value is outside its range.
  bool SetJoint(int joint, double value, diag::Findings& findings);

  /// Returns poses that move each hinge and slide in turn, or only `joint`, from its value to both
  /// ends of its range and back. Hinges without limits make a full turn. Returns an empty list, and
  /// adds a finding, if no joint can move in this way.
  std::vector<JointPositions> Sweep(std::optional<int> joint, diag::Findings& findings) const;

  State& state() { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

/// Reads models, and caches the files that they refer to. Use one loader for all variants of a
/// batch.
class Loader {
 public:
  Loader();
  ~Loader();
  /// Loads an MJCF text that refers to `assets` by their names, or an MJCF file. Returns null, and
  /// sets `why_not`, if the model cannot be loaded. Ignores MuJoCo's warnings.
  std::unique_ptr<Subject> LoadText(const std::string& mjcf, const bytes::Assets& assets,
                                    std::string& why_not);
  std::unique_ptr<Subject> LoadFile(const std::filesystem::path& file, std::string& why_not);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Renders without a display, through EGL or else through OSMesa, which are loaded at run time.
/// The environment variable MUJOCO_GL chooses a library ("egl", "osmesa") or turns rendering off
/// ("disable", "off"). A process has at most one renderer at a time, and always uses the same
/// library, because MuJoCo looks up OpenGL's functions only once.
class Renderer {
 public:
  /// Makes the renderer. Returns null, and adds a finding, if neither library works.
  static std::unique_ptr<Renderer> Open(diag::Findings& findings);
  ~Renderer();

  /// Draws a subject, on a floor unless the model has a plane, a height field or other geoms fixed
  /// to the world. If nothing is visible, shows geoms of other groups or else sites, and adds a
  /// warning. Returns nullopt, and adds a finding, if there is nothing to show. Equal subjects and
  /// options give equal bytes.
  std::optional<Image> Draw(Subject& subject, const Options& options, diag::Findings& findings);

  using Images = std::optional<std::vector<Image>>;
  /// Draws the subject in each pose, with one camera that frames the subject in all poses.
  Images DrawMotion(Subject& subject, std::span<const JointPositions> poses, const Options& options,
                    diag::Findings& findings);

  /// Draws the subject at each of these `positions` (MuJoCo's qpos), with one camera for all
  /// images.
  Images DrawFilm(Subject& subject, std::span<const std::vector<double>> positions,
                  const Options& options, diag::Findings& findings);

  /// Draws a line of text in the given color, on a transparent background.
  Image DrawText(std::string_view text, const Background::Color& color);

 private:
  struct State;
  explicit Renderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Returns the name of the geom that Renderer::Draw() shows at a point of the picture with
/// Layer::kVisual; empty if there is no geom or the geom has no name. `x` is 0 at the left edge and
/// 1 at the right edge; `y` is 0 at the top and 1 at the bottom.
std::string GeomAt(Subject& subject, const Options& options, double x, double y);

/// An image in a contact sheet, and the lines of text below it.
struct Tile {
  Image image;
  std::vector<std::string> caption;
};
/// Arranges tiles of equal size in a nearly square sheet with few empty places. Crops each row of
/// tiles at the top and the bottom: omits rows of pixels that are transparent in all of its tiles.
Image ContactSheet(Renderer& renderer, std::span<const Tile> tiles, const Background& background);

}  // namespace mjforge::picture
