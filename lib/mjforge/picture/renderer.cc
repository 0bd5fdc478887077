// Renderer: draws a subject with MuJoCo in bands of rows, and adds background, labels and legend.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <optional>

#include "mjforge/picture/font.h"
#include "mjforge/picture/gl_context.h"
#include "mjforge/picture/matte.h"
#include "mjforge/picture/model_context.h"
#include "mjforge/picture/scene.h"
#include "mjforge/picture/sheet.h"
#include "mjforge/picture/subject.h"

namespace mjforge::picture {
namespace {

using diag::Code;

// Returns the width of the shadow map: two texels per pixel of the picture, within limits.
int ShadowSize(int width, int height) { return std::clamp(2 * std::max(width, height), 512, 4096); }

// Largest number of samples that are rendered at once. Pictures with more samples are drawn in
// horizontal bands, to limit the size of the framebuffer.
constexpr int kMostSamples = 1 << 22;
// Least number of samples along each side of a pixel, unless Options::quick is set.
constexpr int kFewestSamples = 2;

// Returns the number of samples along each side of a pixel: 1 if Options::quick is set, otherwise
// as many as possible without dividing the picture into bands, at least kFewestSamples. At most
// four, which suffice for smooth edges, or three if there are translucent geoms, because these are
// rendered twice.
int SamplesOf(const Options& options, bool is_opaque) {
  if (options.quick) return 1;
  const double most = std::sqrt(kMostSamples / (double{1} * options.width * options.height));
  return std::clamp(static_cast<int>(most), kFewestSamples, is_opaque ? 4 : 3);
}

int RowsOfBand(const Options& options, int samples) {
  return std::clamp(kMostSamples / (samples * samples * options.width), 1, options.height);
}

// Renders the scene, and reads its colors and, if `depths` is not null, its depths.
void Render(const mjrContext& context, mjvScene& scene, const mjrRect& viewport,
            std::vector<std::uint8_t>& colors, std::vector<float>* depths) {
  const std::size_t samples =
      static_cast<std::size_t>(viewport.width) * static_cast<std::size_t>(viewport.height);
  colors.resize(3 * samples);
  if (depths != nullptr) depths->resize(samples);
  const LeakCheckPause pause;
  mjr_render(viewport, &scene, &context);
  mjr_readPixels(colors.data(), depths == nullptr ? nullptr : depths->data(), viewport, &context);
}

}  // namespace

struct Renderer::State {
  std::unique_ptr<GlContext> gl;  // before `font` and `buffers`, which are freed first
  std::optional<Font> font;
  RenderContext buffers;
  std::array<int, 3> buffer_sizes = {};  // width, height and size of the shadow map of `buffers`
  std::vector<std::uint8_t> colors;
  std::vector<std::uint8_t> translucent;
  std::vector<float> depths;
  int samples = kFewestSamples;  // number along each side of a pixel of the current picture

  const mjrContext& BuffersFor(const Options& options);
  Image DrawScene(ModelContext& context, Scene& scene, const Camera& camera,
                  const Options& options);
  void DrawLabels(const Scene& scene, const Camera& camera, int height, Image& image);
  std::vector<PlacedText> DrawLegend(const Scene& scene, const Options& options);
  template <typename Positions>
  Images DrawPoses(Subject& subject, std::span<const Positions> poses, const Options& options,
                   diag::Findings& findings);
  template <typename Positions>
  Images TryToDraw(Subject& subject, std::span<const Positions> poses, const Options& options,
                   diag::Findings& findings);
};

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}

Renderer::~Renderer() = default;

std::unique_ptr<Renderer> Renderer::Open(diag::Findings& findings) {
  auto state = std::make_unique<State>();
  std::string why_not;
  state->gl = OpenGlContext(why_not);
  try {
    if (state->gl) state->font.emplace();
  } catch (const std::exception& error) {
    why_not = fmt::format("{}: {}", state->gl->name(), engine::OneLine(error.what()));
  }
  if (!state->font) {
    findings.Add(Code::kPictureNoRenderer, {}, fmt::format("cannot draw: {}", why_not),
                 "install libegl1 with a driver (libgl1-mesa-dri), or libosmesa6");
    return nullptr;
  }
  return std::unique_ptr<Renderer>(new Renderer(std::move(state)));
}

Image Renderer::DrawText(std::string_view text, const Background::Color& color) {
  return state_->font->Draw(text, color);
}

// Returns buffers of the size that the picture needs; reuses the buffers of the last picture if
// they have this size.
const mjrContext& Renderer::State::BuffersFor(const Options& options) {
  const std::array sizes = {options.width * samples, RowsOfBand(options, samples) * samples,
                            options.quick ? 0 : ShadowSize(options.width, options.height)};
  if (!buffers || buffer_sizes != sizes) {
    buffers.reset();
    buffers = MakeBuffers(sizes[0], sizes[1], sizes[2], mjFONTSCALE_50);
    buffer_sizes = sizes;
  }
  return *buffers;
}

