// Filling of the scene of a picture: geoms of a layer, lights, floor and backdrop.

#include "mjforge/picture/scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mjforge/compiled/compiled.h"
#include "mjforge/engine/engine.h"
#include "mjforge/picture/layers.h"
#include "mjforge/picture/subject.h"

namespace mjforge::picture {
namespace {

using diag::Code;

// Numbers of geoms for which MuJoCo's list has space in addition to the geoms of the model: for the
// floor, boxes and axes, and for the marks of each joint.
constexpr int kExtraGeoms = 64;
constexpr int kExtraPerJoint = 64;

// The key light comes from above, behind the camera and to its left. A fill light from the camera
// and ambient light brighten the shadows. A rim light from the right brightens the faces that the
// key light does not reach, and gives metals a second highlight. With the default camera, a level
// surface has about the brightness of its own color.
const Eigen::Vector3d kKeyDirection = Eigen::Vector3d(0.22, 0.55, -1.3).normalized();
const Eigen::Vector3d kRimDirection = Eigen::Vector3d(-0.89, -0.14, -0.43).normalized();
constexpr float kKey = 0.52F;
constexpr float kKeySpecular = 0.60F;
constexpr float kFill = 0.33F;
constexpr float kAmbient = 0.27F;
constexpr float kRim = 0.20F;
constexpr float kRimSpecular = 0.60F;
constexpr float kFaded = 0.35F;    // factor of the object's alpha in layers with marks
constexpr double kBelow = 0.003;   // gap below the object, as a share of the object's radius
constexpr float kFloor = 0.85F;    // gray level of the floor
constexpr float kOpaque = 0.995F;  // alpha from which MuJoCo draws a geom as opaque

mjvOption VisibleOption() {
  mjvOption option;
  mjv_defaultOption(&option);
  std::ranges::fill(option.flags, mjtByte{0});
  for (const int flag : {mjVIS_TEXTURE, mjVIS_TENDON, mjVIS_STATIC, mjVIS_SKIN})
    option.flags[flag] = 1;
  std::ranges::fill(option.sitegroup, mjtByte{0});
  return option;
}

// Returns true if the camera sees the back of a plane, which MuJoCo draws translucent.
bool IsBehind(const Eigen::Vector3d& eye, const mjvGeom& plane) {
  const Eigen::Vector3d normal(plane.mat[2], plane.mat[5], plane.mat[8]);
  return normal.dot(eye - Eigen::Map<const Eigen::Vector3f>(plane.pos).cast<double>()) < 0;
}

bool IsGround(const mjvGeom& geom) {
  return geom.type == mjGEOM_PLANE || geom.type == mjGEOM_HFIELD;
}

// Returns true if the geom collides with any other geom, or is in a pair.
bool Collides(const mjModel& m, int geom) {
  if (compiled::Collides(m, geom)) return true;
  for (int i = 0; i < m.npair; ++i) {
    if (m.pair_geom1[i] == geom || m.pair_geom2[i] == geom) return true;
  }
  return false;
}

// Returns the color of the geom with this number in the layer `collision`. Colors of nearby numbers
// differ clearly, because hues advance by the golden section.
std::array<float, 4> DistinctColor(int number) {
  const double hue = std::fmod(0.58 + 0.61803398875 * number, 1.0);
  const auto channel = [&](double shift) {
    const double t = std::abs(std::fmod(hue + shift, 1.0) * 6 - 3) - 1;
    return static_cast<float>(0.35 + 0.55 * std::clamp(t, 0.0, 1.0));
  };
  return {channel(0), channel(2.0 / 3), channel(1.0 / 3), 1};
}

int MostGeoms(const mjModel& m) {
  return 2 * m.ngeom + m.nsite + m.nskin + 4 * m.nbody + 2 * m.nwrap + 4 * m.ntendon +
         kExtraPerJoint * m.njnt + kExtraGeoms;
}

mjvLight MakeLight(const Eigen::Vector3d& direction, float diffuse, float specular, float ambient) {
  mjvLight light = {};
  Eigen::Map<Eigen::Vector3f>(light.dir) = direction.cast<float>();
  std::ranges::fill(light.diffuse, diffuse);
  std::ranges::fill(light.specular, specular);
  std::ranges::fill(light.ambient, ambient);
  light.attenuation[0] = 1;
  light.cutoff = 180;
  engine::MakeDirectional(light);
  return light;
}

}  // namespace

Scene::Scene(const mjModel& model) {
  mjv_defaultScene(&scene_);
  mjv_makeScene(&model, &scene_, MostGeoms(model));
  scene_.flags[mjRND_SKYBOX] = 0;
  scene_.flags[mjRND_HAZE] = 0;
  scene_.flags[mjRND_FOG] = 0;
}

Scene::~Scene() { mjv_freeScene(&scene_); }

void Scene::Collect(Subject::State& state, const mjvOption& option) {
  mjvCamera camera;
  mjv_defaultFreeCamera(state.model.get(), &camera);
  mjv_updateScene(state.model.get(), state.data.get(), &option, nullptr, &camera, mjCAT_ALL,
                  &scene_);
  Drop([](const mjvGeom& geom) { return geom.rgba[3] <= 0; });
  SeparateFaces();
}

// Shrinks boxes and cylinders by different shares of about a thousandth or less, which is
// invisible, to prevent coincident faces of two geoms. MuJoCo lights coincident faces twice,
// because a second pass adds the key light to everything at the depth already drawn.
void Scene::SeparateFaces() {
  constexpr float kShare = 1e-5F;
  constexpr int kDifferent = 101;  // number of scales; a ring of boxes usually has fewer pieces
  for (int i = 0; i < scene_.ngeom; ++i) {
    mjvGeom& geom = scene_.geoms[i];
    if (geom.type != mjGEOM_BOX && geom.type != mjGEOM_CYLINDER) continue;
    const float scale = 1 - kShare * static_cast<float>(1 + i % kDifferent);
    for (float& size : geom.size) size *= scale;
  }
}

// Collects the geoms of the visible groups. If there are none, collects the geoms of all groups or,
// if the model has no geoms, all sites, and adds a warning.
void Scene::CollectVisible(Subject::State& state, diag::Findings& findings) {
  mjvOption option = VisibleOption();
  Collect(state, option);
  if (scene_.ngeom > 0) return;
  std::ranges::fill(option.geomgroup, mjtByte{1});
  Collect(state, option);
  const char* instead = "the colliding geoms";
  if (scene_.ngeom == 0) {
    std::ranges::fill(option.sitegroup, mjtByte{1});
    Collect(state, option);
    instead = "the sites";
  }
  if (scene_.ngeom == 0) return;
  findings.Warn(Code::kPictureNothingVisible, {},
                std::string("nothing is visible: the picture shows ") + instead);
}

// Collects the colliding geoms of all groups.
void Scene::CollectColliding(Subject::State& state) {
  mjvOption option = VisibleOption();
  std::ranges::fill(option.geomgroup, mjtByte{1});
  Collect(state, option);
  Drop([&](const mjvGeom& geom) {
    return geom.objtype != mjOBJ_GEOM || !Collides(*state.model, geom.objid);
  });
}

void Scene::ColorGeoms() {
  int number = 0;
  for (mjvGeom& geom : Geoms()) {
    std::ranges::copy(DistinctColor(number++), geom.rgba);
    engine::RemoveTexture(geom);
    geom.emission = 0;
    geom.reflectance = 0;
    geom.specular = 0.3F;
    geom.shininess = 0.3F;
  }
}

bool Scene::Fill(Subject& subject, Layer layer, diag::Findings& findings) {
  Subject::State& state = subject.state();
  labels_.clear();
  legend_.clear();
  level_above_floor_.reset();
  const char* lacking = "there is nothing to show: no geom and no site";
  if (layer == Layer::kCollision) {
    CollectColliding(state);
    ColorGeoms();
    lacking = "no geom can collide";
  } else {
    CollectVisible(state, findings);
  }
  if (scene_.ngeom == 0 && scene_.nskin == 0) {
    findings.Add(Code::kPictureNothingVisible, {}, lacking);
    return false;
  }
  Measure(*state.model);
  if (layer == Layer::kVisual || layer == Layer::kCollision) return true;
  const PlacedShapes visible = shapes_;
  if (layer == Layer::kBounds) {
    CollectColliding(state);
    PlacedShapes colliding;
    for (const mjvGeom& geom : Geoms()) {
      if (!IsGround(geom)) colliding.Add(ShapeOf(*state.model, geom));
    }
    CollectVisible(state, findings);
    Fade();
    DrawBounds(state, colliding.empty() ? visible : colliding, *this);
  } else {
    Fade();
    (layer == Layer::kInertia  ? DrawInertias
     : layer == Layer::kJoints ? DrawJoints
                               : DrawRegions)(state, visible, *this);
  }
  return true;
}

// Makes the object translucent, so that the marks of a layer are visible through it.
void Scene::Fade() {
  for (mjvGeom& geom : Geoms()) {
    if (!IsGround(geom)) geom.rgba[3] *= kFaded;
    geom.reflectance = 0;
  }
}

// Sets the shapes that the camera must frame. Planes and height fields do not count, unless there
// is nothing else.
void Scene::Measure(const mjModel& m) {
  shapes_ = PlacedShapes();
  has_ground_ = false;
  PlacedShapes ground;
  for (const mjvGeom& geom : Geoms()) {
    const bool of_world = geom.objtype == mjOBJ_GEOM && m.geom_bodyid[geom.objid] == 0;
    has_ground_ = has_ground_ || of_world || IsGround(geom);
    (IsGround(geom) ? ground : shapes_).Add(ShapeOf(m, geom));
  }
  for (int i = 0; i < scene_.nskin; ++i) {
    shapes_.Add({.vertices = {scene_.skinvert + 3 * scene_.skinvertadr[i],
                              3 * static_cast<std::size_t>(scene_.skinvertnum[i])}});
  }
  if (!shapes_.empty()) {
    floor_height_ = shapes_.Min().z();
    return;
  }
  // Shows a finite piece of an infinite plane.
  constexpr float kPiece = 1;  // m
  for (mjvGeom& geom : Geoms()) {
    const int plane = geom.objtype == mjOBJ_GEOM ? geom.objid : -1;
    if (geom.type == mjGEOM_PLANE && plane >= 0 && m.geom_size[3 * plane] <= 0) {
      geom.size[0] = geom.size[1] = kPiece;
      geom.dataid = -1;
    }
    shapes_.Add(ShapeOf(m, geom));
  }
}

mjvGeom* Scene::Add(int type, const Eigen::Vector3d& size, const Eigen::Vector3d& p_W,
                    const Eigen::Matrix3d& R_W, const std::array<float, 4>& rgba) {
  if (scene_.ngeom >= scene_.maxgeom) return nullptr;
  mjvGeom* geom = scene_.geoms + scene_.ngeom++;
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = R_W;
  mjv_initGeom(geom, type, size.data(), p_W.data(), rows.data(), rgba.data());
  // Overwrites the size, because mjv_initGeom converts sizes of some types from MJCF's order;
  // `size` already has the order of mjvGeom.
  Eigen::Map<Eigen::Vector3f>(geom->size) = size.cast<float>();
  geom->category = mjCAT_DECOR;
  geom->segid = -1;
  return geom;
}

Camera Scene::Frame(const PlacedShapes& shapes, double floor_height, const Options& options) const {
  std::optional<Shadow> shadow;
  if (!has_ground_) shadow = {kKeyDirection, floor_height};
  return FrameShapes(shapes, options.width, options.height, options.view, shadow);
}

bool Scene::HasOnlyOpaqueGeoms() const {
  return std::all_of(scene_.geoms, scene_.geoms + scene_.ngeom,
                     [](const mjvGeom& geom) { return geom.rgba[3] >= kOpaque; });
}

void Scene::Light(const Camera& camera, double floor_height, bool has_shadows) {
  scene_.lights[0] = MakeLight(kKeyDirection, kKey, kKeySpecular, 0);
  scene_.lights[0].castshadow = 1;
  // MuJoCo renders the shadow map from this position, between the camera's near and far planes.
  const Eigen::Vector3d eye = camera.center - (camera.near + 1.5 * camera.radius) * kKeyDirection;
  Eigen::Map<Eigen::Vector3f>(scene_.lights[0].pos) = eye.cast<float>();
  scene_.lights[1] = MakeLight(camera.forward, kFill, 0.1F, kAmbient);
  scene_.lights[2] = MakeLight(kRimDirection, kRim, kRimSpecular, 0);
  scene_.nlight = 3;
  translucent_.clear();
  std::ranges::copy_if(Geoms(), std::back_inserter(translucent_), [&](const mjvGeom& geom) {
    return geom.rgba[3] < kOpaque || (geom.type == mjGEOM_PLANE && IsBehind(camera.eye, geom));
  });
  // The floor is slightly below the object's lowest faces, because coincident faces would flicker.
  const double below = kBelow * camera.radius;
  if (has_shadows && !has_ground_ && camera.eye.z() > floor_height) {
    AddFloor(camera, floor_height - below);
    level_above_floor_ = floor_height - below / 2;
  }
  // Adds the backdrop after the floor: OpenGL skips the part of the backdrop that the floor hides.
  if (!IsOpaque()) AddBackdrop(camera);
}

mjvGeom* Scene::AddPlane(const Eigen::Vector2d& half_sides, const Eigen::Vector3d& place,
                         const Eigen::Matrix3d& axes) {
  mjvGeom* plane =
      Add(mjGEOM_PLANE, {half_sides.x(), half_sides.y(), 1}, place, axes, {1, 1, 1, 1});
  if (plane == nullptr) return nullptr;
  plane->specular = 0;
  plane->shininess = 0;
  plane->dataid = -1;
  return plane;
}

// Adds a floor. If all geoms are opaque, the floor is only as large as the shadow, because the
// picture needs a floor only where there is a shadow; otherwise the floor fills the picture.
void Scene::AddFloor(const Camera& camera, double height) {
  Eigen::Vector3d place(camera.center.x(), camera.center.y(), height);
  Eigen::Vector2d half_sides = Eigen::Vector2d::Constant(40 * camera.radius);
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  if (IsOpaque()) {
    axes.col(0) = Eigen::Vector3d(kKeyDirection.x(), kKeyDirection.y(), 0).normalized();
    axes.col(1) = Eigen::Vector3d::UnitZ().cross(axes.col(0));
    place = {0, 0, height};
    for (int i = 0; i < 2; ++i) {
      const double most = shapes_.ShadowSupport(axes.col(i), kKeyDirection, height);
      const double least = -shapes_.ShadowSupport(-axes.col(i), kKeyDirection, height);
      half_sides[i] = 0.51 * (most - least) + kBelow * camera.radius;
      place += (most + least) / 2 * axes.col(i);
    }
  }
  mjvGeom* floor = AddPlane(half_sides, place, axes);
  if (floor == nullptr) return;
  std::ranges::fill_n(floor->rgba, 3, kFloor);
  // Adds a black copy of the floor to the translucent geoms if these include marks (axes, boxes or
  // regions that a layer draws). The second rendering contains only translucent geoms; without the
  // copy, it would show marks below the floor.
  const auto is_mark = [](const mjvGeom& geom) { return geom.category == mjCAT_DECOR; };
  if (std::ranges::none_of(translucent_, is_mark)) return;
  std::ranges::fill_n(translucent_.emplace_back(*floor).rgba, 3, 0.0F);
}

// Adds the backdrop: a plane behind the object. The plane's emission makes its color independent of
// the lights.
void Scene::AddBackdrop(const Camera& camera) {
  Eigen::Matrix3d axes;
  axes << camera.right, camera.up, -camera.forward;
  const double depth = kBackdrop * camera.far;
  const double side = 2 * depth * std::max(camera.tan_x, camera.tan_y);
  mjvGeom* backdrop = AddPlane({side, side}, camera.eye + depth * camera.forward, axes);
  if (backdrop != nullptr) backdrop->emission = 1;
}

mjvScene Scene::TranslucentGeoms() {
  mjvScene scene = scene_;
  scene.geoms = translucent_.data();
  scene.ngeom = static_cast<int>(translucent_.size());
  scene.flags[mjRND_SHADOW] = 0;
  return scene;
}

int Scene::Brightness() const {
  if (!level_above_floor_) return 255;
  const double fill = -scene_.lights[1].dir[2];
  const double lit =
      kFloor * (kAmbient + kFill * fill - kKey * kKeyDirection.z() - kRim * kRimDirection.z());
  return static_cast<int>(std::lround(255 * std::min(lit, 1.0)));
}

}  // namespace mjforge::picture
