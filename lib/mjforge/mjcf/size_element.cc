// Writer of the <size> element, for objects that exceed the default buffer sizes of MuJoCo 2.2.
// MuJoCo 3 allocates dynamically, but accepts the element.

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "mjforge/mjcf/section_writers.h"

namespace mjforge::mjcf {
namespace {

// Number of geoms for which MuJoCo's default nconmax of 100 contacts is enough: a geom that lies
// flat on the floor has at most four contacts.
constexpr std::size_t kGeomsThatFit = 24;
constexpr double kContactsThatFit = 100;
// Assumed number of contacts of a box that rests on a box, or of two convex geoms with the flag
// multiccd. Boxes can have up to eight contacts; in the bundled scenes, a pair has at most 4.2 on
// average.
constexpr double kContactsOfFaces = 4;
// Maximum number of contacts, in addition to one per geom or pair of geoms, that are allocated for
// geoms that lie flat: in ContactsOf() for each child of the world, in CountContactsAtStart() for
// each pair of touching children of the world.
constexpr double kFlatContacts = 24;
// Factor by which the number of contacts at the start is multiplied, because contacts come and go
// while placed bodies settle. In the bundled scenes, there are at most 1.1 times as many contacts
// as at the start.
constexpr double kSpareShare = 1.5;
constexpr double kSpareContacts = 50;
// Number of constraint rows, without those of contacts, for which MuJoCo's default njmax of 500 is
// enough.
constexpr std::size_t kRowsThatFit = 300;
// Number of bodies for which MuJoCo's default stack is enough. The stack contains a list of pairs
// of bodies that might touch, but its default size grows with the square of the constraints, not of
// the bodies: 1,600 bodies fit, 1,700 do not.
constexpr std::size_t kBodiesThatFit = 1'000;
// Largest total size of MuJoCo's constraint matrices, bytes. The matrices have 12 bytes for each
// pair of rows and 24 bytes for each row and degree of freedom. MuJoCo counts bytes in an int; a
// tenth of its range is left for other arrays.
constexpr double kMatrixBytes = 1.9e9;
constexpr double kMostStack = 1.2e8;  // numbers of 8 bytes; 1 GB

/// Returns, for each body, the index of the child of the world to whose tree the body belongs.
std::vector<std::size_t> TreesOf(const model::Object& object) {
  std::vector<std::size_t> trees(object.bodies.size());
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const int parent = object.bodies[i].parent;
    trees[i] = parent < 0 ? i : trees[static_cast<std::size_t>(parent)];
  }
  return trees;
}

/// Returns, for each child of the world, the number of colliding geoms of its tree that can lie on
/// other geoms; 0 for all other bodies. The geoms of the first child, the root, count only in a
/// scene, which has a floor. Placed bodies get 0, because CountContactsAtStart() counts their
/// contacts.
std::vector<std::size_t> CountLyingGeoms(const model::Object& object, bool scene) {
  const std::vector<std::size_t> trees = TreesOf(object);
  std::vector<std::size_t> geoms(trees.size());
  for (std::size_t i = 0; i < trees.size(); ++i) {
    const bool is_placed = !object.bodies[trees[i]].place_name.empty();
    if (is_placed || (trees[i] == 0 && !scene)) continue;
    for (const model::Part& part : object.bodies[i].parts)
      geoms[trees[i]] += part.role != model::Role::kVisual;
  }
  return geoms;
}

/// Returns the number of contacts to allocate for the geoms that can lie on others
/// (CountLyingGeoms): one for each geom and, because a geom that lies flat has four, three more for
/// each, up to a limit per child of the world. The limit is low, because few of the many pieces of
/// a dish or a drawer lie flat; in a stack of bowls each piece has about one contact.
double ContactsOf(const std::vector<std::size_t>& geoms) {
  constexpr double kFlatContactsOfRoot = 300;  // higher limit, because the root may be large
  double contacts = 0;
  for (std::size_t i = 0; i < geoms.size(); ++i) {
    const auto count = static_cast<double>(geoms[i]);
    contacts += std::min(4 * count, count + (i == 0 ? kFlatContactsOfRoot : kFlatContacts));
  }
  return contacts;
}

// Largest distance, m, of bounding boxes that count as touching. Bodies that are placed on others
// start at most 0.1 mm apart.
constexpr double kNear = 2e-4;

// A colliding geom, its pose and bounding box in the world, and the index of the child of the world
// to whose tree the geom belongs.
struct PlacedGeom {
  const model::Shape* shape;
  model::Pose X_WG;
  model::Box3 box_W;
  std::size_t tree;
};

// Returns all colliding geoms, sorted by the smallest x coordinate of their bounding boxes.
std::vector<PlacedGeom> PlaceGeoms(const model::Object& object) {
  const std::vector<model::Pose> X_WB = model::BodyPoses(object);
  const std::vector<std::size_t> trees = TreesOf(object);
  std::vector<PlacedGeom> geoms;
  for (std::size_t i = 0; i < trees.size(); ++i) {
    for (const model::Part& part : object.bodies[i].parts) {
      if (part.role == model::Role::kVisual) continue;
      const model::Pose X_WG = X_WB[i] * part.X_BG;
      geoms.push_back({&part.shape, X_WG, model::BoundsOf(part.shape, X_WG), trees[i]});
    }
  }
  std::ranges::sort(geoms, {}, [](const PlacedGeom& geom) { return geom.box_W.min.x(); });
  return geoms;
}

bool AreNear(const model::Box3& a, const model::Box3& b) {
  return (a.min.array() <= b.max.array() + kNear).all() &&
         (b.min.array() <= a.max.array() + kNear).all();
}

// Returns true if the bounding boxes of both geoms, aligned with the axes of geom `a`, touch.
bool AreNearInFrameOf(const PlacedGeom& a, const PlacedGeom& b) {
  return AreNear(model::BoundsOf(*a.shape, {}),
                 model::BoundsOf(*b.shape, a.X_WG.Inverse() * b.X_WG));
}

// Returns true if the object sets the flag multiccd, with which two convex geoms have several
// contacts.
bool HasMultipleContacts(const model::Object& object) {
  for (const model::Element& option : model::ElementsOf(object, "option")) {
    for (const model::Element& flag : option.children) {
      if (TextOf(flag, "multiccd") == "enable") return true;
    }
  }
  return false;
}

// Pairs of geoms, of the trees of two children of the world, that may touch each other.
struct TouchingGeoms {
  std::vector<std::size_t> of_first, of_second;  // indices of the geoms of each pair
  double flat_pairs = 0;                         // pairs that may have several contacts
};

std::size_t CountDistinct(std::vector<std::size_t> indices) {
  std::ranges::sort(indices);
  return static_cast<std::size_t>(std::unique(indices.begin(), indices.end()) - indices.begin());
}

/// Estimates the number of contacts between the trees of different children of the world at the
/// start. Counts pairs of geoms whose bounding boxes touch, and further contacts for pairs that may
/// have several. The bounding box of a piece of a bowl touches the boxes of many pieces of a nested
/// bowl, although the piece itself touches about one of them. Therefore at most as many pairs of
/// two trees count as the tree with more touching geoms has such geoms.
double CountContactsAtStart(const model::Object& object) {
  const bool many = HasMultipleContacts(object);
  const std::vector<PlacedGeom> geoms = PlaceGeoms(object);
  std::map<std::pair<std::size_t, std::size_t>, TouchingGeoms> pairs;
  for (auto a = geoms.begin(); a != geoms.end(); ++a) {
    for (auto b = a + 1; b != geoms.end() && b->box_W.min.x() <= a->box_W.max.x() + kNear; ++b) {
      if (a->tree == b->tree || !AreNear(a->box_W, b->box_W) || !AreNearInFrameOf(*a, *b) ||
          !AreNearInFrameOf(*b, *a))
        continue;
      const auto& [first, second] = a->tree < b->tree ? std::pair(a, b) : std::pair(b, a);
      TouchingGeoms& touching = pairs[{first->tree, second->tree}];
      touching.of_first.push_back(static_cast<std::size_t>(first - geoms.begin()));
      touching.of_second.push_back(static_cast<std::size_t>(second - geoms.begin()));
      const bool boxes =
          a->shape->type == model::GeomType::kBox && b->shape->type == model::GeomType::kBox;
      touching.flat_pairs += many || boxes ? 1 : 0;
    }
  }
  double sum = 0;
  for (const auto& [trees, touching] : pairs) {
    const auto count = static_cast<double>(
        std::min(touching.of_first.size(),
                 std::max(CountDistinct(touching.of_first), CountDistinct(touching.of_second))));
    sum += count + std::min((kContactsOfFaces - 1) * touching.flat_pairs, kFlatContacts);
  }
  return sum;
}

// Returns the maximum number of constraint rows, without contacts.
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
  std::size_t dofs = 6;
  for (const model::Body& body : object.bodies) {
    for (const model::Joint& joint : body.joints) dofs += model::VelocityCount(joint);
  }
  return static_cast<double>(dofs);
}

