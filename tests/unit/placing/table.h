// Fixture: a table on which bodies are placed.

#pragma once

#include <memory>

#include "mjforge/placing/placing.h"
#include "scene.h"

namespace mjforge::placing {

/// A table with its top at the height 0, on which bodies are placed one after the other.
class Table {
 public:
  Table() : region(BoxRegion(0.5, 0.3)), placer(MakePlacer()) {
    table = scene.Add(ShapeOf(model::GeomType::kBox, 0.5, 0.3, 0.05));
    scene.object.bodies.back().parts.back().X_BG = At(0, 0, -0.05);
  }

  model::PlaceTry Where(double u = 0, double v = 0) const {
    model::PlaceTry where;
    where.support = table;
    where.region = &region;
    where.uv = {u, v};
    return where;
  }

  /// Tries a place for a body, and lets it stand there if it fits.
  model::PlaceResult Place(int body, const model::PlaceTry& where, double clear = 0) {
    if (!has_begun_) {
      placer->Begin(scene.object);
      placer->AddObstacle(table);
      has_begun_ = true;
    }
    const model::PlaceResult result = placer->Try(body, where);
    if (result.verdict != model::PlaceVerdict::kStands) return result;
    scene.body(body).X_PB = scene.body(where.support).X_PB * result.X_SupportBody;
    placer->AddObstacle(body, clear);
    return result;
  }

  int AddBox(double x, double y, double z) {
    return scene.Add(ShapeOf(model::GeomType::kBox, x, y, z));
  }

  Scene scene;
  model::Region region;
  int table = -1;
  std::unique_ptr<model::Placer> placer;

 private:
  bool has_begun_ = false;
};

}  // namespace mjforge::placing
