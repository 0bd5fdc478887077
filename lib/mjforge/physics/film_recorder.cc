// Records positions of a simulation every 5 ms, and selects the positions of a film.
#include "mjforge/physics/film_recorder.h"

#include <algorithm>

namespace mjforge::physics {
namespace {

constexpr double kInterval = 0.005;  // s

}  // namespace

void FilmRecorder::Begin() {
  run_.clear();
  time_ = 0;
}

void FilmRecorder::Record(const mjModel& m, const mjData& d) {
  if (time_ >= kInterval * static_cast<double>(run_.size()))
    run_.emplace_back(d.qpos, d.qpos + m.nq);
  time_ += m.opt.timestep;
}

void FilmRecorder::Keep() {
  kept_time_ += time_;
  kept_.insert(kept_.end(), run_.begin(), run_.end());
  Begin();
}

Film FilmRecorder::Finish(std::size_t frames) const {
  Film film;
  film.time = kept_time_;
  const std::size_t count = std::min(frames, kept_.size());
  for (std::size_t i = 0; i < count; ++i)
    film.positions.push_back(kept_[count == 1 ? 0 : i * (kept_.size() - 1) / (count - 1)]);
  return film;
}

}  // namespace mjforge::physics
