// Scene of a picture: geoms, lights, floor, marks, labels and legend.

#pragma once

#include <mujoco/mujoco.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mjforge/picture/camera.h"
#include "mjforge/picture/picture.h"
#include "mjforge/picture/support.h"

namespace mjforge::picture {

/// MuJoCo's scene (mjvScene) of a subject: its geoms with lights, a floor, and the marks (boxes,
/// axes) of a layer.
class Scene {
 public:
  explicit Scene(const mjModel& model);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Fills the scene with a layer of the subject in its current pose. If nothing is visible,
  /// shows geoms of other groups or else sites, and adds a warning. Returns false, and adds a
  /// finding, if there is nothing to show.
  bool Fill(Subject& subject, Layer layer, diag::Findings& findings);

  /// Shapes that the camera must frame.
  const PlacedShapes& shapes() const { return shapes_; }
  /// Lowest z of the framed shapes, m.
  double floor_height() const { return floor_height_; }
  /// Text at a point of the scene.
  struct Label {
    Eigen::Vector3d p_W;
    std::string text;
  };
  const std::vector<Label>& labels() const { return labels_; }
  /// Line of the legend below the scene.
  struct Line {
    std::string text;
    std::array<float, 4> color;
  };
  const std::vector<Line>& legend() const { return legend_; }

  /// Returns a camera that frames shapes that stand on a floor at this height. The camera also
  /// frames the shadow of the shapes, unless the model has a ground: a plane, a height field or
  /// another geom fixed to the world.
  Camera Frame(const PlacedShapes& shapes, double floor_height, const Options& options) const;

  /// Adds lights and, if `has_shadows` is true, a floor at the given height, unless the model has a
  /// ground or the camera is below the floor. A scene with translucent geoms also gets a backdrop.
  void Light(const Camera& camera, double floor_height, bool has_shadows);
  /// Returns true if no geom is translucent.
  bool HasOnlyOpaqueGeoms() const;
  /// Returns true if no geom is translucent for the camera that was passed to Light(). MuJoCo draws
  /// a plane translucent if the camera sees its back.
  bool IsOpaque() const { return translucent_.empty(); }
  /// Returns a scene of the translucent geoms only, on black. The scene has no shadows, because
  /// MuJoCo draws no shadows on translucent geoms. The result is valid until the scene changes.
  mjvScene TranslucentGeoms();
  /// Returns the brightness of the floor, or else the backdrop, outside of shadows, 0..255.
  int Brightness() const;
  /// Returns a height, m, between the floor and the object; nullopt if there is no floor.
  const std::optional<double>& level_above_floor() const { return level_above_floor_; }
  void SetCamera(const mjvGLCamera& camera) { std::ranges::fill(scene_.camera, camera); }

  mjvScene& mujoco() { return scene_; }

  /// Adds a shape that the camera must frame.
  void AddToFrame(const PlacedShape& shape) { shapes_.Add(shape); }
  void AddLabel(const Eigen::Vector3d& p_W, std::string text) {
    labels_.push_back({p_W, std::move(text)});
  }

  void AddToLegend(std::string text, const std::array<float, 4>& color) {
    legend_.push_back({std::move(text), color});
  }

  /// Adds a geom of the category mjCAT_DECOR; returns null if MuJoCo's list is full. `size` has the
  /// order of mjvGeom::size.
  mjvGeom* Add(int type, const Eigen::Vector3d& size, const Eigen::Vector3d& p_W,
               const Eigen::Matrix3d& R_W, const std::array<float, 4>& rgba);

 private:
  std::span<mjvGeom> Geoms() { return {scene_.geoms, static_cast<std::size_t>(scene_.ngeom)}; }
  void Drop(auto is_dropped) {
    mjvGeom* const end = scene_.geoms + scene_.ngeom;
    scene_.ngeom = static_cast<int>(std::remove_if(scene_.geoms, end, is_dropped) - scene_.geoms);
  }
  void Collect(Subject::State& state, const mjvOption& option);
  void SeparateFaces();
  void CollectVisible(Subject::State& state, diag::Findings& findings);
  void CollectColliding(Subject::State& state);
  void ColorGeoms();
  void Fade();
  void AddFloor(const Camera& camera, double height);
  void AddBackdrop(const Camera& camera);
  mjvGeom* AddPlane(const Eigen::Vector2d& half_sides, const Eigen::Vector3d& place,
                    const Eigen::Matrix3d& axes);
  void Measure(const mjModel& m);

  mjvScene scene_;
  PlacedShapes shapes_;
  std::vector<Label> labels_;
  std::vector<Line> legend_;
  bool has_ground_ = false;  // true: there is a plane, a height field or a geom fixed to the world
  // Translucent geoms. If these include marks, also a black floor, which hides marks below the
  // floor.
  std::vector<mjvGeom> translucent_;
  double floor_height_ = 0;
  std::optional<double> level_above_floor_;  // nullopt: there is no floor
};

}  // namespace mjforge::picture
