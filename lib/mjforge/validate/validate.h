// Validation by MuJoCo: loads MJCF, compares the compiled model with the object, and finds bodies
// that touch.
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

/// Contacts and bounds over the ranges of the joints. Each hinge and limited slide takes kSteps
/// positions in its range (an unlimited hinge in a full turn) while the other joints are at zero.
/// Unlimited slides and free joints do not move. A ball joint turns about 13 axes, up to its range
/// in both directions. Several joints also move together to kCombinations points of a Sobol
/// sequence. If the joints have at most 8 coordinates (3 for a ball joint), all combinations of the
/// ends of the coordinates are also tried; a ball joint then turns only about z. Equalities are
/// ignored. The results hold for the tested poses, not between them.
struct Sweep {
  static constexpr int kSteps = 65;
  static constexpr int kCombinations = 512;

  /// The deepest contact of two bodies that was found while a joint moved.
  struct Contact {
    std::string joint;  // empty: several joints together, or all at zero
    double value = 0;   // position of the joint, rad or m; of a ball joint the angle from zero
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

/// Loads models. Owns MuJoCo's virtual file system (2 MB) and the process-wide error handlers, so
/// that a process can have only one Loader.
class Loader {
 public:
  Loader();
  ~Loader();
  Loader(const Loader&) = delete;
  Loader& operator=(const Loader&) = delete;

  /// Loads a document made from `object` and compares counts, names, masses, inertias, sizes, poses
  /// and references. If everything matches, finds bodies that touch with all joints at zero or in
  /// the start pose. Adds a finding, at its place in the spec, for each error, warning, difference
  /// and touching pair. Returns true if there is no error. Sets `structure`, unless null, to that
  /// of the loaded model, and `numbers`, unless null, to those of the loaded model if there is no
  /// error so far.
  bool Validate(const mjcf::MjcfDocument& document, const model::Object& object,
                diag::Findings& findings, structure::Structure* structure = nullptr,
                family::Numbers* numbers = nullptr);

  /// Loads any MJCF file, and adds findings at their places in the XML. Returns nullopt if MuJoCo
  /// rejects the file.
  std::optional<CompiledModel> Load(const std::filesystem::path& file, diag::Sources& sources,
                                    diag::Findings& findings);

  /// Returns the text that MuJoCo reads instead of a file that was written for a later version or
  /// whose meshes would have other masses in that version. The text is valid in any folder. Returns
  /// nullopt if MuJoCo reads the file itself.
  static std::optional<std::string> AdaptedText(const std::filesystem::path& file);

  /// Loads a document or a file and moves its joints. Adds findings and returns nullopt if MuJoCo
  /// rejects the model or fails, or if the loading of a file adds an error. The other findings
  /// about a file are left out, because Load() reports them.
  std::optional<Sweep> SweepJoints(const mjcf::MjcfDocument& document, const model::Object& object,
                                   diag::Findings& findings);
  std::optional<Sweep> SweepJoints(const std::filesystem::path& file, diag::Sources& sources,
                                   diag::Findings& findings);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mjforge::validate
