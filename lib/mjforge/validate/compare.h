// Comparison of a compiled model with the object from which its MJCF was written.
//
// Numbers in a file have 10 significant digits, and therefore a relative error of at most 5e-11.
// The tolerance of lengths is 1e-9 of the scale of the object (largest distance of an element from
// the origin of its body). The tolerance of masses is 1e-9 of the mass.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <mujoco/mujoco.h>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"

namespace mjforge::validate {

/// Relative tolerance of the numbers in a compiled model.
inline constexpr double kRelative = 1e-9;

/// Kind and name of a compared element, for messages. The full name is `name` followed by `suffix`.
struct ComparedElement {
  std::string_view kind;  // "geom"
  std::string_view name;
  std::string_view suffix;
  diag::SourceMark mark;
};

/// Adds an error about a difference between the compiled model and the object.
void AddMismatch(diag::SourceMark mark, std::string message, diag::Findings& findings);
/// Returns true if the model has as many elements as the object; otherwise adds a finding. `what`
/// is the kind of elements in plural, for the message.
bool SameCount(std::string_view what, int compiled, std::size_t meant, diag::SourceMark mark,
               diag::Findings& findings);
/// Returns true if `compiled` is the full name of the element `subject`; otherwise adds a finding.
bool SameName(std::string_view compiled, const ComparedElement& subject, diag::Findings& findings);

/// Compares numbers, names and references of sensors, actuators, tendons, equalities, pairs and
/// excludes. Adds a finding for each difference.
void CompareSections(const mjModel& m, const model::Object& object, diag::Findings& findings);

/// Comparison of a whole model with an object: bodies with their elements, the sections of
/// CompareSections(), and the start keyframe.
class Comparison {
 public:
  Comparison(const mjModel& compiled, const model::Object& object, diag::Findings& findings);

  /// Compares, and adds a finding for each difference. `lift` is MjcfDocument::lift, m.
  void Run(double lift);

 private:
  bool SameCounts();
  void CompareStart(double lift);
  void CompareStartPoses(double lift);
  void CompareBody(int id, const model::Body& body, double lift);
  void CompareMass(int id, const model::Body& body, const ComparedElement& subject);
  void CompareInertia(int id, const model::Body& body, const ComparedElement& subject);
  void ComparePart(int& geom, const model::Part& part);
  void CompareGeom(int id, const model::Part& part, const ComparedElement& subject, bool collides);
  void CompareMesh(int id, const model::Part& part, const ComparedElement& subject);
  void CompareAttribute(mjtObj kind, int id, const model::Attribute& attribute,
                        const ComparedElement& subject);
  void CompareJoint(int id, const model::Joint& joint);
  void CompareSite(int id, const model::Site& site);
  void CompareElement(const model::Element& element);

  void Number(const ComparedElement& subject, std::string_view what, int position, double compiled,
              double meant, double tolerance);
  void Vector(const ComparedElement& subject, std::string_view what, const mjtNum* compiled,
              const Eigen::Vector3d& meant, double tolerance);
  void Quaternion(const ComparedElement& subject, const mjtNum* compiled,
                  const Eigen::Quaterniond& meant);
  void Difference(const ComparedElement& subject, std::string_view what, int position,
                  double compiled, double meant);

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
