// Couplings of joints: `couple:`, and the two joints of `screw:`.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mjforge/assemble/mjcf_sections.h"
#include "mjforge/assemble/references.h"
#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

/// Endings of the names of the slide and the hinge that form the thread of `screw:`.
inline constexpr std::string_view kRiseEnding = "_rise";
inline constexpr std::string_view kTurnEnding = "_turn";

/// Adds equalities of joints to one object, with parameters that make MuJoCo hold them stiffly.
class Couplings {
 public:
  Couplings(Sections& sections, References& references)
      : sections_(sections), references_(references) {}

  /// Adds the slide and the hinge of a thread to the body, and couples them. `turn` is the hinge
  /// with the entry's name, position and attributes. Adds nothing after a finding.
  void AddScrew(const Scope& scope, const FieldReader& reader, const spec::Entry& screw,
                model::Joint turn, model::Body& body);
  /// Couples the joint `follower` to the joint that `couple:` names.
  void AddCouple(const Scope& scope, const FieldReader& reader, const spec::Entry& couple,
                 const model::Joint& follower);

  /// Reports each leading joint that is neither a hinge nor a slide or, if the coupling has a
  /// `lead`, not a hinge. All joints must exist.
  void CheckLeaders(const model::Object& object, diag::Findings& findings) const;

 private:
  /// A joint that another one follows.
  struct Leader {
    std::string name;
    std::string shown;   // name in the spec
    bool turns = false;  // must be a hinge, because the coupling has a `lead`
    diag::SourceMark mark;
  };
  /// Adds the equality with this name and the solver parameters of the entry.
  void Add(const Scope& scope, FieldReader& reader, const spec::Entry& entry,
           const std::string& name, model::Element equality);

  Sections& sections_;
  References& references_;
  std::vector<Leader> leaders_;
};

}  // namespace mjforge::assemble
