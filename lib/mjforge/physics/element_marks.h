// Parts, joints and other elements of an object by their names, and their places in its spec.
#pragma once

#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::physics {

/// Returns the part that a geom with this name is; null if there is none.
const model::Part* PartOf(const model::Object& object, std::string_view geom);

/// Returns the place of a part, which may be null; `usual` if it has none.
diag::SourceMark PartMark(const model::Part* part, diag::SourceMark usual);

/// Returns the place of the body with this full name; `usual` if it has none.
diag::SourceMark BodyMark(const model::Object& object, std::string_view name,
                          diag::SourceMark usual);

/// Returns the place of the joint with this full name; `usual` if it has none.
diag::SourceMark JointMark(const model::Object& object, std::string_view name,
                           diag::SourceMark usual);

/// Returns the place of the element of a section ("actuator") with this full name; `usual` if it
/// has none.
diag::SourceMark ElementMark(const model::Object& object, std::string_view section,
                             std::string_view name, diag::SourceMark usual);

}  // namespace mjforge::physics
