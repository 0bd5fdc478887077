// Null elements: parts, sites and meshes that do not affect a simulation with the model.

#pragma once

#include <memory>

#include "mjforge/model/model.h"

namespace mjforge::padding {

/// Returns the centre, m, of the largest colliding part of a body, in the body's frame; the body's
/// origin if no part collides. A null element at this point does not change the body's bounds.
Eigen::Vector3d MiddleOf(const model::Body& body);

/// Returns a tiny copy of a mesh, with the same numbers of vertices and triangles.
std::unique_ptr<model::MeshAsset> NullMesh(const model::MeshAsset& mesh);

/// Make a part or site null (tiny, invisible, without mass and contact forces), with its centre at
/// the point `center`, m, in the body's frame. The mesh of a part, if any, must already be a
/// NullMesh().
void MakeNull(const Eigen::Vector3d& center, model::Part& part);
void MakeNull(const Eigen::Vector3d& center, model::Site& site);

}  // namespace mjforge::padding
