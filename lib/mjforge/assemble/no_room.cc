// Messages about bodies for which no place was found: sizes, and the blocking bodies.

#include "mjforge/assemble/no_room.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "mjforge/assemble/names.h"

namespace mjforge::assemble {
namespace {

using diag::Code;

// Largest number of blocking bodies that a message names.
constexpr std::size_t kMostNamed = 3;

// Returns a length given in m as text in cm, rounded to 0.1 mm.
std::string Cm(double length) { return expr::NumberText(std::round(length * 1e4) / 100); }

std::string Sizes(const Eigen::Vector2d& lengths) {
  return fmt::format("{} x {} cm", Cm(lengths[0]), Cm(lengths[1]));
}

std::string SizeOf(const model::Region& region) {
  std::string text = region.type == model::RegionType::kDisc
                         ? fmt::format("{} cm across", Cm(2 * region.half_size[0]))
                         : Sizes(2 * region.half_size);
  if (region.margin > 0) text += fmt::format(" with a margin of {} cm", Cm(region.margin));
  return text;
}

// Returns the bodies that blocked the most tries: "of 900 tries, 'plate_0' was in the way of 400,
// 'mug_1' of 120". A single body is described further.
std::string BlockersText(const NoRoom& facts, const Misses& misses) {
  std::vector<std::pair<std::string, std::size_t>> all(misses.blockers.begin(),
                                                       misses.blockers.end());
  std::ranges::stable_sort(all, std::greater<>(), &std::pair<std::string, std::size_t>::second);
  all.resize(std::min(all.size(), kMostNamed));
  if (all.size() == 1) {
    const std::string& only = all.front().first;
    if (misses.most_apart > 0)
      return fmt::format("{} would be {} cm away, and `clear` asks for more", Quoted(only),
                         Cm(misses.most_apart));
    if (only == facts.owner)
      return fmt::format("{} itself is in the way: the body would touch it above the region",
                         Quoted(only));
    return fmt::format("{} is in the way", Quoted(only));
  }
  std::string text;
  for (const auto& [name, times] : all) {
    text += text.empty() ? fmt::format("of {} tries, {} was in the way of {}", misses.count,
                                       Quoted(name), times)
                         : fmt::format(", {} of {}", Quoted(name), times);
  }
  return text;
}

void ReportCrowded(const NoRoom& facts, const Misses& misses, diag::Finding& finding) {
  const std::string place = facts.has_uv           ? "at its `uv` in "
                            : facts.beside.empty() ? "at "
                                                   : "beside " + Quoted(facts.beside) + " at ";
  finding.message =
      fmt::format("no room for body {} {}{}", Quoted(facts.body), place, Quoted(facts.at));
  if (facts.region != nullptr) {
    finding.message +=
        fmt::format(", {}: it needs {}", SizeOf(*facts.region), Sizes(misses.size.head<2>()));
    if (facts.clear > 0) finding.message += fmt::format(" and {} cm around it", Cm(facts.clear));
    if (facts.widest_gap) {
      finding.message += fmt::format("; the widest gap is {} cm across",
                                     Cm(std::floor(1000 * *facts.widest_gap) / 1000));
    }
    if (facts.instances > 1) {
      finding.message +=
          fmt::format("; {} of {} have found a place", facts.standing, facts.instances);
    }
  }
  if (!misses.blockers.empty()) finding.hint = BlockersText(facts, misses) + "; ";
  finding.hint += "make room, or leave out what finds none with `fewer: true`";
}

}  // namespace

void Misses::Add(const model::PlaceResult& result, const PlaceNames& names) {
  if (++count == 1 || result.footprint.prod() < footprint.prod()) footprint = result.footprint;
  size = result.size;
  ++verdicts[result.verdict];
  if (result.verdict != model::PlaceVerdict::kBlocked || result.blocker < 0) return;
  ++blockers[names.NameOf(result.blocker)];
  most_apart = std::max(most_apart, result.distance);
}

bool Misses::AreAll(model::PlaceVerdict verdict) const {
  const auto found = verdicts.find(verdict);
  return found != verdicts.end() && found->second == count;
}

void ReportNoRoom(const NoRoom& facts, const Misses& misses, diag::Findings& findings) {
  diag::Finding& finding = findings.Add(Code::kModelNoRoom, facts.mark, {});
  if (facts.target) finding.notes.push_back({facts.target, "the place is described here"});
  const std::string body = Quoted(facts.body);
  const std::string at = Quoted(facts.at);
  if (misses.AreAll(model::PlaceVerdict::kTooLarge)) {
    finding.message =
        fmt::format("body {} is larger than {}: it stands on {}, and the region is {}", body, at,
                    Sizes(misses.footprint), SizeOf(*facts.region));
    finding.hint = "a smaller body, a larger region, or a share that may lie outside: `overhang`";
  } else if (misses.AreAll(model::PlaceVerdict::kTooHigh)) {
    finding.message =
        fmt::format("body {} is {} cm high, too high for {}, which has {} cm of free height", body,
                    Cm(misses.size.z()), at, Cm(facts.region->height));
    finding.hint = "a lower body, or another way of `lying`";
  } else if (misses.AreAll(model::PlaceVerdict::kOutside)) {
    finding.message = facts.beside.empty()
                          ? fmt::format("the place of body {} is outside of {}", body, at)
                          : fmt::format("the place of body {} beside {} is outside of {}", body,
                                        Quoted(facts.beside), at);
    finding.hint = fmt::format("the region is {}", SizeOf(*facts.region));
  } else {
    ReportCrowded(facts, misses, finding);
  }
}

}  // namespace mjforge::assemble
