#ifndef MJFORGE_MODEL_ASSEMBLY_H_
#define MJFORGE_MODEL_ASSEMBLY_H_

// One object in the making.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mjforge/model/assets.h"
#include "mjforge/model/field_reader.h"
#include "mjforge/model/field_set.h"
#include "mjforge/model/model.h"
#include "mjforge/model/repetition.h"

namespace mjforge::model {

/// A material of a spec, evaluated when the first part asks for it.
struct MaterialState {
  bool ready = false;
  int index = -1;  // in Object::materials; -1: it has no look
  std::optional<double> density;
  const spec::Field* density_field = nullptr;
  std::vector<Attribute> contact;
};

/// One spec whose elements go into the body: the object's own or a welded one.
struct Scope {
  Scope(sample::Evaluator& evaluator, std::string name_prefix, const Pose& X_BodyS);

  sample::Evaluator& values;
  std::string prefix;  // of its elements' names
  Pose X_BS;           // of the spec's root S in the body B
  sample::StreamId parts;
  std::vector<MaterialState> materials;  // as spec.materials
  std::optional<Eigen::Vector3d> total_size;
};

class Assembly {
 public:
  Assembly(Assembler& assembler, diag::Findings& findings)
      : findings_(findings), repetition_(findings), assets_(assembler, object_, findings) {}

  std::optional<Object> Run(sample::Evaluator& values, const Assembler::Options& options);

 private:
  // assembly.cc
  void AddSpec(Scope& scope);
  void AddParts(Scope& scope, const std::vector<spec::Entry>& entries, const Pose& X_SF);
  void AddFrame(Scope& scope, const spec::Entry& entry, const FieldSet& fields, const Pose& X_SF);
  void AddWeld(Scope& scope, const spec::Entry& entry, const FieldSet& fields, const Pose& X_SF);
  void ReadTotalSize(Scope& scope);
  void ScaleMass(Scope& scope, std::size_t first_part);

  // finish.cc
  void Finish(const Scope& scope);
  MassProperties MassOfBody();

  // parts.cc
  void AddPart(Scope& scope, const spec::Entry& entry, const FieldSet& fields, const Pose& X_SF);
  bool ReadMaterial(Scope& scope, FieldReader& reader, const FieldSet& fields, Part& part,
                    const MaterialState*& material);
  bool ReadMass(FieldReader& reader, const FieldSet& fields, const MaterialState* material,
                Part& part);
  bool SetMass(FieldReader& reader, std::optional<double> mass, Part& part);
  bool SetDensity(FieldReader& reader, const spec::Field& field, double density, Part& part);

  // sites.cc, joints.cc
  void AddSites(Scope& scope);
  void AddSite(Scope& scope, const spec::Entry& entry, const FieldSet& fields,
               sample::StreamId sites);
  void AddRootJoints(Scope& scope);
  void AddJoint(Scope& scope, const spec::Entry& entry, const FieldSet& fields,
                sample::StreamId joints);

  // materials.cc
  /// The material's state, evaluated; null after a finding.
  const MaterialState* UseMaterial(Scope& scope, FieldReader& reader, const spec::Field& field);
  void EvaluateMaterial(Scope& scope, const spec::Material& material, MaterialState& state);

  /// The entry's own name, checked; nothing after a finding.
  std::optional<std::string> ReadName(Scope& scope, const spec::Entry& entry,
                                      sample::StreamId list);
  bool HasErrorsSince(std::size_t first) const;
  Body& body() { return object_.bodies.front(); }

  Object object_;
  diag::Findings& findings_;
  Repetition repetition_;
  Assets assets_;
};

/// Reads attributes into `out`; false after a finding.
bool ReadAttributes(FieldReader& reader, const FieldSet::Attributes& fields,
                    std::vector<Attribute>& out);

/// The extents of the parts from `first` on, those that collide if any does.
Bounds BoundsOf(const std::vector<Part>& parts, std::size_t first = 0);

}  // namespace mjforge::model

#endif  // MJFORGE_MODEL_ASSEMBLY_H_
