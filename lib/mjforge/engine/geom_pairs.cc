// Mixes contact parameters of geom pairs, and makes a model use a list of pairs for one call of
// MuJoCo.
#include "mjforge/engine/geom_pairs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace mjforge::engine {
namespace {

constexpr int kPairsOnly = 1;  // mjCOL_PAIR, which later releases do not have

/// Returns the weight, from 0 to 1, of the first geom's parameters in a contact.
mjtNum MixOf(mjtNum solmix1, mjtNum solmix2) {
  if (solmix1 >= mjMINVAL && solmix2 >= mjMINVAL) return solmix1 / (solmix1 + solmix2);
  if (solmix1 < mjMINVAL && solmix2 < mjMINVAL) return 0.5;
  return solmix1 < mjMINVAL ? 0 : 1;
}

template <std::size_t N>
std::array<mjtNum, N> Row(const mjtNum* array, int id) {
  std::array<mjtNum, N> row;
  std::copy_n(array + static_cast<std::ptrdiff_t>(N) * id, N, row.begin());
  return row;
}

template <std::size_t N>
std::array<mjtNum, N> Mixed(const mjtNum* array, int geom1, int geom2, mjtNum mix) {
  const std::array<mjtNum, N> first = Row<N>(array, geom1);
  std::array<mjtNum, N> mixed = Row<N>(array, geom2);
  for (std::size_t i = 0; i < N; ++i) mixed[i] = mix * first[i] + (1 - mix) * mixed[i];
  return mixed;
}

template <std::size_t N, class Better>
std::array<mjtNum, N> Best(const mjtNum* array, int geom1, int geom2, Better better) {
  std::array<mjtNum, N> best = Row<N>(array, geom1);
  const std::array<mjtNum, N> other = Row<N>(array, geom2);
  for (std::size_t i = 0; i < N; ++i) best[i] = better(best[i], other[i]);
  return best;
}

template <class Array>
void Append(std::vector<mjtNum>& list, const Array& row) {
  list.insert(list.end(), row.begin(), row.end());
}

}  // namespace

/// Makes a model use only the pairs of a GeomPairs during the lifetime of this object.
template <class Model, bool kTaken>
class GeomPairs::ScopedPairs {
 public:
  ScopedPairs(Model& m, GeomPairs& pairs) : m_(m), pairs_(pairs) { Swap(); }
  ~ScopedPairs() { Swap(); }
  ScopedPairs(const ScopedPairs&) = delete;
  ScopedPairs& operator=(const ScopedPairs&) = delete;

 private:
  void Swap() {
    std::swap(m_.opt.collision, mode_);
    std::swap(m_.npair, count_);
    std::swap(m_.pair_geom1, geom1_);
    std::swap(m_.pair_geom2, geom2_);
    std::swap(m_.pair_dim, dim_);
    std::swap(m_.pair_signature, signature_);
    std::swap(m_.pair_margin, margin_);
    std::swap(m_.pair_gap, gap_);
    std::swap(m_.pair_friction, friction_);
    std::swap(m_.pair_solref, solref_);
    std::swap(m_.pair_solimp, solimp_);
  }

  Model& m_;
  GeomPairs& pairs_;
  int mode_ = kPairsOnly;
  int count_ = static_cast<int>(pairs_.geom1_.size());
  int* geom1_ = pairs_.geom1_.data();
  int* geom2_ = pairs_.geom2_.data();
  int* dim_ = pairs_.dim_.data();
  int* signature_ = pairs_.signature_.data();
  mjtNum* margin_ = pairs_.margin_.data();
  mjtNum* gap_ = pairs_.gap_.data();
  mjtNum* friction_ = pairs_.friction_.data();
  mjtNum* solref_ = pairs_.solref_.data();
  mjtNum* solimp_ = pairs_.solimp_.data();
};

template <class Model>
class GeomPairs::ScopedPairs<Model, false> {
 public:
  ScopedPairs(Model& /*m*/, GeomPairs& /*pairs*/) {}
};

void GeomPairs::Clear() {
  for (std::vector<int>* list : {&geom1_, &geom2_, &dim_, &signature_}) list->clear();
  for (std::vector<mjtNum>* list : {&margin_, &gap_, &friction_, &solref_, &solimp_}) list->clear();
}

// Mixes the parameters exactly like mj_collideGeoms (src/engine/engine_collision_driver.c, 2.2.2).
void GeomPairs::Add(const mjModel& m, int geom1, int geom2) {
  if (m.geom_type[geom1] > m.geom_type[geom2]) std::swap(geom1, geom2);
  const int a = geom1;
  const int b = geom2;
  const auto larger = [](auto one, auto two) { return std::max(one, two); };
  const auto smaller = [](auto one, auto two) { return std::min(one, two); };
  std::array<mjtNum, 3> friction = Best<3>(m.geom_friction, a, b, larger);
  std::array<mjtNum, mjNREF> solref;
  std::array<mjtNum, mjNIMP> solimp;
  int dim = std::max(m.geom_condim[a], m.geom_condim[b]);
  if (m.geom_priority[a] != m.geom_priority[b]) {
    const int chief = m.geom_priority[a] > m.geom_priority[b] ? a : b;
    friction = Row<3>(m.geom_friction, chief);
    solref = Row<mjNREF>(m.geom_solref, chief);
    solimp = Row<mjNIMP>(m.geom_solimp, chief);
    dim = m.geom_condim[chief];
  } else {
    const mjtNum mix = MixOf(m.geom_solmix[a], m.geom_solmix[b]);
    const bool are_times = m.geom_solref[mjNREF * a] > 0 && m.geom_solref[mjNREF * b] > 0;
    solref = are_times ? Mixed<mjNREF>(m.geom_solref, a, b, mix)
                       : Best<mjNREF>(m.geom_solref, a, b, smaller);
    solimp = Mixed<mjNIMP>(m.geom_solimp, a, b, mix);
  }
  geom1_.push_back(a);
  geom2_.push_back(b);
  dim_.push_back(dim);
  signature_.push_back(0);  // ignored by MuJoCo in the mode kPairsOnly
  margin_.push_back(std::max(m.geom_margin[a], m.geom_margin[b]));
  gap_.push_back(std::max(m.geom_gap[a], m.geom_gap[b]));
  Append(friction_, std::array{friction[0], friction[0], friction[1], friction[2], friction[2]});
  Append(solref_, solref);
  Append(solimp_, solimp);
}

void GeomPairs::Step(mjModel& m, mjData& d) {
  [[maybe_unused]] const ScopedPairs<mjModel, kTakesPairs> scoped(m, *this);
  mj_step(&m, &d);
}

void GeomPairs::Collide(mjModel& m, mjData& d) {
  [[maybe_unused]] const ScopedPairs<mjModel, kTakesPairs> scoped(m, *this);
  mj_collision(&m, &d);
}

}  // namespace mjforge::engine
