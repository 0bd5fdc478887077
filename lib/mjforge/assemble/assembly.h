// Assembly of one object: adds the elements of a spec and its nested specs to a tree of bodies.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mjforge/assemble/assemble.h"
#include "mjforge/assemble/attacher.h"
#include "mjforge/assemble/chains.h"
#include "mjforge/assemble/couplings.h"
#include "mjforge/assemble/materials.h"
#include "mjforge/assemble/mjcf_sections.h"
#include "mjforge/assemble/references.h"
#include "mjforge/assemble/regions.h"
#include "mjforge/assemble/repetition.h"
#include "mjforge/assemble/starts.h"

namespace mjforge::assemble {

/// The state of one assembly. An instance builds one object.
class Assembly {
 public:
  /// Leaves out the bodies in `left_out`, and inserts optional bodies that find no place.
  Assembly(Assembler& assembler, std::set<std::string>& left_out, diag::Findings& findings)
      : findings_(findings),
        placer_(assembler.placer()),
        left_out_(left_out),
        repetition_(findings),
        assets_(assembler, object_, findings),
        attacher_({assembler.attachments(), object_, assets_, materials_, sections_, references_,
                   bodies_, findings}) {}

  std::optional<model::Object> Run(sample::Evaluator& values, const Assembler::Options& options);

 private:
  // assembly.cc. X_SF: pose, in the spec's frame S, of the frame F in which the entries are given.
  void AddSpec(Scope& scope);
  void AddParts(Scope& scope, const std::vector<spec::Entry>& entries, const model::Pose& X_SF);
  void AddFrame(Scope& scope, const spec::Entry& entry, const model::Pose& X_SF);
  void AddWeld(Scope& scope, const spec::Entry& entry, const model::Pose& X_SF);
  /// Counts of the elements of the current body, and the count of all bodies.
  struct ElementCounts {
    std::size_t parts, sites, regions, views, bodies;
  };
  /// Multiplies poses by X_BC from the left. Applies to the elements added after the counts `from`:
  /// parts, sites, regions and views of the current body, and bodies whose parent is `parent`.
  void Move(const model::Pose& X_BC, const ElementCounts& from, int parent);
  /// Returns true if `count` is less than kMaxParts. Otherwise returns false, now and in all later
  /// calls, and reports once that the object has too many `what` ("bodies").
  bool HasRoomFor(std::string_view what, std::size_t count, diag::SourceMark mark);
  void ReadTotalSize(Scope& scope);
  void ReadStartForm(Scope& scope);
  void ScaleObject(Scope& scope, std::size_t first_part, std::size_t first_body);

  // nested_specs.cc
  /// Returns an evaluator of the entry's spec, with its parameters set; nullopt after adding a
  /// finding.
  std::optional<sample::Evaluator> SampleNested(Scope& scope, const spec::Entry& entry,
                                                sample::StreamId path);

  // checks.cc
  void ReadChecks(Scope& scope);
  void ReadFitting(Scope& scope, const spec::Checks::Fitting& entry);
  void ReadGrasps(Scope& scope, const spec::Checks::Grasping& entry);
  void ReadPartCheck(Scope& scope, const spec::Checks::PartCheck& entry);
  void ReadJointCheck(Scope& scope, const spec::Checks::JointCheck& entry);

  // bodies.cc
  void AddBodies(Scope& scope);
  void AddBody(Scope& scope, const spec::BodyEntry& entry, sample::StreamId bodies);
  void AddBody(Scope& scope, const spec::BodyEntry& entry, const std::string& name,
               sample::StreamId bodies, const Link& link);
  /// Adds the entry's elements to the last body. Returns the body's bounds, empty if not needed.
  model::Bounds AddContents(Scope& scope, const spec::BodyEntry& entry, FieldReader& reader,
                            const std::string& name, const Link& link);
  void AddOwnJoints(const spec::BodyEntry& entry, const Link& link);
  /// Adds the parts, nested spec or MJCF body of the entry to the current body, the last of all.
  void FillBody(Scope& scope, const spec::BodyEntry& entry, FieldReader& reader,
                const std::string& name, const Link& link);
  void SetBodyPose(Scope& scope, FieldReader& reader, const spec::Entry& entry,
                   const model::Bounds& bounds, model::Body& body);
  int ParentOf(Scope& scope, FieldReader& reader, const spec::Entry& entry);
  /// Returns the angle of a spec's `front:` about z, rad, counter-clockwise from -y; 0 if missing.
  double FrontOf(Scope& scope);
  using JointedVisitor = std::function<void(const spec::BodyEntry&, std::size_t body)>;
  /// For each body with a list of joints: sets the loop variables of its entry, then calls `visit`.
  void ForEachJointed(Scope& scope, const JointedVisitor& visit);
  /// Returns the random stream of a body's joints.
  sample::StreamId JointsOf(const Scope& scope, std::size_t body) const;
  /// Adds the joints in `joints:` of each body. Expressions in it may use properties of all bodies.
  void AddListedJoints(Scope& scope);
  /// Sets the variables that expressions read as properties of a body: NAME.top, NAME.mass, ...
  void SetProperties(Scope& scope, const spec::BodyEntry& entry, const model::Bounds& bounds,
                     std::size_t index);
  void SetWholeProperties(Scope& scope);  // whole_properties.cc

