// Convex cells of space, bounded by planes: clipping of polygons, and subtraction from polyhedra.

#pragma once

#include <vector>

#include <Eigen/Dense>

#include "mjforge/solid/outline.h"
#include "mjforge/solid/polytope.h"

namespace mjforge::solid {

/// Corners of a convex polygon in space, in order around the polygon, m.
using SpacePolygon = std::vector<Eigen::Vector3d>;

/// The points p with dot(normal, p) <= limit.
struct HalfSpace {
  Eigen::Vector3d normal;  // unit vector
  double limit = 0;        // m
};

/// Intersection of half-spaces, which may be unbounded, and its bounding box.
struct Cell {
  std::vector<HalfSpace> sides = {};
  Eigen::AlignedBox3d box;
};

/// Coordinate plane of a cross section: the axes of its two coordinates, and the axis perpendicular
/// to the plane. Axes 0, 1 and 2 are x, y and z.
struct SectionPlane {
  int u = 0;  // axis of the first coordinate of a Point2
  int v = 1;
  int axis = 2;

  /// Returns the point with the coordinates `p` in the plane and `along` on the third axis.
  Eigen::Vector3d At(const Point2& p, double along) const;
};
/// Planes of the cross sections of holes along x, y and z.
inline constexpr SectionPlane kSectionPlanes[] = {{1, 2, 0}, {0, 2, 1}, {0, 1, 2}};

/// Returns the cells of a convex partition of an area. Each cell is a convex polygon extruded
/// without end in both directions along the axis of `plane`.
std::vector<Cell> CellsOf(const Area& area, const SectionPlane& plane);

/// Returns the part of a polygon in a half-space; empty if there is none. Points up to `near`, m,
/// from the plane count as on the plane.
SpacePolygon Clipped(const SpacePolygon& polygon, const HalfSpace& half, double near);

/// Returns the area of a convex polygon, m^2.
double AreaOf(const SpacePolygon& polygon);

/// Returns true if the area of the polygon is at most its perimeter times `width`, m.
bool IsThin(const SpacePolygon& polygon, double width);

/// Returns the parts of the polygons for which the part translated by `offset` is in one of the
/// cells. The offset decides to which of two cells a polygon on their common plane belongs. Parts
/// thinner than the offset's length are rounding errors and are removed.
std::vector<SpacePolygon> ClippedByCells(const std::vector<SpacePolygon>& polygons,
                                         const std::vector<Cell>& cells,
                                         const Eigen::Vector3d& offset);

/// Removes the inside of a cell from polyhedra. Each polyhedron that the cell meets is cut into
/// convex parts along the cell's sides, one side after the other. Parts thinner than about `near`,
/// m, are dropped. Returns false if there are more than `most` parts; the polyhedra are then no
/// longer valid.
bool Subtract(const Cell& cell, std::vector<Polytope>& polyhedra, double near, std::size_t most);

}  // namespace mjforge::solid
