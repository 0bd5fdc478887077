#pragma once

// One object in the making.

#include <array>
#include <cstddef>
#include <map>
#include <memory_resource>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mjforge/model/assets.h"
#include "mjforge/model/field_reader.h"
#include "mjforge/model/model.h"
#include "mjforge/model/references.h"
#include "mjforge/model/repetition.h"

namespace mjforge::model {

/// A material of a spec, evaluated when the first part asks for it.
struct MaterialState {
  bool ready = false;
  int index = -1;  // in Object::materials; -1: it has no look
  std::optional<Traced<double>> density;
  const spec::Field* density_field = nullptr;
  std::vector<Attribute> contact;
};

/// One spec in the object: its own, one welded into a body, or one that is a body.
struct Scope {
  Scope(sample::Evaluator& evaluator, std::string name_prefix, int root, const Pose& X_BodyS);

  sample::Evaluator& values;
  std::string prefix;  // of its elements' names
  int body;            // in Object::bodies, that holds the spec's root
  Pose X_BS;           // of the spec's root S in the body B at hand
  sample::StreamId parts;
  std::vector<MaterialState> materials;  // as spec.materials
  std::optional<Traced<Eigen::Vector3d>> total_size;
};

class Renamer;  // attached.cc

class Assembly {
 public:
  Assembly(Assembler& assembler, diag::Findings& findings)
      : findings_(findings),
        repetition_(findings),
        assets_(assembler, object_, findings, scratch_),
        references_(object_, findings),
        attachments_(assembler.attachments()) {}

  std::optional<Object> Run(sample::Evaluator& values, const Assembler::Options& options);

 private:
  // assembly.cc
  void AddSpec(Scope& scope);
  void AddParts(Scope& scope, const std::vector<spec::Entry>& entries, const Pose& X_SF);
  void AddFrame(Scope& scope, const spec::Entry& entry, const Pose& X_SF);
  void AddWeld(Scope& scope, const spec::Entry& entry, const Pose& X_SF);
  // nested.cc
  /// The values of the spec that an entry brings, with the entry's parameters set; null after a
  /// finding.
  std::shared_ptr<sample::Evaluator> SampleNested(Scope& scope, const spec::Entry& entry,
                                                  sample::StreamId path);
  void ReadTotalSize(Scope& scope);
  void ReadChecks(Scope& scope);  // checks.cc
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

  // attached.cc
  void AddAttachment(Scope& scope, FieldReader& reader, const spec::Entry& entry,
                     const std::string& name, std::size_t index);
  void CopyAssets(const Attachment& attachment, Renamer& renamer);
  /// The first body becomes the body `index`.
  void CopyBodies(const Attachment& attachment, const Renamer& renamer, std::size_t index);
  void CopySections(const Attachment& attachment, const Renamer& renamer);
  void AddReferences(References::Place place, const Element& own, const Element& element);

  // sections.cc
  void AddSections(Scope& scope);
  void AddElement(Scope& scope, const spec::SectionInfo& section, const spec::Entry& entry,
                  sample::StreamId path);
  bool ReadElement(Scope& scope, FieldReader& reader, const spec::Entry& entry, Element& element,
                   References::Place place);
  std::vector<Element>& SectionOf(const spec::SectionInfo& info);
  bool IsOutermost(const Scope& scope) const { return &scope.values.spec() == spec_; }

  // finish.cc
  void Finish(const Scope& scope);
  /// Sums up the mass of a body's parts, unless an attached file states it.
  void SetMass(std::size_t index);
  void ScaleMass(const Traced<double>& factor, std::size_t first_part, std::size_t first_body);
  /// Of the body `first` and all bodies below it (all that follow), in the frame of `first`, with
  /// all joints at zero.
  Bounds BoundsFrom(std::size_t first) const;
  MassProperties MassFrom(std::size_t first) const;
  /// A body with joints that has no mass takes half the mass of the first body fixed to it.
  void ShareMass();
  void CheckMass();

  // parts.cc
  void AddPart(Scope& scope, const spec::Entry& entry, const Pose& X_SF);
  bool ReadMaterial(Scope& scope, FieldReader& reader, const spec::Entry& entry, Part& part,
                    const MaterialState*& material);
  bool ReadMass(FieldReader& reader, const spec::Entry& entry, const MaterialState* material,
                Part& part);
  bool SetMass(FieldReader& reader, const std::optional<Traced<double>>& mass, Part& part);
  bool SetDensity(FieldReader& reader, const spec::Field& field, const Traced<double>& density,
                  Part& part);

  // sites.cc, joints.cc
  void AddSites(Scope& scope, const std::vector<spec::Entry>& entries, sample::StreamId sites);
  void AddSite(Scope& scope, const spec::Entry& entry, sample::StreamId sites);
  void AddRootJoints(Scope& scope);
  void AddJoints(Scope& scope, const std::vector<spec::Entry>& entries, sample::StreamId joints);
  void AddJoint(Scope& scope, const spec::Entry& entry, sample::StreamId joints);
  /// Notes the names of a spec's root joints, which attaching it removes.
  void TakeAwayJoints(Scope& scope);

  // materials.cc
  /// The material's state, evaluated; null after a finding.
  const MaterialState* UseMaterial(Scope& scope, FieldReader& reader, const spec::Field& field);
  void EvaluateMaterial(Scope& scope, const spec::Material& material, MaterialState& state);
  /// The index of an equal material with that own name; otherwise adds this one and returns its
  /// index. `own_name` must outlive the assembly.
  int ShareMaterial(const std::string& own_name, Material material);

  /// The entry's own name, checked; nothing after a finding.
  std::optional<std::string> ReadName(Scope& scope, const spec::Entry& entry,
                                      sample::StreamId list);
  Body& body() { return object_.bodies[at_]; }
  Body& BodyAt(int index) { return object_.bodies[static_cast<std::size_t>(index)]; }

  // Memory for many small pieces that live as long as the assembly.
  std::array<std::byte, 2048> first_scratch_;
  std::pmr::monotonic_buffer_resource scratch_{first_scratch_.data(), first_scratch_.size()};

  Object object_;
  diag::Findings& findings_;
  Repetition repetition_;
  Assets assets_;
  References references_;
  AttachmentSource* attachments_;
  const spec::ObjectSpec* spec_ = nullptr;       // the object's own
  std::size_t at_ = 0;                           // the body that parts, sites and joints go into
  std::size_t part_count_ = 0;                   // of all bodies
  std::unordered_map<std::string, int> bodies_;  // by full name
  std::pmr::unordered_multimap<std::string_view, int> materials_{&scratch_};  // by own name
  std::map<std::pair<std::filesystem::path, std::string>, const Attachment*> attached_;
};

/// Reads an element's own attributes into `out`, then adds those of its material and of the
/// defaults that it lacks; false after a finding.
bool ReadAttributes(FieldReader& reader, const spec::Entry& entry, std::vector<Attribute>& out,
                    std::span<const Attribute> of_material = {});

/// placement: corner. `p` is where the lower corner of something should be, counted from that of
/// the declared box, with half sizes `total_size`; `lower` is the corner seen from the thing's
/// origin. Where the origin is then.
Traced<Eigen::Vector3d> FromCorner(const Traced<Eigen::Vector3d>& p,
                                   const Traced<Eigen::Vector3d>& total_size,
                                   const Traced<Eigen::Vector3d>& lower);

/// The extents of the parts from `first` on; only of those that collide, if any does.
Bounds BoundsOf(const std::vector<Part>& parts, std::size_t first = 0);

bool HasErrorsSince(const diag::Findings& findings, std::size_t first);

}  // namespace mjforge::model
