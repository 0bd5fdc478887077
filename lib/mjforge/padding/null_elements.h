// Elements that a model has and that have no effect.

#pragma once

#include <memory>

#include "mjforge/model/model.h"

namespace mjforge::padding {

/// Returns the centre of the largest colliding shape of a body, or its origin if no part collides,
/// m. An element there does not change the bounds of the body.
Eigen::Vector3d MiddleOf(const model::Body& body);

/// Returns a mesh like this one, but tiny.
std::unique_ptr<model::MeshAsset> NullMesh(const model::MeshAsset& mesh);

/// Makes a part null, with its centre at a point of the body. A part with a mesh has a null one.
void MakeNull(const Eigen::Vector3d& center, model::Part& part);
void MakeNull(const Eigen::Vector3d& center, model::Site& site);

}  // namespace mjforge::padding
