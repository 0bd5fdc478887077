#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mjforge/model/attached.h"
#include "mjforge/model/materials.h"
#include "mjforge/model/model.h"
#include "mjforge/model/references.h"
#include "mjforge/model/repetition.h"
#include "mjforge/model/sections.h"

namespace mjforge::model {

/// One object in the making: a tree of bodies and specs, filled from the outermost spec inwards.
class Assembly {
 public:
  Assembly(Assembler& assembler, diag::Findings& findings)
      : findings_(findings),
        repetition_(findings),
        assets_(assembler, object_, findings),
        references_(object_, findings),
        materials_(object_, assets_, findings),
        sections_(object_, repetition_, references_, findings),
        attacher_({assembler.attachments(), object_, assets_, materials_, sections_, references_,
                   bodies_},
                  findings) {}

  std::optional<Object> Run(sample::Evaluator& values, const Assembler::Options& options);

 private:
  // assembly.cc
  void AddSpec(Scope& scope);
  void AddParts(Scope& scope, const std::vector<spec::Entry>& entries, const Pose& X_SF);
  void AddFrame(Scope& scope, const spec::Entry& entry, const Pose& X_SF);
  void AddWeld(Scope& scope, const spec::Entry& entry, const Pose& X_SF);
  /// How much the body at hand and the object have.
  struct Extent {
    std::size_t parts = 0;
    std::size_t sites = 0;
    std::size_t views = 0;
    std::size_t bodies = 0;
  };
  Extent ExtentNow();
  /// Moves what came since `from`: parts, sites and views of the body at hand, and the bodies on
  /// `parent`.
  void Move(const Pose& X_BC, const Extent& from, int parent);
  /// Whether one more of `what` may come to the `count` there are; else a finding, the first time.
  bool HasRoomFor(std::string_view what, std::size_t count, diag::SourceMark mark);
  // nested.cc
  /// The values of the spec that an entry brings, with the entry's parameters set; null after a
  /// finding.
  std::optional<sample::Evaluator> SampleNested(Scope& scope, const spec::Entry& entry,
                                                sample::StreamId path);
  void ReadTotalSize(Scope& scope);
  void ReadChecks(Scope& scope);  // checks.cc
  void ReadFitting(Scope& scope, const spec::Checks::Fitting& entry);
  void ReadGrasps(Scope& scope, const spec::Checks::Grasping& entry);
  void ReadPartCheck(Scope& scope, const spec::Checks::PartCheck& entry);
  void ReadJointCheck(Scope& scope, const spec::Checks::JointCheck& entry);
  void ScaleObject(Scope& scope, std::size_t first_part, std::size_t first_body);

  // bodies.cc
  void AddBodies(Scope& scope);
  void AddBody(Scope& scope, const spec::BodyEntry& entry, sample::StreamId bodies);
  /// Adds the content of the entry to the body `index`, the last one so far.
  void Fill(Scope& scope, const spec::BodyEntry& entry, FieldReader& reader,
            const std::string& name, std::size_t index, sample::StreamId path);
  void PlaceBody(Scope& scope, FieldReader& reader, const spec::Entry& entry, const Bounds& bounds,
                 Body& body);
  int ParentOf(Scope& scope, FieldReader& reader, const spec::Entry& entry);
  /// Sets the values of NAME.top and the other properties of a body.
  void SetProperties(Scope& scope, const spec::BodyEntry& entry, const Bounds& bounds,
                     std::size_t index);

  void Finish(Scope& scope);  // finish.cc

  // positions.cc
  struct Position {
    std::string joint;  // its full name
    std::string shown;  // as the spec says it
    sample::Numbers numbers;
    diag::SourceMark mark;
  };
  /// Reads `pose:` of a spec; SetPositions, once all joints are there, gives it to them.
  void ReadPositions(Scope& scope);
  void SetPositions();
  /// The position as qpos has it; nothing, and a finding, if the joint cannot be there. `what`:
  /// "pose".
  std::optional<sample::Numbers> Placed(std::string_view what, const Position& position,
                                        const Joint& joint);
  /// Reports that there is no such joint.
  void ReportUnknown(std::string_view what, const Position& position);

  // expectations.cc
  /// Checks the conditions of `expect:`, and reads the rest of it.
  void AddExpectations(Scope& scope);
  void AddExpectation(Scope& scope, const spec::Expectation& entry);
  /// The full name of a body or a part; nothing, and a finding, if it is neither.
  std::optional<std::string> FullName(Scope& scope, const spec::Value& value);
  void CheckCondition(Scope& scope, const spec::Expectation& entry);

  // parts.cc
  void AddPart(Scope& scope, const spec::Entry& entry, const Pose& X_SF);
  /// Adds the part to the body; in place of a shape that MuJoCo does not have, what is seen of it
  /// and its pieces, which come in its frame.
  void AddWithPieces(Part part, std::vector<Part> pieces);
  bool ReadMaterial(Scope& scope, FieldReader& reader, const spec::Entry& entry, Part& part,
                    const MaterialState*& material);
  bool ReadMass(FieldReader& reader, const spec::Entry& entry, const MaterialState* material,
                Part& part);
  bool SetMass(FieldReader& reader, const std::optional<double>& mass, Part& part);
  bool SetDensity(FieldReader& reader, const spec::Field& field, double density, Part& part);

  // views.cc
  /// Cameras and lights; `path` is that of the body.
  void AddViews(Scope& scope, const std::vector<spec::Entry>& entries, sample::StreamId path);
  void AddView(Scope& scope, const spec::Entry& entry, sample::StreamId list);

  // sites.cc, joints.cc
  void AddSites(Scope& scope, const std::vector<spec::Entry>& entries, sample::StreamId sites);
  void AddSite(Scope& scope, const spec::Entry& entry, sample::StreamId sites);
  void AddRootJoints(Scope& scope);
  void AddJoints(Scope& scope, const std::vector<spec::Entry>& entries, sample::StreamId joints);
  void AddJoint(Scope& scope, const spec::Entry& entry, sample::StreamId joints);
  /// Notes the names of a spec's root joints, which attaching it removes.
  void TakeAwayJoints(Scope& scope);

  Body& body() { return object_.bodies[at_]; }

  Object object_;
  diag::Findings& findings_;
  Repetition repetition_;
  Assets assets_;
  References references_;
  Materials materials_;
  Sections sections_;
  Attacher attacher_;
  const spec::ObjectSpec* spec_ = nullptr;  // the object's own
  std::size_t at_ = 0;                      // the body that parts, sites and joints go into
  std::size_t part_count_ = 0;              // of all bodies
  std::size_t spec_count_ = 0;              // brought by parts and bodies
  bool is_full_ = false;
  std::unordered_map<std::string, int> bodies_;  // by full name
  std::vector<Position> positions_;              // those of inner specs first
};

}  // namespace mjforge::model
