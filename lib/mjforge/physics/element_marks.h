// Lookup of an object's parts, joints and other elements by name, and of their places in the spec.
#pragma once

#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::physics {

/// Returns the part from which the geom with this name was made; null if there is none.
const model::Part* PartOf(const model::Object& object, std::string_view geom);

/// Returns the place of a part in the spec; `usual` if the part is null or has no place.
diag::SourceMark PartMark(const model::Part* part, diag::SourceMark usual);

/// Returns the place of a body in the spec; `usual` if no body has this name or the body has no
/// place. `name` includes the object's prefix.
diag::SourceMark BodyMark(const model::Object& object, std::string_view name,
                          diag::SourceMark usual);

/// Returns the place of a joint in the spec; `usual` if no joint has this name or the joint has no
/// place. `name` includes the object's prefix.
diag::SourceMark JointMark(const model::Object& object, std::string_view name,
                           diag::SourceMark usual);

/// Returns the place of an element of an MJCF section ("actuator") in the spec; `usual` if no
/// element of the section has this name or the element has no place. `name` includes the object's
/// prefix.
diag::SourceMark ElementMark(const model::Object& object, std::string_view section,
                             std::string_view name, diag::SourceMark usual);

}  // namespace mjforge::physics
