#ifndef MJFORGE_VALIDATE_VALIDATE_H_
#define MJFORGE_VALIDATE_VALIDATE_H_

// MuJoCo's verdict: loads MJCF in MuJoCo 2.2 and compares what it compiled with
// what we meant.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"

namespace mjforge::validate {

/// What MuJoCo compiled, in SI units, at the joints' zero.
struct CompiledModel {
  struct Body {
    std::string name;
    std::string parent;
    double mass = 0;
    Eigen::Vector3d inertia = Eigen::Vector3d::Zero();  // principal
    int geoms = 0;
  };
  struct Joint {
    std::string name;
    std::string body;
    std::string type;
    bool limited = false;
    Eigen::Vector2d range = Eigen::Vector2d::Zero();
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  };
  std::string name;
  std::vector<Body> bodies;  // without the world
  std::vector<Joint> joints;
  int geoms = 0;
  int sites = 0;
  model::MassProperties mass_properties;  // of all but the world, in the world frame
  model::Box3 aabb;  // of all geoms that can collide and belong to a body but the world
};

/// The version of the MuJoCo library in use: "2.2.2".
std::string MujocoVersion();

/// Loads models. Holds MuJoCo's 2 MB virtual file system and the process-wide
/// error handlers; make one per process and keep it.
class Loader {
 public:
  Loader();
  ~Loader();
  Loader(const Loader&) = delete;
  Loader& operator=(const Loader&) = delete;

  /// Loads a document made from `object` and compares counts, names, masses,
  /// inertias, sizes and poses. Adds a finding, at the place in the spec, for
  /// each error, warning and difference. True: loaded, and all as meant.
  bool Validate(const mjcf::MjcfDocument& document, const model::Object& object,
                diag::Findings& findings);

  /// Loads any MJCF file. Findings point into the XML.
  std::optional<CompiledModel> Load(const std::filesystem::path& file, diag::Sources& sources,
                                    diag::Findings& findings);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mjforge::validate

#endif  // MJFORGE_VALIDATE_VALIDATE_H_
