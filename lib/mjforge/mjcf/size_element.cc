// Writer of the size element, for objects that exceed the default sizes of MuJoCo 2.2. MuJoCo 3
// allocates dynamically, but accepts the element.

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "mjforge/mjcf/section_writers.h"

namespace mjforge::mjcf {
namespace {

// Number of geoms for which MuJoCo's default nconmax of 100 contacts is enough; a geom flat on the
// floor makes at most four.
constexpr std::size_t kGeomsThatFit = 24;
constexpr double kContactsOfManyPairs = 300;  // limit of contacts that exceed two per pair
constexpr double kSpareContacts = 50;         // contacts come and go while placed bodies settle
// Number of constraints, without contacts, for which MuJoCo's default njmax of 500 is enough.
constexpr std::size_t kRowsThatFit = 300;
// Number of bodies for which MuJoCo's default stack is enough. The stack has a list of pairs of
// bodies that might touch, but its size grows with the square of the constraints, not of the
// bodies: 1,600 bodies fit, 1,700 do not.
constexpr std::size_t kBodiesThatFit = 1'000;
// Largest size of MuJoCo's constraint matrices, which have 12 bytes for each pair of rows and 24
// bytes for each row and degree of freedom. MuJoCo counts bytes in an int; a tenth of its range is
// left for other arrays.
constexpr double kMatrixBytes = 1.9e9;
constexpr double kMostStack = 1.2e8;  // numbers of 8 bytes; 1 GB

/// Returns for each body the index of its tree: the child of the world that is the body itself or
/// its ancestor.
std::vector<std::size_t> TreesOf(const model::Object& object) {
  std::vector<std::size_t> trees(object.bodies.size());
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const int parent = object.bodies[i].parent;
    trees[i] = parent < 0 ? i : trees[static_cast<std::size_t>(parent)];
  }
  return trees;
}

/// Returns, for each child of the world, the number of colliding geoms that can lie on other geoms.
/// The geoms of the first child, the root, count only in a scene, which has a floor.
std::vector<std::size_t> CountLyingGeoms(const model::Object& object, bool scene) {
  const std::vector<std::size_t> trees = TreesOf(object);
  std::vector<std::size_t> geoms(trees.size());
  for (std::size_t i = 0; i < trees.size(); ++i) {
    if (trees[i] == 0 && !scene) continue;
    for (const model::Part& part : object.bodies[i].parts)
      geoms[trees[i]] += part.role != model::Role::kVisual;
  }
  return geoms;
}

/// Returns the number of contacts to allocate: four for each geom that lies flat, up to a limit for
/// each child of the world, and one for each further geom. Few of the many pieces of a dish or a
/// drawer lie flat; in a stack of bowls each piece has about one contact.
double ContactsOf(const std::vector<std::size_t>& geoms) {
  // Largest number of contacts of one child of the world in addition to one per geom. The root has
  // a larger limit, because it may be large.
  constexpr double kFlat = 24;
  constexpr double kFlatOfRoot = 300;
  double contacts = 0;
  for (std::size_t i = 0; i < geoms.size(); ++i) {
    const auto count = static_cast<double>(geoms[i]);
    contacts += std::min(4 * count, count + (i == 0 ? kFlatOfRoot : kFlat));
  }
  return contacts;
}

// Bounding box of a colliding geom, and the child of the world that its body belongs to.
struct GeomBox {
  model::Box3 box;
  std::size_t tree;
};

// Returns the boxes of all colliding geoms, sorted along x. The boxes are enlarged, so that boxes
// up to kNear apart touch.
std::vector<GeomBox> GeomBoxes(const model::Object& object) {
  constexpr double kNear = 2e-4;  // m; placed bodies start at most 0.1 mm apart
  const std::vector<model::Pose> X_WB = model::BodyPoses(object);
  const std::vector<std::size_t> trees = TreesOf(object);
  std::vector<GeomBox> boxes;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    for (const model::Part& part : object.bodies[i].parts) {
      if (part.role == model::Role::kVisual) continue;
      model::Box3 box = model::BoundsOf(part.shape, X_WB[i] * part.X_BG);
      box.min.array() -= kNear / 2;
      box.max.array() += kNear / 2;
      boxes.push_back({box, trees[i]});
    }
  }
  std::ranges::sort(boxes, {}, [](const GeomBox& geom) { return geom.box.min.x(); });
  return boxes;
}

