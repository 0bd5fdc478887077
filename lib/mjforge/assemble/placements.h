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
  std::optional<std::uint64_t> seed;  // additional seed, for places only
  std::set<std::string>& left_out;    // full names; optional bodies without a place are added
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
    std::string name;  // name in the spec
    int body = -1;
  };
  // A drawn place.
  struct Trial {
    std::string at;
    PlaceTarget target;
    model::PlaceTry where;
    bool is_drawn = false;  // another try may succeed, because it draws other values
  };

  void Place(const spec::BodyEntry& entry, sample::StreamId bodies);
  // place_piles.cc
  /// Adds the body to the pile in its region. A simulation brings the pile to rest later.
  void PileUp(const Request& request, sample::StreamId places);
  /// Returns the pile in the region of `trial`; adds the pile if it does not exist yet.
  model::Pile& PileAt(const Request& request, const Trial& trial, sample::StreamId places);
  /// Reads `order` and `time` of a pile.
  void ReadPile(const Request& request, sample::StreamId path, model::Pile& pile);
  /// Returns true, after adding a finding, if the body is in a pile: others cannot refer to it.
  bool IsPiled(const Request& request, int body, diag::SourceMark mark);
  void Settle(const Request& request, const Trial& trial, const model::PlaceResult& result);
  void GiveUp(const Request& request, const Trial& trial, const Misses& misses);
  /// Adds the body to the bodies that the next assembly leaves out; returns false if its entry does
  /// not allow that (`fewer:`).
  bool LeaveOut(const Request& request);

  // place_tries.cc
  /// Draws a place; returns nullopt after a finding, or if the body has been left out.
  std::optional<Trial> Draw(const Request& request, sample::StreamId path);
  /// Finds the region or site of `at:`, which must be on a body that has its place.
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
  /// Returns the index of a body named in a field; nullopt if the body does not have its place.
  std::optional<int> ReadBody(const Request& request, FieldReader& reader,
                              const spec::Field& field);
  /// Returns true if the body has its place. Otherwise adds a finding, unless the search failed.
  bool MustStand(const Request& request, int body, diag::SourceMark mark);
  bool MustBeLevel(const Request& request, const Trial& trial, diag::SourceMark mark);
  /// Returns "a -> b -> a" if bodies are placed on each other in a circle; otherwise an empty text.
  std::string CircleOf(std::string_view name) const;

  const model::Body& BodyAt(int index) const {
    return context_.object.bodies[static_cast<std::size_t>(index)];
  }
  const model::Pose& X_WB(int index) const { return X_WB_[static_cast<std::size_t>(index)]; }

  Scope& scope_;
  PlacementContext context_;
  PlaceNames names_;
  std::vector<model::Pose> X_WB_;  // poses of all bodies at present
  int posed_body_ = -1;            // body to which `stable_poses_` belong
  std::vector<model::StablePose> stable_poses_;
  std::size_t instances_ = 0;  // instances of the current entry; 0: unknown, because of `if`
  std::size_t standing_ = 0;   // instances of the current entry that have a place
};

}  // namespace mjforge::assemble
