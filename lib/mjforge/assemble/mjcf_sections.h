// Elements of MJCF sections that a spec contains in `contact:` and `mjcf:`.

#pragma once

#include <vector>

#include "mjforge/assemble/references.h"
#include "mjforge/assemble/repetition.h"
#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

/// Adds the elements of MJCF sections to one object.
class Sections {
 public:
  Sections(model::Object& object, Repetition& repetition, References& references,
           diag::Findings& findings)
      : object_(object), repetition_(repetition), references_(references), findings_(findings) {}

  /// Adds the MJCF sections of a spec, whose bodies must all exist already. Adds sections with
  /// settings of the whole model (`option`) only if the spec is the outermost one; otherwise adds a
  /// warning.
  void Add(Scope& scope, bool outermost);
  /// Returns the elements of a section. Adds the section to the object if the object does not have
  /// it.
  std::vector<model::Element>& ElementsOf(const spec::SectionInfo& info) {
    return model::ElementsOf(info, object_.sections);
  }

 private:
  void AddElement(Scope& scope, const spec::SectionInfo& section, const spec::Entry& entry,
                  sample::StreamId path);
  bool ReadElement(Scope& scope, FieldReader& reader, const spec::Entry& entry,
                   model::Element& element, References::ElementPlace place);

  model::Object& object_;
  Repetition& repetition_;
  References& references_;
  diag::Findings& findings_;
};

}  // namespace mjforge::assemble
