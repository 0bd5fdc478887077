// Validation by MuJoCo: loads MJCF, compares the compiled model with the object from which the MJCF
// was written, and finds bodies that touch.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/family/family.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/structure/structure.h"

namespace mjforge::validate {

/// Contents of a compiled model.
struct CompiledModel {
  struct Element {
    std::string kind;  // camera, light, pair, exclude, equality, tendon, actuator, sensor
    std::string name;  // empty if the element has no name
  };
  model::Object object;         // read by compiled::ObjectOf()
  std::vector<int> body_geoms;  // number of geoms of each body except the world
  // Elements of the whole model, including those of the world.
  std::vector<Element> elements;
  int joints = 0;
  int geoms = 0;
  int sites = 0;
};

/// Contacts and bounds over the ranges of the joints. Each hinge and each slide with a range takes
/// kSteps positions in its range while the other joints are at their start; a hinge without a range
/// makes a full turn. Slides without a range and free joints do not move. A ball joint turns about
/// 13 axes, up to its range in both directions. Two or more joints also move together to
/// kCombinations points of a Sobol sequence. If all joints together have at most 8 coordinates (3
/// for a ball joint), all combinations of the ends of the coordinates are tried, too; a ball joint
/// then turns only about z. Equalities are ignored. The results hold for the tried positions, but
/// not between them.
struct Sweep {
  static constexpr int kSteps = 65;
  static constexpr int kCombinations = 512;

  /// The deepest contact of two bodies that was found while a joint moved.
  struct Contact {
    std::string joint;  // empty: several joints together, or all at the start
    double value = 0;   // joint position, rad or m; ball joint: angle from qpos0
    std::string body1;
    std::string geom1;  // geom of body1
    std::string body2;
    std::string geom2;
    double depth = 0;  // m
  };
  std::vector<Contact> contacts;  // sorted by joint, then body; contacts of several joints are last
  /// Names of unlimited slides, which do not move because they have no range.
  std::vector<std::string> unlimited_slides;
  /// Box around all colliding geoms (all geoms if none collides) in all poses, in the frame of an
  /// object's root or of a file's world.
  model::Box3 aabb;
};

/// Returns the version of the MuJoCo library in use: "2.2.2".
std::string MujocoVersion();

/// Loads models. A process can have only one Loader, because a Loader owns the process-wide error
/// handlers of MuJoCo.
class Loader {
 public:
  Loader();
  ~Loader();

  /// Loads a document made from `object`, and compares counts, names, masses, inertias, sizes,
  /// poses and references with those of the object. If everything matches, finds bodies that touch
  /// at the start or in the zero configuration. Adds a finding, at its place in the spec, for each
  /// error, warning, difference and touching pair. Returns true if there is no error. Unless null,
  /// `structure` is set to the structure of the loaded model, and `numbers` to its numbers;
  /// `numbers` is unchanged after an error.
  bool Validate(const mjcf::MjcfDocument& document, const model::Object& object,
                diag::Findings& findings, structure::Structure* structure = nullptr,
                family::Numbers* numbers = nullptr);

  /// Loads any MJCF file, and adds findings at their places in the XML. Returns nullopt if MuJoCo
  /// rejects the file.
  std::optional<CompiledModel> Load(const std::filesystem::path& file, diag::Sources& sources,
                                    diag::Findings& findings);

  /// Returns the text that mjforge passes to MuJoCo instead of the file, because the file was
  /// written for a later MuJoCo, or because later releases compute other masses or shapes from it.
  /// The text is valid in any folder. Returns nullopt if MuJoCo can read the file itself.
  static std::optional<std::string> AdaptedText(const std::filesystem::path& file);

  /// Loads a document or a file and moves its joints. Adds findings and returns nullopt if MuJoCo
  /// rejects the model or fails, or if loading a file adds an error. Leaves out warnings about a
  /// file, because Load() reports them.
  std::optional<Sweep> SweepJoints(const mjcf::MjcfDocument& document, const model::Object& object,
                                   diag::Findings& findings);
  std::optional<Sweep> SweepJoints(const std::filesystem::path& file, diag::Sources& sources,
                                   diag::Findings& findings);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mjforge::validate
