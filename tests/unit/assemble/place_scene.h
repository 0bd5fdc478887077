// Fixture of the tests of places: a scene with a table, and a stand-in for the search, in which
// bodies are upright discs of one size.

#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "assembling.h"

namespace mjforge::assemble {

inline constexpr double kRadius = 0.05;

/// Search in which each body is an upright disc of the radius kRadius.
class DiscPlacer : public model::Placer {
 public:
  void Begin(const model::Object& object) override {
    object_ = &object;
    standing_.clear();
  }
  void AddObstacle(int body, double) override { standing_.push_back(body); }
  model::PlaceResult Try(int body, const model::PlaceTry& where) override {
    tries.push_back(where);
    model::PlaceResult result;
    result.footprint.setConstant(2 * kRadius);
    result.size.setConstant(2 * kRadius);
    if (where.region == nullptr) {
      result.X_SupportBody = where.X_SupportSite * where.X_BodySite.Inverse();
      return result;
    }
    const Eigen::Vector2d free = where.region->half_size.array() - kRadius;
    if (free.minCoeff() < 0) {
      result.verdict = model::PlaceVerdict::kTooLarge;
      return result;
    }
    const Eigen::Vector2d at = where.uv.cwiseProduct(free);
    result.X_SupportBody =
        where.region->X_BR * model::Pose{{at[0], at[1], 0}, model::FromEuler({0, 0, where.yaw})};
    const std::vector<model::Pose> X_WB = model::BodyPoses(*object_);
    const Eigen::Vector3d p_W =
        X_WB[static_cast<std::size_t>(where.support)] * result.X_SupportBody.p;
    for (const int other : standing_) {
      if (other == where.support || other == body) continue;
      if ((X_WB[static_cast<std::size_t>(other)].p - p_W).norm() >= 2 * kRadius) continue;
      result.verdict = model::PlaceVerdict::kBlocked;
      result.blocker = other;
    }
    return result;
  }
  int FindOverlap(int, const model::Pose&, const std::vector<int>&) override { return -1; }
  double WidestGap(int, const model::PlaceTry&) override { return 0.06; }
  std::vector<model::StablePose> StablePoses(int, double) override {
    return {{"upright", Eigen::Quaterniond::Identity(), 0.5, 0.75},
            {"upside_down", model::FromEuler({3, 0, 0}), 0.5, 0.25}};
  }

  std::vector<model::PlaceTry> tries;

 private:
  const model::Object* object_ = nullptr;
  std::vector<int> standing_;
};

/// A table whose surface is 0.8 x 0.6 m large and 0.7 m high, and bodies on it.
inline constexpr const char* kTable =
    "joints: none\n"
    "bodies:\n"
    "  - name: table\n"
    "    pos: [1, 0, 0]\n"
    "    regions: [{name: surface, type: box, size: [0.4, 0.3], pos: [0, 0, 0.7]}]\n"
    "    sites: [{name: hook, pos: [0, 0.3, 0.6]}]\n"
    "    parts: [{name: board, type: box, size: [0.4, 0.3, 0.01], pos: [0, 0, 0.69]}]\n";

/// Returns an entry of a body with these further keys.
inline std::string Ball(const std::string& keys) {
  return "  - {" + keys + ", parts: [{name: " + keys.substr(6, keys.find(',') - 6) +
         "_ball, type: sphere, size: 0.05}]}\n";
}

inline Assembler::Options WithSeed(std::optional<std::uint64_t> place_seed) {
  Assembler::Options options;
  options.place_seed = place_seed;
  return options;
}

/// The table with these further bodies, assembled.
struct Scene {
  explicit Scene(const std::string& bodies, std::uint64_t index = 0,
                 std::optional<std::uint64_t> place_seed = {})
      : assembling(kTable + bodies, 1, index, {}, WithSeed(place_seed), &placer) {}

  const model::Body& body(const std::string& name) const {
    const auto& bodies = assembling.object().bodies;
    const auto found = std::ranges::find(bodies, "thing_" + name, &model::Body::name);
    INFO(name);
    REQUIRE(found != bodies.end());
    return *found;
  }
  std::string finding() const {
    CHECK(assembling.failed());
    std::string all;
    for (const std::string& line : assembling.findings()) all += (all.empty() ? "" : "\n") + line;
    return all;
  }

  DiscPlacer placer;
  Assembling assembling;
};

}  // namespace mjforge::assemble
