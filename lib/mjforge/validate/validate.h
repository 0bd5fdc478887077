#pragma once

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

/// What MuJoCo compiled.
struct CompiledModel {
  struct Element {
    std::string kind;  // camera light pair exclude equality tendon actuator sensor
    std::string name;  // may be empty
  };
  model::Object object;           // as compiled::ObjectOf() reads it
  std::vector<int> body_geoms;    // of each body: planes and height fields, too
  std::vector<Element> elements;  // of the world, too
  int joints = 0;
  int geoms = 0;  // of the world, too
  int sites = 0;  // of the world, too
};

/// What the joints do to a model, found by moving them. Each hinge and slide moves through its
/// range, an unlimited hinge through a full turn, in kSteps steps while the others are at their
/// zero; a ball joint turns about 13 axes up to its range both ways. Several joints also move
/// together, to kCombinations low-discrepancy points of their ranges (Sobol), and to all
/// combinations of their ends if there are few. Free joints do not move. Equalities are not
/// enforced. The results hold for those poses, not between them.
struct Sweep {
  static constexpr int kSteps = 65;
  static constexpr int kCombinations = 512;

  /// The deepest contact of two bodies that a joint causes.
  struct Contact {
    std::string joint;  // empty: several joints together, or all at zero
    double value = 0;   // the joint's there; rad, m; of a ball joint the angle from its zero
    std::string body1;
    std::string geom1;  // of body1
    std::string body2;
    std::string geom2;
    double depth = 0;  // m
  };
  std::vector<Contact> contacts;  // by joint, then body; what several do comes last
  /// Unlimited slides, which have no range to move through.
  std::vector<std::string> held;
  /// Of all geoms that can collide (all, if none can), over all poses. In the
  /// frame of an object's root, or of a file's world.
  model::Box3 aabb;
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

  /// Loads a document made from `object` and compares counts, names, masses, inertias, sizes, poses
  /// and references. If everything matches, looks for bodies that touch with all joints at zero.
  /// Adds a finding, at the place in the spec, for each error, warning, difference and touching
  /// pair. True if there is no error.
  bool Validate(const mjcf::MjcfDocument& document, const model::Object& object,
                diag::Findings& findings);

  /// Loads any MJCF file. Findings point into the XML.
  std::optional<CompiledModel> Load(const std::filesystem::path& file, diag::Sources& sources,
                                    diag::Findings& findings);

  /// What MuJoCo reads in place of a file that was written for a later one, as a text for any
  /// folder; nothing if it reads the file as it is.
  static std::optional<std::string> AdaptedText(const std::filesystem::path& file);

  /// Loads a document or a file and moves its joints. Nothing, and a finding, if MuJoCo refuses it
  /// or warns.
  std::optional<Sweep> SweepJoints(const mjcf::MjcfDocument& document, const model::Object& object,
                                   diag::Findings& findings);
  std::optional<Sweep> SweepJoints(const std::filesystem::path& file, diag::Sources& sources,
                                   diag::Findings& findings);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mjforge::validate
