#pragma once

#include <mujoco/mujoco.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "mjforge/picture/camera.h"
#include "mjforge/picture/picture.h"
#include "mjforge/picture/support.h"

namespace mjforge::picture {

/// What is drawn of a subject: MuJoCo's list of geoms, and what we add.
class Scene {
 public:
  explicit Scene(const mjModel& model);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Lists what the layer shows of the subject in its pose. A warning if the layer is empty and
  /// something else is shown; false, and a finding, if there is nothing at all.
  bool Fill(Subject& subject, Layer layer, diag::Findings& findings);

  /// What the picture must contain.
  const Shapes& shapes() const { return shapes_; }
  /// Where the object is lowest, m.
  double floor_height() const { return floor_height_; }
  /// Text at places of the picture.
  struct Label {
    Eigen::Vector3d p_W;
    std::string text;
  };
  const std::vector<Label>& labels() const { return labels_; }
  /// Lines below the picture.
  struct Line {
    std::string text;
    std::array<float, 4> color;
  };
  const std::vector<Line>& legend() const { return legend_; }

  /// Adds light, a backdrop, and a floor at the given height unless there is one already.
  void Light(const Camera& camera, double floor_height);
  /// Makes the floor and what is behind it light or black, and returns its brightness in full
  /// light, 0..255.
  int SetFloor(bool light);
  void SetCamera(const mjvGLCamera& camera) { std::ranges::fill(scene_.camera, camera); }

  mjvScene& mujoco() { return scene_; }

  /// The picture must contain this, too.
  void AddToFrame(const Shape& shape) { shapes_.Add(shape); }
  void AddLabel(const Eigen::Vector3d& p_W, std::string text) {
    labels_.push_back({p_W, std::move(text)});
  }

  void AddToLegend(std::string text, const std::array<float, 4>& color) {
    legend_.push_back({std::move(text), color});
  }

  /// A further geom; false if there is no room.
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
  void TellApart();
  void Fade();
  void AddBackdrop(const Camera& camera);
  void Measure(const mjModel& m);

  mjvScene scene_;
  Shapes shapes_;
  std::vector<Label> labels_;
  std::vector<Line> legend_;
  bool has_ground_ = false;  // the model's: a floor or another geom fixed to the world
  double floor_height_ = 0;
  int floor_ = -1;     // its geom
  int backdrop_ = -1;  // its geom
};

}  // namespace mjforge::picture
