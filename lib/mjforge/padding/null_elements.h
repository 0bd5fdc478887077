// Elements that a model has and that have no effect.

#pragma once

#include <optional>

#include "mjforge/model/model.h"

namespace mjforge::padding {

/// Returns the centre of the largest convex shape of a body that collides, m; nothing if no part
/// collides. An element this deep inside the body is touched only by what penetrates the body.
std::optional<Eigen::Vector3d> DeepestPoint(const model::Body& body);

/// Returns a mesh like this one with a size of kNullSize.
std::unique_ptr<model::MeshAsset> NullMesh(const model::MeshAsset& mesh);

/// Makes a part null, with its centre at a point of the body. A part with a mesh has a null one.
void MakeNull(const Eigen::Vector3d& center, model::Part& part);
void MakeNull(const Eigen::Vector3d& center, model::Site& site);

}  // namespace mjforge::padding
