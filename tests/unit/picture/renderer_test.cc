#include <cstdlib>

#include "models.h"

namespace mjforge::picture {
namespace {

const Options kSmall = {.width = 96, .height = 96, .background = {.transparent = true}};

Image Draw(Renderer& renderer, Subject& subject, const Options& options = kSmall) {
  diag::Findings findings;
  auto image = renderer.Draw(subject, options, findings);
  REQUIRE(image.has_value());
  REQUIRE(findings.empty());
  return *std::move(image);
}

// Pixels of the object itself, not of its shadow.
int Opaque(const Image& image) {
  int opaque = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) opaque += image.rgba[i] == 255 ? 1 : 0;
  return opaque;
}

std::array<int, 4> At(const Image& image, int x, int y) {
  const auto at = static_cast<std::size_t>(4 * (y * image.width + x));
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}

TEST_CASE("a quick picture shows the same object without its shadow") {
  const auto renderer = OpenRenderer();
  const auto subject = LoadGeom("type='box' size='1 2 0.5' rgba='1 0 0 1'");
  const Image full = Draw(*renderer, *subject);
  Options options = kSmall;
  options.quick = true;
  const Image quick = Draw(*renderer, *subject, options);
  CHECK(std::abs(Opaque(full) - Opaque(quick)) < 300);  // edges are not smoothed
  int others = 0;
  for (std::size_t i = 3; i < quick.rgba.size(); i += 4)
    others += quick.rgba[i] != 0 && quick.rgba[i] != 255 ? 1 : 0;
  CHECK(others == 0);
  CHECK(At(quick, 48, 48)[0] > 2 * At(quick, 48, 48)[1]);
  CHECK(Draw(*renderer, *subject).rgba == full.rgba);  // the next full picture is as before
}

TEST_CASE("an object is seen, and so is its shadow, at every size") {
  const auto renderer = OpenRenderer();
  int expected = 0;
  for (const std::string size :
       {"1 2 0.5", "1e-6 2e-6 0.5e-6", "1000 2000 500", "1e-9 2e-9 .5e-9"}) {
    INFO(size);
    const auto subject = LoadGeom("type='box' size='" + size + "' rgba='1 0 0 1'");
    const Image image = Draw(*renderer, *subject);
    const int opaque = Opaque(image);
    if (expected == 0) expected = opaque;
    CHECK(opaque > 96 * 96 / 4);
    CHECK(std::abs(opaque - expected) < 100);
    int shadow = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
      shadow += image.rgba[i] == 0 && image.rgba[i + 3] > 30 ? 1 : 0;
    CHECK(shadow > 100);
    const auto middle = At(image, 48, 48);
    CHECK(middle[0] > 2 * middle[1]);  // red
    CHECK(At(image, 0, 0)[3] == 0);
  }
}

TEST_CASE("the same subject gives the same bytes, whatever was drawn before") {
  const auto renderer = OpenRenderer();
  const auto first = LoadGeom("type='sphere' size='1'");
  const auto second = Load(kChest);
  const Image alone = Draw(*renderer, *second);
  Draw(*renderer, *first);
  Draw(*renderer, *first, {.width = 50, .height = 200, .layer = Layer::kBounds});
  CHECK(Draw(*renderer, *second).rgba == alone.rgba);
}

TEST_CASE("from below there is no floor between the camera and the object") {
  const auto renderer = OpenRenderer();
  const auto subject = LoadGeom("type='box' size='1 1 1' rgba='0 0.2 0 1'");
  Options below = kSmall;
  below.view.elevation = 30;
  const Image image = Draw(*renderer, *subject, below);
  CHECK(At(image, 48, 48)[3] == 255);
  CHECK(At(image, 48, 48)[0] < 40);
  for (std::size_t i = 3; i < image.rgba.size(); i += 4 * 96)
    CHECK(image.rgba[i] == 0);  // left border
}

TEST_CASE("translucent geoms have an alpha where nothing opaque is behind them") {
  const auto renderer = OpenRenderer();
  std::string why_not;
  const auto subject = Loader().LoadText(
      "<mujoco><worldbody><body><freejoint/>"
      "<geom type='box' size='2 0.1 1' rgba='0 0 1 0.4'/>"
      "<geom type='box' size='1 0.1 1' pos='1 0.5 0' rgba='0.8 0.1 0.1 1'/>"
      "</body></worldbody></mujoco>",
      {}, why_not);
  REQUIRE(subject != nullptr);
  Options options = kSmall;
  options.view.azimuth = 90;
  options.view.elevation = -10;
  const Image image = Draw(*renderer, *subject, options);
  const auto alone = At(image, 30, 48);
  const auto before = At(image, 66, 48);
  CHECK(alone[3] > 100);
  CHECK(alone[3] < 230);
  CHECK(alone[2] > 2 * alone[0]);
  CHECK(before[3] == 255);
  CHECK(before[0] > 30);  // red behind blue
  CHECK(before[2] > 30);
}

TEST_CASE("the floor hides marks that are below it") {
  const auto renderer = OpenRenderer();
  std::string why_not;
  // The box with the same inertia is higher than the object.
  const auto subject = Loader().LoadText(
      "<mujoco><worldbody><body><freejoint/><geom size='0.1' pos='0 0 1'/>"
      "<geom size='0.1' pos='0 0 -1'/></body></worldbody></mujoco>",
      {}, why_not);
  REQUIRE(subject != nullptr);
  Options options = kSmall;
  options.layer = Layer::kInertia;
  options.view.elevation = -30;
  const Image image = Draw(*renderer, *subject, options);
  std::array<int, 2> blue = {};  // pixels of the box in the upper half and in the lowest rows
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::array<int, 4> pixel = At(image, x, y);
      if (pixel[2] < 100 || pixel[2] < 2 * pixel[0]) continue;
      blue[0] += y < 48 ? 1 : 0;
      blue[1] += y >= 82 ? 1 : 0;
    }
  }
  CHECK(blue[0] > 20);
  CHECK(blue[1] == 0);
}

