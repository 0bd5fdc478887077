#pragma once

// Compares what MuJoCo compiled with what we meant.
//
// A file holds 10 significant digits, so each number is off by at most 5e-11 of
// itself; lengths are compared to 1e-9 of the object's scale (its largest
// distance from a body's origin), masses to 1e-9 of themselves.

#include <string>
#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"

namespace mjforge::validate {

/// Numbers may differ by this share of themselves.
inline constexpr double kRelative = 1e-9;

/// An element to compare; its names for messages are made only when needed.
struct Subject {
  std::string_view kind;  // "geom"
  std::string_view name;
  std::string_view suffix;
  diag::SourceMark mark;
};

/// A difference.
void AddMismatch(diag::SourceMark mark, std::string message, diag::Findings& findings);
/// Whether MuJoCo compiled as many as were meant; if not, that is a finding.
bool SameCount(std::string_view what, int compiled, std::size_t meant, diag::SourceMark mark,
               diag::Findings& findings);
/// The same of a name.
bool SameName(std::string_view compiled, const Subject& subject, diag::Findings& findings);

/// Compares the compiled sensors, actuators, tendons, equalities, pairs and excludes with the
/// object's: how many there are, their names, and the elements they refer to. Adds a finding for
/// each difference.
void CompareSections(const mjModel& m, const model::Object& object, diag::Findings& findings);

class Comparison {
 public:
  Comparison(const mjModel& compiled, const model::Object& object, diag::Findings& findings);

  /// Adds a finding for each difference. `lift`: see MjcfDocument.
  void Run(double lift);

 private:
  bool SameCounts();
  void CompareStart(double lift);
  void CompareBody(int id, const model::Body& body, double lift);
  void CompareMass(int id, const model::Body& body);
  void CompareInertia(int id, const model::Body& body);
  void ComparePart(int& geom, const model::Part& part);
  void CompareGeom(int id, const model::Part& part, const Subject& subject, bool collides);
  void CompareMesh(int id, const model::Part& part, const Subject& subject);
  void CompareAttribute(mjtObj kind, int id, const model::Attribute& attribute,
                        const Subject& subject);
  void CompareJoint(int id, const model::Joint& joint);
  void CompareSite(int id, const model::Site& site);
  void CompareElement(const model::Element& element);

  void Number(const Subject& subject, std::string_view what, int position, double compiled,
              double meant, double tolerance);
  void Vector(const Subject& subject, std::string_view what, const mjtNum* compiled,
              const Eigen::Vector3d& meant, double tolerance);
  void Quaternion(const Subject& subject, const mjtNum* compiled, const Eigen::Quaterniond& meant);
  void Difference(const Subject& subject, std::string_view what, int position, double compiled,
                  double meant);

  const mjModel& m_;
  const model::Object& object_;
  diag::Findings& findings_;
  double length_tolerance_ = 0;  // m
  double scale_ = 0;             // m
  int next_site_ = 0;
  int next_camera_ = 0;
  int next_light_ = 0;
};

}  // namespace mjforge::validate
