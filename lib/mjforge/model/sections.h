#pragma once

#include <vector>

#include "mjforge/model/references.h"
#include "mjforge/model/repetition.h"
#include "mjforge/model/scope.h"

namespace mjforge::model {

/// contact: and mjcf: of specs, once the bodies are there.
class Sections {
 public:
  Sections(Object& object, Repetition& repetition, References& references, diag::Findings& findings)
      : object_(object), repetition_(repetition), references_(references), findings_(findings) {}

  /// Those of a spec; `outermost`: it is the object's own.
  void Add(Scope& scope, bool outermost);
  /// The elements of a section, which is added if it is missing.
  std::vector<Element>& Of(const spec::SectionInfo& info);

 private:
  void AddElement(Scope& scope, const spec::SectionInfo& section, const spec::Entry& entry,
                  sample::StreamId path);
  bool ReadElement(Scope& scope, FieldReader& reader, const spec::Entry& entry, Element& element,
                   References::Place place);

  Object& object_;
  Repetition& repetition_;
  References& references_;
  diag::Findings& findings_;
};

}  // namespace mjforge::model