TEST_CASE("a translucent part elsewhere does not change an opaque one and its shadow") {
  const auto renderer = OpenRenderer();
  const auto draw = [&](const std::string& alpha) {
    const auto subject = Load(
        "<mujoco><worldbody><body><freejoint/><geom type='box' size='1 1 1' rgba='1 0 0 1'/>"
        "<geom size='0.1' rgba='1 0 0 " +
        alpha + "'/></body></worldbody></mujoco>");
    Options options = kSmall;
    options.width = options.height = 700;  // so large that both have the same samples
    return Draw(*renderer, *subject, options).rgba;
  };
  const auto once = draw("1");
  const auto twice = draw("0.5");  // inside the box
  int most = 0;
  for (std::size_t i = 0; i < once.size(); ++i) most = std::max(most, std::abs(once[i] - twice[i]));
  CHECK(most <= 2);
}

TEST_CASE("faces in one plane are lit once") {
  const auto renderer = OpenRenderer();
  const auto brightest = [&](const std::string& geoms) {
    const auto subject =
        Load("<mujoco><worldbody><body><freejoint/>" + geoms + "</body></worldbody></mujoco>");
    const Image image = Draw(*renderer, *subject);
    int most = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
      most = std::max<int>(most, image.rgba[i + 1]);
    return most;
  };
  const std::string look = " rgba='0.2 0.5 0.2 1'/>";
  const std::string one = "<geom type='box' size='2 1 1'" + look;
  // A block of the same outline, made of two that overlap: all faces but two coincide.
  const std::string two = "<geom type='box' size='1.5 1 1' pos='-.5 0 0'" + look +
                          "<geom type='box' size='1.5 1 1' pos='.5 0 0'" + look;
  CHECK(brightest(two) <= brightest(one) + 2);
}

TEST_CASE("each layer shows something else") {
  const auto renderer = OpenRenderer();
  const auto subject = Load(kChest);
  std::vector<Image> images;
  for (std::size_t i = 0; i < LayerNames().size(); ++i) {
    Options options = kSmall;
    options.layer = static_cast<Layer>(i);
    images.push_back(Draw(*renderer, *subject, options));
    for (std::size_t j = 0; j < i; ++j) CHECK(images[j].rgba != images[i].rgba);
  }
}

TEST_CASE("a joint moves pixels") {
  const auto renderer = OpenRenderer();
  const auto subject = Load(kChest);
  const Image closed = Draw(*renderer, *subject);
  diag::Findings findings;
  REQUIRE(subject->SetJoint(1, 0.8, findings));
  CHECK(Draw(*renderer, *subject).rgba != closed.rgba);
}

TEST_CASE("frames of a motion are seen from one place") {
  const auto renderer = OpenRenderer();
  const auto subject = Load(kChest);
  diag::Findings findings;
  const std::vector<JointPositions> poses = {{{1, 0.0}}, {{1, 1.5}}, {{1, 0.0}}};
  const auto frames = renderer->DrawMotion(*subject, poses, kSmall, findings);
  REQUIRE(frames.has_value());
  CHECK((*frames)[0].rgba != (*frames)[1].rgba);
  CHECK((*frames)[0].rgba == (*frames)[2].rgba);
  const auto front = [](const Image& image) { return At(image, 50, 85); };  // of the chest
  CHECK(front((*frames)[0]) == front((*frames)[1]));
}

