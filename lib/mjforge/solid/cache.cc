#include "mjforge/solid/solid.h"

#include <algorithm>
#include <utility>

namespace mjforge::solid {
namespace {

// Enough for a variant of most families; with more, the memory in use would leave the processor's
// caches.
constexpr std::size_t kMostBytes = 600'000;

template <typename T>
std::size_t BytesOf(const std::vector<T>& all) {
  return all.size() * sizeof(T);
}

std::size_t BytesOf(const Solid& solid) {
  const Surface& look = solid.look;
  std::size_t bytes = sizeof(Solid) + BytesOf(look.vertices) + BytesOf(look.normals) +
                      BytesOf(look.texcoords) + BytesOf(look.triangles);
  for (const Piece& piece : solid.pieces) {
    bytes +=
        sizeof(Piece) + BytesOf(piece.vertices) + BytesOf(piece.triangles) + BytesOf(piece.turns);
  }
  return bytes;
}

}  // namespace

std::shared_ptr<const Solid> Cache::Make(const Shape& shape, Fault& fault) {
  const auto found = std::ranges::find(entries_, shape, &Entry::shape);
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
    return found->solid;
  }
  std::optional<Solid> made =
      std::visit([&fault](const auto& one) { return solid::Make(one, fault); }, shape);
  if (!made) return nullptr;
  const std::size_t bytes = BytesOf(*made);
  entries_.push_front({shape, std::make_shared<const Solid>(*std::move(made)), bytes});
  bytes_ += bytes;
  std::shared_ptr<const Solid> solid = entries_.front().solid;
  for (; bytes_ > kMostBytes; entries_.pop_back()) bytes_ -= entries_.back().bytes;
  return solid;
}

}  // namespace mjforge::solid
