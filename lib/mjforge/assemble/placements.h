// Search for places of a spec's bodies with `place:`: draws poses, and stores the first free pose.

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

/// Members of an Assembly that Placements uses.
struct PlacementContext {
  model::Object& object;
  const std::unordered_map<std::string, int>& bodies;  // indices by full name
  Repetition& repetition;
  model::Placer& placer;
  std::optional<std::uint64_t> seed;  // additional seed for the draws of places
  std::set<std::string>& left_out;    // full names; LeaveOut() adds bodies
  diag::Findings& findings;
};

/// Places the bodies of the scope's spec that have `place:`, in the order of their entries. Bodies
/// that have no place yet are children of the world.
class Placements {
 public:
  Placements(Scope& scope, PlacementContext context)
      : scope_(scope), context_(context), names_(context.object, context.bodies, scope) {}

  void Run();

 private:
  // A body for which a place is searched.
  struct Request {
    const spec::BodyEntry& entry;
    std::string name;  // name in the spec
    int body = -1;
  };
  // An attempt to place a body: the name in `at:`, its region or site, and the drawn values.
  struct Trial {
    std::string at;
    PlaceTarget target;
    model::PlaceTry where;
    bool is_drawn = false;  // true: another try may succeed, because it draws other values
  };

  void Place(const spec::BodyEntry& entry, sample::StreamId bodies);
  // place_piles.cc
  /// Adds the body to the pile in its region. The whole pile is simulated later, until it rests.
  void PileUp(const Request& request, sample::StreamId places);
  /// Returns the pile in the region of `trial`. Adds the pile if it does not exist yet.
  model::Pile& PileAt(const Request& request, const Trial& trial, sample::StreamId places);
  /// Reports the entry of `request` if its `order` or `time` differs from those of the pile, which
  /// are set by the first entry that adds a body to the pile.
  void CheckPile(const Request& request, const model::Pile& pile, sample::StreamId places);
  /// Reads `order` and `time` of a pile.
  void ReadPile(const Request& request, sample::StreamId path, model::Pile& pile);
  /// Returns true, and adds a finding, if `body`, to which the request refers, is in a pile. Bodies
  /// in piles have no place yet.
  bool IsPiled(const Request& request, int body, diag::SourceMark mark);
  void Settle(const Request& request, const Trial& trial, const model::PlaceResult& result);
  /// Returns false, and adds a finding, if the body stands at the point that it must face, because
  /// the direction to this point would be a rounding error.
  bool HasHeading(const Request& request, const Trial& trial, const model::PlaceResult& result);
  void GiveUp(const Request& request, const Trial& trial, const Misses& misses);
  // swept_places.cc
  /// Warns of joints that move a part of a body against an object that stands on the same body: a
  /// door that sweeps over the region in front of it.
  void WarnOfSweptPlaces();
  void WarnOfSweep(std::size_t body, std::size_t joint, const std::vector<int>& standing);
  /// If the entry has `fewer: true`, inserts the body into PlacementContext::left_out, so that the
  /// next assembly leaves the body out, and returns true. Otherwise returns false.
  bool LeaveOut(const Request& request);

  // place_reader.cc
  /// Draws a place. Returns nullopt after adding a finding, or if the body has been left out.
  std::optional<Trial> Draw(const Request& request, sample::StreamId path);
  /// Finds the region or site of `at:`, which must belong to a body that already has its place.
  bool ReadTarget(const Request& request, FieldReader& reader, Trial& trial);
  bool ReadSites(const Request& request, FieldReader& reader, Trial& trial);
  bool ReadArea(const Request& request, FieldReader& reader, sample::StreamId path, Trial& trial);
  bool ReadPosition(const Request& request, FieldReader& reader, sample::StreamId path,
                    Trial& trial);
  /// Draws a position: x and y from -1 to 1, or a point of the unit disc.
  Eigen::Vector2d DrawPosition(bool in_disc, sample::StreamId path) const;
  bool ReadBeside(const Request& request, sample::StreamId path, Trial& trial);
  bool ReadFacing(const Request& request, FieldReader& reader, model::PlaceTry& where);
  bool ReadLying(const Request& request, FieldReader& reader, sample::StreamId path, Trial& trial);
  /// Returns the stable poses of the body to place, computed at the first call for this body.
  const std::vector<model::StablePose>& StablePosesOf(const Request& request);
  /// Returns the index of the body that a field names. Returns nullopt, and adds a finding, if the
  /// body does not exist or does not have its place yet (see CheckPlaced()).
  std::optional<int> ReadBody(const Request& request, FieldReader& reader,
                              const spec::Field& field);
  /// Returns true if the body, which `field` names, already has its place. Otherwise adds a
  /// finding, unless it was already reported that no place was found for the body.
  bool CheckPlaced(const Request& request, int body, const spec::Field& field);
  bool CheckRegionIsLevel(const Request& request, const Trial& trial, diag::SourceMark mark);
  /// Returns "a -> b -> a" if bodies are placed on or beside each other in a circle; otherwise an
  /// empty text.
  std::string CircleOf(const std::string& name) const;
  /// Returns the names of the bodies on which and beside which a body of this spec is placed.
  std::vector<std::string> NamesInPlaceOf(std::string_view name) const;

  const model::Body& BodyAt(int index) const {
    return context_.object.bodies[static_cast<std::size_t>(index)];
  }
  const model::Pose& X_WB(int index) const { return X_WB_[static_cast<std::size_t>(index)]; }

  Scope& scope_;
  PlacementContext context_;
  PlaceNames names_;
  std::vector<model::Pose> X_WB_;  // poses of all bodies in the world, updated by Settle()
  int posed_body_ = -1;            // index of the body whose poses are in `stable_poses_`
  std::vector<model::StablePose> stable_poses_;
  // Count of instances of the current entry; 0 if unknown because of `if`.
  std::size_t instances_ = 0;
  std::size_t standing_ = 0;  // count of instances of the current entry that have a place
  std::vector<int> placed_;   // indices of the bodies that have a place
};

}  // namespace mjforge::assemble
