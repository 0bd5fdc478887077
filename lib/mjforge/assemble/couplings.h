// Couplings of joints: `couple:`, and the two coupled joints of `screw:`.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mjforge/assemble/mjcf_sections.h"
#include "mjforge/assemble/references.h"
#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

/// Suffixes of the names of the two joints that `screw:` makes: the slide and the hinge.
inline constexpr std::string_view kRiseEnding = "_rise";
inline constexpr std::string_view kTurnEnding = "_turn";

/// Adds equalities between joints to one object, with solver parameters that make them stiff.
class Couplings {
 public:
  Couplings(Sections& sections, References& references)
      : sections_(sections), references_(references) {}

  /// Adds the slide and the hinge of a screw to the body, and couples them. `turn` is the hinge
  /// with the name, position and attributes of the joint's entry. Adds neither joint if a field is
  /// invalid.
  void AddScrew(const Scope& scope, const FieldReader& reader, const spec::Entry& screw,
                model::Joint turn, model::Body& body);
  /// Couples the joint `follower` to the joint that `couple:` names (the leader).
  void AddCouple(const Scope& scope, const FieldReader& reader, const spec::Entry& couple,
                 const model::Joint& follower);

  /// Reports each leader that is neither a hinge nor a slide, and each slide that leads a coupling
  /// with `lead`. Call CheckLeaders() after all joints were added.
  void CheckLeaders(const model::Object& object, diag::Findings& findings) const;

 private:
  /// A joint that another joint follows because of a coupling.
  struct Leader {
    std::string name;
    std::string shown;   // name in the spec
    bool turns = false;  // true: the leader must be a hinge, because of `lead`
    diag::SourceMark mark;
  };
  /// Adds the equality, with this name, to the object. MJCF attributes of the entry, such as
  /// `solimp`, replace those of `equality`.
  void Add(const Scope& scope, FieldReader& reader, const spec::Entry& entry,
           const std::string& name, model::Element equality);

  Sections& sections_;
  References& references_;
  std::vector<Leader> leaders_;
};

}  // namespace mjforge::assemble
