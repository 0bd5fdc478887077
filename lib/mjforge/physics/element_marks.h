// Lookup of parts, joints and other elements of an object by name, and of their places in the spec.
#pragma once

#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::physics {

/// Returns the part with the name of a geom; null if there is none.
const model::Part* PartOf(const model::Object& object, std::string_view geom);

/// Returns the place of a part in the spec; `usual` if the part is null or has no place.
diag::SourceMark PartMark(const model::Part* part, diag::SourceMark usual);

/// Returns the place of the body with this full name; `usual` if no such body has a place.
diag::SourceMark BodyMark(const model::Object& object, std::string_view name,
                          diag::SourceMark usual);

/// Returns the place of the joint with this full name; `usual` if no such joint has a place.
diag::SourceMark JointMark(const model::Object& object, std::string_view name,
                           diag::SourceMark usual);

/// Returns the place of the element of a section ("actuator") with this full name; `usual` if no
/// such element has a place.
diag::SourceMark ElementMark(const model::Object& object, std::string_view section,
                             std::string_view name, diag::SourceMark usual);

}  // namespace mjforge::physics
