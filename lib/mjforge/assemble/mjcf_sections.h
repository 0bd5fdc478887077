// Sections of MJCF in a spec: `contact:` and `mjcf:`.

#pragma once

#include <vector>

#include "mjforge/assemble/references.h"
#include "mjforge/assemble/repetition.h"
#include "mjforge/assemble/scope.h"

namespace mjforge::assemble {

/// Adds the elements of sections to one object.
class Sections {
 public:
  Sections(model::Object& object, Repetition& repetition, References& references,
           diag::Findings& findings)
      : object_(object), repetition_(repetition), references_(references), findings_(findings) {}

  /// Adds the sections of a spec, whose bodies must exist. Settings of the whole model are ignored,
  /// with a warning, unless the spec is the outermost one.
  void Add(Scope& scope, bool outermost);
  /// Returns the elements of a section, which is added if it is missing.
  std::vector<model::Element>& ElementsOf(const spec::SectionInfo& info);

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