Image Renderer::State::DrawScene(ModelContext& context, Scene& scene, const Camera& camera,
                                 const Options& options) {
  const int band = RowsOfBand(options, samples);
  (*context).shadowClip = static_cast<float>(1.05 * camera.radius);
  LevelDepth floor;
  if (const auto level = scene.level_above_floor())
    floor = DepthOfLevel(camera, *level, options.width, options.height);
  const double backdrop = scene.IsOpaque() ? 1 : DepthBeforeBackdrop(camera);
  translucent.clear();
  Matte matte(options.width, options.height, samples);
  for (int top = 0; top < options.height; top += band) {
    const int bottom = std::min(top + band, options.height);
    const mjrRect viewport = {0, 0, options.width * samples, (bottom - top) * samples};
    scene.SetCamera(BandOf(camera, top, bottom, options.height));
    Render(*context, scene.mujoco(), viewport, colors, &depths);
    if (!scene.IsOpaque()) {
      mjvScene geoms = scene.TranslucentGeoms();
      Render(*context, geoms, viewport, translucent, nullptr);
    }
    matte.Add({colors, depths, translucent, floor, backdrop, scene.Brightness()}, top, bottom);
  }
  return matte.Finish();
}

// Draws labels into the upper `height` rows, which show the scene.
void Renderer::State::DrawLabels(const Scene& scene, const Camera& camera, int height,
                                 Image& image) {
  constexpr int kAside = 8;  // pixels between a point and its label
  std::vector<PlacedText> labels;
  for (const Scene::Label& label : scene.labels()) {
    const Eigen::Vector2d place = camera.Project(label.p_W, image.width, height);
    PlacedText text{font->Draw(label.text, {30, 34, 42}), 0, 0};
    text.x = static_cast<int>(std::lround(place.x())) + kAside;
    text.y = static_cast<int>(std::lround(place.y())) - text.text.height / 2;
    labels.push_back(std::move(text));
  }
  PutLabels(std::move(labels), image);
}

// Returns the texts of the legend, arranged in rows that take at most a third of the picture's
// height. Coordinates are relative to the top left of the legend.
std::vector<PlacedText> Renderer::State::DrawLegend(const Scene& scene, const Options& options) {
  constexpr int kGap = 10;  // pixels
  std::vector<PlacedText> texts;
  int x = kGap;
  int y = 0;
  for (const Scene::Line& line : scene.legend()) {
    Background::Color color;
    for (std::size_t i = 0; i < 3; ++i)
      color[i] = static_cast<std::uint8_t>(std::lround(255 * line.color[i]));
    Image text = font->Draw(line.text, color);
    if (x > kGap && x + text.width > options.width) {
      x = kGap;
      y += text.height;
    }
    if (y + text.height > options.height / 3) {
      if (texts.empty()) break;
      const std::size_t more = scene.legend().size() - texts.size() + 1;
      texts.back().text = font->Draw(fmt::format("and {} more", more), color);
      break;
    }
    const int width = text.width;
    texts.push_back({std::move(text), x, y});
    x += width + kGap;
  }
  return texts;
}

std::optional<Image> Renderer::Draw(Subject& subject, const Options& options,
                                    diag::Findings& findings) {
  const JointPositions as_it_is;
  auto images = DrawMotion(subject, {&as_it_is, 1}, options, findings);
  if (!images) return std::nullopt;
  return std::move(images->front());
}

Renderer::Images Renderer::DrawMotion(Subject& subject, std::span<const JointPositions> poses,
                                      const Options& options, diag::Findings& findings) {
  return state_->TryToDraw(subject, poses, options, findings);
}

Renderer::Images Renderer::DrawFilm(Subject& subject,
                                    std::span<const std::vector<double>> positions,
                                    const Options& options, diag::Findings& findings) {
  return state_->TryToDraw(subject, positions, options, findings);
}

template <typename Positions>
Renderer::Images Renderer::State::TryToDraw(Subject& subject, std::span<const Positions> poses,
                                            const Options& options, diag::Findings& findings) {
  Images images;
  const std::optional<std::string> failure =
      engine::FailureOf([&] { images = DrawPoses(subject, poses, options, findings); });
  if (failure) {
    findings.Add(Code::kPictureNoRenderer, {},
                 fmt::format("{} cannot draw it: {}", gl->name(), engine::OneLine(*failure)));
  }
  return images;
}

template <typename Positions>
Renderer::Images Renderer::State::DrawPoses(Subject& subject, std::span<const Positions> poses,
                                            const Options& options, diag::Findings& findings) {
  mjModel& model = *subject.state().model;
  Scene scene(model);
  PlacedShapes all;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Positions& pose : poses) {
    // Keeps only the findings of the first pose, because every pose has the same findings.
    diag::Findings again;
    subject.state().Move(pose);
    if (!scene.Fill(subject, options.layer, all.empty() ? findings : again)) return std::nullopt;
    all.Add(scene.shapes());
    lowest = std::min(lowest, scene.floor_height());
  }
  const std::vector<PlacedText> legend = DrawLegend(scene, options);
  Options above = options;
  if (!legend.empty()) above.height -= legend.back().y + legend.back().text.height;
  const Camera camera = scene.Frame(all, lowest, above);
  samples = SamplesOf(above, scene.HasOnlyOpaqueGeoms());
  ModelContext context(model, BuffersFor(above));
  std::vector<Image> images;
  for (const Positions& pose : poses) {
    diag::Findings again;
    if (poses.size() > 1) {
      subject.state().Move(pose);
      scene.Fill(subject, options.layer, again);
    }
    scene.Light(camera, lowest, !options.quick);
    Image& image = images.emplace_back(DrawScene(context, scene, camera, above));
    image.height = options.height;
    image.rgba.resize(4 * static_cast<std::size_t>(image.width) *
                      static_cast<std::size_t>(image.height));
    PutBehind(options.background, image);
    DrawLabels(scene, camera, above.height, image);
    for (const PlacedText& line : legend) PutOver(line.text, line.x, above.height + line.y, image);
  }
  return images;
}

}  // namespace mjforge::picture
