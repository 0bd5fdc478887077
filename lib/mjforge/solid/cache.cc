// Least recently used cache of solids, limited by memory and by the number of entries.

#include <algorithm>
#include <utility>

#include "mjforge/solid/solid.h"

namespace mjforge::solid {
namespace {

// Maximum size of all cached solids, bytes: enough for one variant of most specs. More would not
// fit into the processor's caches.
constexpr std::size_t kMostBytes = 600'000;
// Maximum number of cached solids, which limits the time of the linear search for a shape.
constexpr std::size_t kMostEntries = 64;

template <typename T>
std::size_t BytesOf(const std::vector<T>& vector) {
  return vector.size() * sizeof(T);
}

std::size_t BytesOf(const TriangleMesh& mesh) {
  return BytesOf(mesh.vertices) + BytesOf(mesh.triangles) + BytesOf(mesh.normals) +
         BytesOf(mesh.texcoords);
}

std::size_t BytesOf(const Solid& solid) {
  std::size_t bytes =
      sizeof(Solid) + BytesOf(solid.render_mesh) + BytesOf(solid.pieces) + BytesOf(solid.extent);
  for (const ConvexPiece& piece : solid.pieces) bytes += BytesOf(piece.mesh) + BytesOf(piece.turns);
  return bytes;
}

}  // namespace

std::shared_ptr<const Solid> Cache::Make(const SolidShape& shape, Fault& fault) {
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
  for (; bytes_ > kMostBytes || entries_.size() > kMostEntries; entries_.pop_back())
    bytes_ -= entries_.back().bytes;
  return solid;
}

}  // namespace mjforge::solid
