// Placing of the bodies of one spec that have `place:`: draws of their tries, and their results.

#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "mjforge/assemble/no_room.h"
#include "mjforge/assemble/place_names.h"
#include "mjforge/assemble/repetition.h"

namespace mjforge::assemble {

/// Members of the assembly that placing needs.
struct PlacementContext {
  model::Object& object;
  const std::unordered_map<std::string, int>& bodies;  // indices by full name
  Repetition& repetition;
  model::Placer& placer;
  std::optional<std::uint64_t> seed;  // seed of the places alone
  std::set<std::string>& left_out;    // full names of bodies; those without room are added
  diag::Findings& findings;
};

/// Places the bodies of the spec of a scope, in the order of their entries. Bodies that wait for
/// their place are children of the world.
class Placements {
 public:
  Placements(Scope& scope, PlacementContext context)
      : scope_(scope), context_(context), names_(context.object, context.bodies, scope) {}

  void Run();

 private:
  // A body that needs a place.
  struct Request {
    const spec::BodyEntry& entry;
    std::string name;  // in the spec
    int body = -1;
  };
  // A drawn place.
  struct Trial {
    std::string at;
    PlaceTarget target;
    model::PlaceTry where;
    bool is_drawn = false;  // another try has other values
  };

  void Place(const spec::BodyEntry& entry, sample::StreamId bodies);
  // place_piles.cc
  /// Adds the body to the pile in its region, from which a simulation takes it.
  void PileUp(const Request& request, sample::StreamId places);
  /// Returns the pile in the region of a place, which is added if it is the first of its bodies.
  model::Pile& PileAt(const Request& request, const Trial& trial, sample::StreamId places);
  /// Reads `order` and `time` of a pile.
  void ReadPile(const Request& request, sample::StreamId path, model::Pile& pile);
  /// Returns true if the body is in a pile, so that nothing can be placed by it; adds a finding.
  bool IsPiled(const Request& request, int body, diag::SourceMark mark);
  void Settle(const Request& request, const Trial& trial, const model::PlaceResult& result);
  void GiveUp(const Request& request, const Trial& trial, const Misses& misses);
  /// Notes that the object must be assembled without the body; returns false if that is not
  /// allowed.
  bool LeaveOut(const Request& request);

  // place_tries.cc
  /// Draws a place; returns nothing after a finding, or if the body has been left out.
  std::optional<Trial> Draw(const Request& request, sample::StreamId path);
  /// Finds the region or site of `at:`, which must be on a body that stands.
  bool ReadTarget(const Request& request, FieldReader& reader, Trial& trial);
  bool ReadSites(const Request& request, FieldReader& reader, Trial& trial);
  bool ReadYaw(const Request& request, FieldReader& reader, Trial& trial);
  bool ReadArea(const Request& request, FieldReader& reader, sample::StreamId path, Trial& trial);
  bool ReadPosition(const Request& request, FieldReader& reader, sample::StreamId path,
                    Trial& trial);
  /// Draws a position from -1 to 1 on both axes, or in the unit disc.
  Eigen::Vector2d DrawPosition(bool in_disc, sample::StreamId path) const;
  bool ReadBeside(const Request& request, sample::StreamId path, Trial& trial);
  bool ReadFacing(const Request& request, FieldReader& reader, model::PlaceTry& where);
  bool ReadLying(const Request& request, FieldReader& reader, sample::StreamId path, Trial& trial);
  /// Returns the stable poses of the body, which are computed at its first try.
  const std::vector<model::StablePose>& StablePosesOf(const Request& request);
  /// Returns the index of a body named in a field, which must stand.
  std::optional<int> ReadBody(const Request& request, FieldReader& reader,
                              const spec::Field& field);
  /// Returns true if a body stands. Otherwise adds a finding, unless its place was not found.
  bool MustStand(const Request& request, int body, diag::SourceMark mark);
  bool MustBeLevel(const Request& request, const Trial& trial, diag::SourceMark mark);
  /// Returns "a -> b -> a" if the places of entries lead from one back to itself.
  std::string CircleOf(std::string_view name) const;

  const model::Body& BodyAt(int index) const {
    return context_.object.bodies[static_cast<std::size_t>(index)];
  }
  const model::Pose& X_WB(int index) const { return X_WB_[static_cast<std::size_t>(index)]; }

  Scope& scope_;
  PlacementContext context_;
  PlaceNames names_;
  std::vector<model::Pose> X_WB_;  // poses of all bodies at present
  int posed_body_ = -1;            // the body of `stable_poses_`
  std::vector<model::StablePose> stable_poses_;
  std::size_t instances_ = 0;  // number for the current entry; 0 if it has a condition
  std::size_t standing_ = 0;   // bodies of the current entry
};

}  // namespace mjforge::assemble