/// Returns the number of pairs of geoms of different children of the world whose bounding boxes
/// touch at the start. A geom can lie on many others, such as a box on planks. Boxes around the
/// pieces of nested bowls touch many boxes, although each piece touches about one piece; therefore
/// two children of the world count at most as many pairs as they have geoms.
std::size_t CountTouchingPairs(const model::Object& object) {
  const std::vector<GeomBox> boxes = GeomBoxes(object);
  std::map<std::size_t, std::size_t> geoms;
  for (const GeomBox& geom : boxes) ++geoms[geom.tree];
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> pairs;
  for (auto a = boxes.begin(); a != boxes.end(); ++a) {
    for (auto b = a + 1; b != boxes.end() && b->box.min.x() <= a->box.max.x(); ++b) {
      const bool touch = (a->box.min.array() <= b->box.max.array()).all() &&
                         (b->box.min.array() <= a->box.max.array()).all();
      if (a->tree != b->tree && touch) ++pairs[std::minmax(a->tree, b->tree)];
    }
  }
  std::size_t sum = 0;
  for (const auto& [trees, count] : pairs)
    sum += std::min(count, geoms[trees.first] + geoms[trees.second]);
  return sum;
}

// Returns the maximum number of constraints without contacts.
std::size_t CountConstraints(const model::Object& object) {
  std::size_t rows = 0;
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) {
      if (joint.range) rows += 2;
      if (model::FindAttribute(joint.attributes, "frictionloss") != nullptr)
        rows += joint.type == "free" ? 6 : 3;
    }
  }
  return rows + 6 * model::ElementsOf(object, "equality").size() +
         3 * model::ElementsOf(object, "tendon").size();
}

/// Returns the number of degrees of freedom, including a free joint that a host may add to the
/// root.
double CountDofs(const model::Object& object) {
  int dofs = 6;
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints)
      dofs += joint.type == "free" ? 6 : joint.type == "ball" ? 3 : 1;
  }
  return dofs;
}

/// Returns the largest njmax, a multiple of four, with which MuJoCo 2.2 accepts a model.
double MostRows(double dofs) {
  const double rows = std::sqrt(dofs * dofs + kMatrixBytes / 12) - dofs;
  return 4 * std::floor(rows / 4);
}

// Returns true if any body was placed on others, which it touches at the start.
bool HasPlacedBodies(const model::Object& object) {
  return std::ranges::any_of(object.bodies,
                             [](const model::Body& body) { return !body.stands_at.empty(); });
}

void WriteSize(double njmax, double nconmax, double nstack, ElementWriter& writer) {
  writer.OpenElement("size");
  writer.WriteNumber("njmax", njmax);
  if (nconmax > 0) writer.WriteNumber("nconmax", nconmax);
  if (nstack > 0) writer.WriteNumber("nstack", nstack);
  writer.CloseEmpty();
}

}  // namespace

void WriteSizes(const model::Object& object, bool scene, ElementWriter& writer) {
  if (!model::ElementsOf(object, "size").empty()) return;
  const std::size_t bodies = object.bodies.size();
  // Skip counting for small objects, which have few constraints.
  const std::size_t rows = bodies > 100 ? CountConstraints(object) : 0;
  std::vector<std::size_t> lying;
  if (scene || bodies > 1) lying = CountLyingGeoms(object, scene);
  const std::size_t geoms = std::accumulate(lying.begin(), lying.end(), std::size_t{0});
  // Number of touching pairs of geoms beyond one per geom.
  std::size_t more = 0;
  const bool placed = HasPlacedBodies(object);
  if (placed) more = std::max(geoms, CountTouchingPairs(object)) - geoms;
  if (geoms + 2 * more <= kGeomsThatFit && rows <= kRowsThatFit && bodies <= kBodiesThatFit) return;
  const double dofs = CountDofs(object);
  const double most = MostRows(dofs);
  // Number of contacts. A contact needs four constraint rows, its pyramid edges (condim 3).
  double contacts = scene ? 100 : 0;
  if (geoms + 2 * more > kGeomsThatFit) {
    // Counts up to eight contacts for a pair, as for a box on a box, but about two for each of many
    // pairs, most of which are pieces that barely touch.
    const auto pairs = static_cast<double>(more);
    contacts = ContactsOf(lying) + std::min(8 * pairs, 2 * pairs + kContactsOfManyPairs);
    if (placed) contacts += kSpareContacts;
    contacts = std::min(contacts, most / 4);
  }
  const double njmax = std::min(4 * contacts + static_cast<double>(rows) + (scene ? 0 : 500), most);
  // MuJoCo's default nstack grows with the square of the rows: 6 GB for a cupboard full of dishes.
  const double standard = 5 * (njmax + dofs) * (njmax + dofs);
  double nstack = 0;  // 0: MuJoCo's default
  if (bodies == 1) {
    // Numbers of 8 bytes; linear in the contacts, because a body has at most six degrees of
    // freedom.
    nstack = 400 * contacts + 1e6;
  } else if (bodies > kBodiesThatFit || standard > kMostStack) {
    // Adds one number for each pair of bodies, because MuJoCo's stack has a list of pairs.
    nstack = std::min(standard, kMostStack) + static_cast<double>(bodies * bodies);
  }
  WriteSize(njmax, contacts, nstack, writer);
}

}  // namespace mjforge::mjcf