TEST_CASE("a file's own floor takes the place of ours") {
  const auto renderer = OpenRenderer();
  const auto subject = Load(
      "<mujoco><worldbody><geom type='plane' size='0 0 1' rgba='0.2 0.9 0.2 1'/><body pos='0 0 1'>"
      "<freejoint/><geom size='0.5' rgba='1 0 0 1'/></body></worldbody></mujoco>");
  const Image image = Draw(*renderer, *subject);
  const auto corner = At(image, 2, 93);
  CHECK(corner[3] == 255);
  CHECK(corner[1] > 2 * corner[0]);
}

TEST_CASE("an object that hangs on the world has a floor, other things of the world need none") {
  const auto renderer = OpenRenderer();
  const auto fixed =
      Load("<mujoco><worldbody><body><geom type='box' size='1 1 1'/></body></worldbody></mujoco>");
  const auto table =
      Load("<mujoco><worldbody><geom type='box' size='1 1 1'/></worldbody></mujoco>");
  const Image with = Draw(*renderer, *fixed);
  const Image without = Draw(*renderer, *table);
  const auto half_seen = [](const Image& image) {
    int count = 0;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
      count += image.rgba[i] > 20 && image.rgba[i] < 200 ? 1 : 0;
    return count;
  };
  CHECK(half_seen(with) > half_seen(without) + 100);
  CHECK(At(without, 2, 93)[3] == 0);
}

TEST_CASE("glass lets the background through") {
  const auto renderer = OpenRenderer();
  const auto glass = LoadGeom("type='box' size='1 1 1' rgba='0.5 0.5 1 0.3'");
  const int alpha = At(Draw(*renderer, *glass), 48, 48)[3];
  CHECK(alpha > 40);
  CHECK(alpha < 200);
}

TEST_CASE("what is not visible is shown nevertheless, with a warning") {
  const auto renderer = OpenRenderer();
  const auto hidden = LoadGeom("type='box' size='1 1 1' group='3'");
  diag::Findings findings;
  const auto image = renderer->Draw(*hidden, kSmall, findings);
  REQUIRE(image.has_value());
  CHECK(Opaque(*image) > 1000);
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].severity == diag::Severity::kWarning);
  CHECK(findings[0].message == "nothing is visible: the picture shows the colliding geoms");

  const auto sites =
      Load("<mujoco><worldbody><body><site size='0.1'/></body></worldbody></mujoco>");
  findings.clear();
  REQUIRE(renderer->Draw(*sites, kSmall, findings).has_value());
  CHECK(findings[0].message == "nothing is visible: the picture shows the sites");
}

TEST_CASE("where there is nothing to show there is no picture") {
  const auto renderer = OpenRenderer();
  diag::Findings findings;
  CHECK_FALSE(renderer->Draw(*Load("<mujoco/>"), kSmall, findings).has_value());
  REQUIRE(findings.size() == 1);
  CHECK(findings[0].message == "there is nothing to show: no geom and no site");
  findings.clear();
  Options options = kSmall;
  options.layer = Layer::kCollision;
  const auto ghost = LoadGeom("size='1' contype='0' conaffinity='0'");
  CHECK_FALSE(renderer->Draw(*ghost, options, findings).has_value());
  CHECK(findings[0].message == "no geom can collide");
}

TEST_CASE("large pictures, drawn in bands, are as small ones") {
  const auto renderer = OpenRenderer();
  const auto subject = Load(kChest);
  Options large = kSmall;
  large.width = large.height = 1536;
  const Image image = Draw(*renderer, *subject, large);
  CHECK(image.rgba.size() == std::size_t{1536} * 1536 * 4);
  const double share = static_cast<double>(Opaque(image)) / (1536.0 * 1536);
  const double small = static_cast<double>(Opaque(Draw(*renderer, *subject))) / (96.0 * 96);
  CHECK(share == Approx(small).margin(0.04));
}

class Variable {
 public:
  explicit Variable(const char* value) { ::setenv("MUJOCO_GL", value, 1); }
  ~Variable() { ::unsetenv("MUJOCO_GL"); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;
};

TEST_CASE("without a renderer there is a finding") {
  const auto message = [](const char* value) {
    const Variable variable(value);
    diag::Findings findings;
    CHECK(Renderer::Open(findings) == nullptr);
    REQUIRE(findings.size() == 1);
    return findings[0].message;
  };
  CHECK(message("off") == "cannot draw: MUJOCO_GL=off turns drawing off");
  CHECK(message("osmsa") ==
        "cannot draw: MUJOCO_GL is 'osmsa', not egl, osmesa or disable; did you mean 'osmesa'?");
  CHECK(message("glfw") == "cannot draw: MUJOCO_GL is 'glfw', not egl, osmesa or disable");
}

}  // namespace
}  // namespace mjforge::picture
