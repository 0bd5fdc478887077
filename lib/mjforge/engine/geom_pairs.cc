// Mixes the contact parameters of geom pairs, and replaces the pairs of an mjModel by a list for
// one call of MuJoCo.
#include "mjforge/engine/geom_pairs.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
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

/// Replaces the pairs of a model by those of a GeomPairs during the lifetime of this object; does
/// nothing if `kTaken` (the value of kTakesPairs) is false.
template <class Model, bool kTaken>
class GeomPairs::ScopedPairs {
 public:
  ScopedPairs(Model& m, GeomPairs& pairs) : m_(m), before_(FieldsOf(m)) {
    FieldsOf(m) = std::tuple(kPairsOnly, static_cast<int>(pairs.geom1_.size()), pairs.geom1_.data(),
                             pairs.geom2_.data(), pairs.dim_.data(), pairs.signature_.data(),
                             pairs.margin_.data(), pairs.gap_.data(), pairs.friction_.data(),
                             pairs.solref_.data(), pairs.solimp_.data());
  }
  ~ScopedPairs() { FieldsOf(m_) = before_; }
  ScopedPairs(const ScopedPairs&) = delete;
  ScopedPairs& operator=(const ScopedPairs&) = delete;

 private:
  static auto FieldsOf(Model& m) {
    return std::tie(m.opt.collision, m.npair, m.pair_geom1, m.pair_geom2, m.pair_dim,
                    m.pair_signature, m.pair_margin, m.pair_gap, m.pair_friction, m.pair_solref,
                    m.pair_solimp);
  }

  Model& m_;
  std::tuple<int, int, int*, int*, int*, int*, mjtNum*, mjtNum*, mjtNum*, mjtNum*, mjtNum*> before_;
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

// Mixes the contact parameters of the geoms exactly like mj_collideGeoms
// (src/engine/engine_collision_driver.c, 2.2.2).
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