/// Returns the largest multiple of four for njmax with which MuJoCo 2.2 accepts a model with `dofs`
/// degrees of freedom.
double MostRows(double dofs) {
  const double rows = std::sqrt(dofs * dofs + kMatrixBytes / 12) - dofs;
  return 4 * std::floor(rows / 4);
}

/// Returns the number of contacts to allocate for bodies that are placed on other bodies and
/// therefore touch them at the start; 0 if there are no placed bodies.
double ContactsOfPlacedBodies(const model::Object& object) {
  const bool any = std::ranges::any_of(
      object.bodies, [](const model::Body& body) { return !body.place_name.empty(); });
  if (!any) return 0;
  return std::ceil(kSpareShare * CountContactsAtStart(object)) + kSpareContacts;
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
  // Assumes that the constraints of at most 100 bodies fit into the default size.
  const std::size_t rows = bodies > 100 ? CountConstraints(object) : 0;
  std::vector<std::size_t> lying;
  if (scene || bodies > 1) lying = CountLyingGeoms(object, scene);
  const std::size_t geoms = std::accumulate(lying.begin(), lying.end(), std::size_t{0});
  const double needed = ContactsOf(lying) + ContactsOfPlacedBodies(object);
  const bool contacts_fit = geoms <= kGeomsThatFit && needed <= kContactsThatFit;
  if (contacts_fit && rows <= kRowsThatFit && bodies <= kBodiesThatFit) return;
  const double dofs = CountDofs(object);
  const double most = MostRows(dofs);
  // Value of nconmax; 0 for MuJoCo's default. With condim 3, a contact needs four constraint rows,
  // for the edges of its friction pyramid.
  double contacts = scene ? kContactsThatFit : 0;
  if (!contacts_fit) contacts = std::min(needed, most / 4);
  const double njmax = std::min(4 * contacts + static_cast<double>(rows) + (scene ? 0 : 500), most);
  // MuJoCo's default nstack grows with the square of the rows: 6 GB for a cupboard full of dishes.
  const double standard = 5 * (njmax + dofs) * (njmax + dofs);
  double nstack = 0;  // 0: MuJoCo's default
  if (bodies == 1) {
    // nstack counts numbers of 8 bytes, and is linear in the contacts here, because a single body
    // has at most six degrees of freedom.
    nstack = 400 * contacts + 1e6;
  } else if (bodies > kBodiesThatFit || standard > kMostStack) {
    // Adds bodies^2 numbers, because MuJoCo's stack contains a list of pairs of bodies.
    nstack = std::min(standard, kMostStack) + static_cast<double>(bodies * bodies);
  }
  WriteSize(njmax, contacts, nstack, writer);
}

}  // namespace mjforge::mjcf
