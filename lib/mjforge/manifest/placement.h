// The placement of a variant, placement.json: the files and poses of the objects of a scene.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"

namespace mjforge::manifest {

/// An object of a scene, which has a file of its own.
struct PlacedFile {
  std::string name;
  std::string file;  // path from the folder of placement.json
  model::Pose pose;  // pose of the object's root body in the scene at the start
  std::string at;    // region or site where `place:` put the object; empty: no `place:`
  bool is_free = false;
  /// For each joint other than a free root joint: its name in the file, and its numbers in qpos at
  /// the start.
  std::vector<std::pair<std::string, sample::Numbers>> joints;
};

struct Placement {
  mjcf::Provenance provenance;
  std::vector<PlacedFile> objects;
  std::vector<model::Element> options;  // MJCF's <option> of the scene; at most one
};

/// Appends a number as in MJCF files: with at most 10 digits; magnitudes below 1e-15, rounding
/// errors of rotations, become 0. A pose therefore has the same text on all processors, although
/// the last bits of its numbers differ between processors with and without fused multiply-add.
void AppendFileNumber(std::string& out, double value);

/// Returns the placement as JSON, with a line for each object.
std::string PlacementText(const Placement& placement);

/// Returns the JSON Schema of a placement, the text of schemas/placement.schema.json.
std::string PlacementSchema();

}  // namespace mjforge::manifest
