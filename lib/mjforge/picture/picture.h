#pragma once

// Models -> pictures, by MuJoCo's own renderer, without a display.
//
//   auto renderer = picture::Renderer::Open(findings);
//   picture::Loader loader;
//   std::string why_not;
//   auto subject = loader.LoadFile("hammer.xml", why_not);
//   auto image = renderer->Draw(*subject, {.width = 640, .height = 640}, findings);
//   std::string png = picture::EncodePng(*image, {});

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

namespace mjforge::picture {

/// Rows from the top, four bytes per pixel: red, green, blue, and alpha; colors are not
/// premultiplied.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// What is shown of a model.
enum class Layer {
  kVisual,     // what a viewer shows at its defaults: groups 0 to 2
  kCollision,  // the geoms that can collide, each in a color of its own
  kBounds,     // the box around them, top, bottom and horizontal radius
  kInertia,    // boxes of the same inertia as the bodies, and their centres of mass
  kJoints      // axes, ranges and names
};
/// In the order of the enumeration.
std::span<const std::string_view> LayerNames();
std::optional<Layer> ParseLayer(std::string_view name);

/// A gradient from top to bottom, or nothing at all.
struct Background {
  using Color = std::array<std::uint8_t, 3>;
  Color top = {250, 251, 252};
  Color bottom = {221, 225, 230};
  bool transparent = false;
};
/// "studio" (the default), "transparent", "white", "black", "gray", "#rrggbb".
std::optional<Background> ParseBackground(std::string_view text);
/// The image with the background behind it.
void PutOn(const Background& background, Image& image);

/// Sizes of pictures, in pixels.
inline constexpr int kMinSize = 16;
inline constexpr int kMaxSize = 4096;

/// Where the camera is, in the terms of MuJoCo's mjvCamera. The defaults: from the front, right and
/// above, as close as everything shown still fits.
struct View {
  std::optional<double> azimuth;    // deg, of the direction it looks in; 0: x, 90: y
  std::optional<double> elevation;  // deg, of the same; -90: down, 90: up
  std::optional<double> distance;   // m, from the middle of what is shown
};

struct Options {
  int width = 640;
  int height = 640;
  Layer layer = Layer::kVisual;
  Background background = {};
  View view = {};
};

/// A joint of a subject and its position; rad for hinges, m for slides.
struct Joint {
  enum class Type { kFree, kBall, kSlide, kHinge };
  std::string name;
  Type type = Type::kHinge;
  bool limited = false;
  std::array<double, 2> range = {0, 0};
  double value = 0;  // of hinges and slides
};

/// Positions of some joints: the joint's number, and rad or m.
using Pose = std::vector<std::pair<int, double>>;

/// A model in a pose.
class Subject {
 public:
  struct State;
  explicit Subject(std::unique_ptr<State> state);
  ~Subject();

  std::vector<Joint> joints() const;
  /// The joint's number; a name's prefix ("hammer_") may be left out if only one joint fits.
  /// Nothing, and a finding, if there is none.
  std::optional<int> FindJoint(std::string_view name, diag::Findings& findings) const;
  /// Moves a hinge (rad) or slide (m). A finding if it is neither, or the value
  /// is outside its range.
  bool SetJoint(int joint, double value, diag::Findings& findings);

  /// Moves each hinge and slide, one after the other, or only `joint`, from its value to the ends
  /// of its range and back; hinges without limits turn once around. Nothing, and a finding, if none
  /// can move this way.
  std::vector<Pose> Sweep(std::optional<int> joint, diag::Findings& findings) const;

  State& state() { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

/// Reads models. Keeps files it has read; one for all variants of a batch.
class Loader {
 public:
  Loader();
  ~Loader();
  /// A text, and the files it refers to by these names. Nothing, and why, if MuJoCo refuses it;
  /// MuJoCo's warnings are ignored.
  std::unique_ptr<Subject> LoadText(const std::string& mjcf, const bytes::Assets& assets,
                                    std::string& why_not);
  std::unique_ptr<Subject> LoadFile(const std::filesystem::path& file, std::string& why_not);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Draws without a display: through EGL, else OSMesa, whichever is found at run time. The
/// environment's MUJOCO_GL chooses one ("egl", "osmesa") or none ("disable", "off"). Only one at a
/// time in a process, and always through the same library: MuJoCo looks for OpenGL's functions
/// once.
class Renderer {
 public:
  /// Nothing, and a finding, if neither works.
  static std::unique_ptr<Renderer> Open(diag::Findings& findings);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Seen as the options' view says, on a floor, unless the model has planes of its own. A warning
  /// if the layer is empty and something else is shown; nothing, and a finding, if there is nothing
  /// to show at all. The same subject and options give the same bytes.
  std::optional<Image> Draw(Subject& subject, const Options& options, diag::Findings& findings);

  /// The same for each pose, all seen from one place that suits them all.
  std::optional<std::vector<Image>> DrawMotion(Subject& subject, std::span<const Pose> poses,
                                               const Options& options, diag::Findings& findings);

  /// "EGL" or "OSMesa".
  std::string_view backend() const;
  /// One line of text; alpha only, in the given color.
  Image DrawText(std::string_view text, const Background::Color& color);

 private:
  struct State;
  explicit Renderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// A picture of a contact sheet and the lines below it.
struct Tile {
  Image image;
  std::vector<std::string> caption;
};
/// Tiles of one size in rows, as square as their number allows.
Image ContactSheet(Renderer& renderer, std::span<const Tile> tiles, const Background& background);

/// Keys and values of the texts in a picture's file.
using Texts = std::vector<std::pair<std::string, std::string>>;
std::string EncodePng(const Image& image, const Texts& texts);
/// An endless animation in 255 colors; a pixel is either opaque or transparent. Each frame is shown
/// for `delay` ms, rounded down to 10 ms.
std::string EncodeGif(std::span<const Image> frames, int delay, const Texts& texts);
/// Lossy; quality from 0 to 100.
std::string EncodeWebp(const Image& image, int quality);

}  // namespace mjforge::picture