  // placements.cc
  /// Places the bodies of the spec that have `place:`, in the order of their entries.
  void PlaceBodies(Scope& scope);
  void Finish(Scope& scope);  // finish.cc

  // positions.cc
  /// Converts a position to numbers of qpos of the joint. Returns nullopt, and adds a finding, if
  /// the joint cannot have this position. `what` names the position in messages ("pose").
  std::optional<sample::Numbers> ToQpos(std::string_view what, const RequestedPosition& position,
                                        const model::Joint& joint);
  void ReportUnknownJoint(std::string_view what, const RequestedPosition& position);

  // starts.cc
  /// Reads the start states in `pose:` of a spec into starts_.
  void ReadStarts(Scope& scope);
  void ReadStart(Scope& scope, const spec::Entry& entry, sample::StreamId pose);
  /// Applies the starts of the scope's spec, which are the items of starts_ from `first` on, to the
  /// current body and the bodies from `first_body` on. Starts of outer specs are applied later, so
  /// that they override the starts of inner specs.
  void ApplyStarts(const Scope& scope, std::size_t first, std::size_t first_body);
  void ApplyStart(const Scope& scope, const RequestedStart& start, model::Body& of,
                  model::Joint& joint);
  void ApplySetpoint(RequestedStart& start);
  /// Reports requested starts of joints and actuators that do not exist.
  void ReportLostStarts();

  // expectations.cc
  /// Evaluates the conditions of `expect:`, and adds its other entries to the object.
  void AddExpectations(Scope& scope);
  void AddExpectation(Scope& scope, const spec::Expectation& entry);
  /// Returns the full name of the body or part named `value`; nullopt after adding a finding.
  std::optional<std::string> FullName(Scope& scope, const spec::Value& value);
  void CheckCondition(Scope& scope, const spec::Expectation& entry);

  // parts.cc
  void AddPart(Scope& scope, const spec::Entry& entry, const model::Pose& X_SF);
  /// Adds the part to the current body. If `pieces` (poses in the part's frame) is not empty, only
  /// the pieces collide: the part becomes visual, or is left out if it has `role: collision`.
  void AddWithPieces(model::Part part, std::vector<model::Part> pieces);
  bool ReadMass(FieldReader& reader, const spec::Entry& entry, const MaterialState* material,
                model::Part& part);
  bool SetMass(FieldReader& reader, const std::optional<double>& mass, model::Part& part);

  // views.cc
  /// Adds cameras and lights to the current body; `path` is the random stream of the body.
  void AddViews(Scope& scope, const std::vector<spec::Entry>& entries, sample::StreamId path);
  void AddView(Scope& scope, const spec::Entry& entry, sample::StreamId list);

  // sites.cc
  void AddSites(Scope& scope, const std::vector<spec::Entry>& entries, sample::StreamId sites);
  void AddSite(Scope& scope, const spec::Entry& entry, sample::StreamId sites);
  // regions.cc
  /// Adds regions to the current body. Names of their sites: prefix, `owner` ("BODY_" or ""), name.
  void AddRegions(Scope& scope, const std::vector<spec::Entry>& entries, std::string_view owner,
                  sample::StreamId regions);
  void AddRegion(Scope& scope, const spec::Entry& entry, std::string_view owner,
                 sample::StreamId regions);
  /// Runs the searches for level faces in face_searches_ from index `first` on, and removes them.
  void SearchFaces(std::size_t first);
  // joints.cc
  void AddRootJoints(Scope& scope);
  void AddJoints(Scope& scope, const std::vector<spec::Entry>& entries, sample::StreamId joints);
  void AddJoint(Scope& scope, const spec::Entry& entry, sample::StreamId joints);
  /// Marks the root joints of a nested spec as removed: elements that refer to them are left out.
  void MarkRootJointsRemoved(Scope& scope);

  model::Body& body() { return object_.bodies[current_body_]; }

  model::Object object_;
  diag::Findings& findings_;
  model::Placer* placer_;
  std::optional<std::uint64_t> place_seed_;
  std::set<std::string>& left_out_;
  Repetition repetition_;
  Assets assets_;
  References references_{object_, findings_};
  Materials materials_{object_, assets_, findings_};
  Sections sections_{object_, repetition_, references_, findings_};
  Couplings couplings_{sections_, references_};
  Attacher attacher_;
  const spec::ObjectSpec* spec_ = nullptr;       // the outermost spec
  std::size_t current_body_ = 0;                 // index of the body to which elements are added
  std::size_t part_count_ = 0;                   // number of parts in all bodies
  std::size_t spec_count_ = 0;                   // count of specs used as parts (welded)
  bool is_full_ = false;                         // true after kMaxParts was exceeded and reported
  std::unordered_map<std::string, int> bodies_;  // body indices by full name
  std::vector<RequestedStart> starts_;           // start states of specs that are not complete yet
  std::vector<RequestedStart> lost_starts_;  // start states whose joint or actuator does not exist
  std::vector<FaceSearch> face_searches_;
  std::vector<EmptySearch> empty_searches_;
};

}  // namespace mjforge::assemble
