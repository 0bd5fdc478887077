// Families: variants with the same structure (integers and names of mjModel), and the numbers in
// which they differ, for simulators that step thousands of worlds with one model.

#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/bytes/bytes.h"
#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/model/model.h"
#include "mjforge/output/output.h"
#include "mjforge/sample/sample.h"
#include "mjforge/structure/structure.h"

struct mjModel_;  // MuJoCo's compiled model

namespace mjforge::family {

/// Name, dimensions and type of an array, such as mjModel's geom_size, that every variant of a
/// family has.
struct ArrayShape {
  enum class Type : std::uint8_t {
    kNumber,    // double
    kIndex,     // std::uint64_t, stored in the bytes of a double
    kMaterial,  // index in Numbers::materials; -1: no material
    kFlag       // flag for a special pose of an element (coincidences.h); not in the .npz file
  };

  std::string name;  // "geom_size"
  /// Dimensions of the array in one variant. The first one is the number of elements, unless
  /// `elements` is empty; {} for a single number.
  std::vector<std::uint64_t> dims;
  Type type = Type::kNumber;
  bool is_always_stored = false;  // stored even if all variants have the same numbers
  /// Names of the elements of the first dimension. Empty: the array is stored as a whole.
  std::vector<std::string> elements;
  /// Only for arrays with several rows for an element, such as a joint or a tendon: position of
  /// each row among those of its element.
  std::vector<std::uint64_t> components;

  /// Number of doubles of one variant.
  std::uint64_t size() const;
  /// Number of doubles of one element.
  std::uint64_t width() const { return elements.empty() ? size() : size() / elements.size(); }

  bool operator==(const ArrayShape&) const = default;
};

/// The structure of a variant's model, and the arrays of its numbers, which follow each other.
struct Layout {
  structure::Structure structure;
  std::vector<ArrayShape> shapes;

  /// Returns the array with this name, and the position of its first number. Throws
  /// std::runtime_error if there is none.
  std::pair<const ArrayShape&, std::size_t> Find(std::string_view array) const;
  /// Returns the numbers of an element among the `values` of all arrays of a variant.
  std::span<const double> NumbersOf(std::string_view array, std::size_t element,
                                    std::span<const double> values) const;

  bool operator==(const Layout&) const = default;
};

/// A material of one variant.
struct Material {
  std::string name;
  std::string elements;              // lines of MJCF: <texture> (if any) and <material>
  std::array<double, 10> numbers{};  // values of kMaterialArrays, one after the other

  bool operator==(const Material&) const = default;
};
struct MaterialArray {
  std::string_view name;
  std::uint64_t width;
};
inline constexpr MaterialArray kMaterialArrays[] = {{"mat_rgba", 4},        {"mat_emission", 1},
                                                    {"mat_specular", 1},    {"mat_shininess", 1},
                                                    {"mat_reflectance", 1}, {"mat_texrepeat", 2}};

/// Names and values of a variant's parameters, as in the variant's record in the manifest.
using Parameters = std::vector<std::pair<std::string, sample::ParameterValue>>;

/// Values of the arrays of mjModel for one variant: sizes, poses, masses, colours and so on.
struct Numbers : Layout {
  std::vector<double> values;  // numbers of all arrays, in the order of the shapes
  std::vector<Material> materials;

  /// Adds an array that is stored even if all variants have the same numbers (is_always_stored).
  void Add(std::string name, std::vector<std::uint64_t> dims, std::span<const double> numbers,
           ArrayShape::Type type = ArrayShape::Type::kNumber);
};

/// Reads the numbers of a variant from the model that MuJoCo compiled from `document`, which was
/// made from `object`. Poses of mesh geoms and vertices of meshes are those of the document,
/// because releases of MuJoCo choose different frames for a mesh.
Numbers Read(const mjModel_& m, const model::Object& object, const mjcf::MjcfDocument& document);

/// Returns a variant's MJCF as a family's base MJCF: with <inertial> in every body, because the
/// masses of bodies must not depend on the geoms. If `mocap` is true, children of the world without
/// joints become mocap bodies.
std::string BaseOf(const mjcf::MjcfDocument& document, const Numbers& numbers, bool mocap);

/// Encodes a chunk: consecutive variants of one family, which are appended together to a file of
/// rows (rows.h).
class ChunkEncoder {
 public:
  /// Adds a variant and returns an empty text. If the variant cannot be in one family with the
  /// first variant, returns the difference instead: "geom_type of 'handle' is box, not cylinder".
  std::string Add(const Numbers& numbers, const Parameters& parameters);
  /// Returns the bytes of the header, with the base MJCF `base`. The header precedes the chunk in
  /// the file. Returns an empty text if there are no variants.
  std::string Header(std::string_view base) const;
  /// Returns the bytes of the chunk; empty if there are no variants.
  std::string Bytes() const;
  bool empty() const { return count_ == 0; }

 private:
  Layout layout_;
  std::uint64_t count_ = 0;
  std::vector<double> values_;
  std::vector<std::string> parameters_;  // names of the parameters
  std::vector<Material> materials_;      // distinct; `numbers` of the first variant with each
  std::string details_;                  // encoded materials and parameters of each variant
};

/// Returns the bytes that store an asset of the base MJCF in a file of rows.
std::string AssetBlock(std::string_view name, std::string_view content);

/// Values that are the same for all variants of a family, such as the seed. The family's .npz file
/// contains them as JSON.
struct Facts {
  std::vector<std::pair<std::string, std::string>> members;  // names and JSON values
};

/// Returns true for an empty file and for one that begins like a file of rows.
bool IsRows(const std::filesystem::path& file);

/// Writes an .npz file for each family with its variants from all files of rows, in their order.
/// Loads the base MJCF of each family in MuJoCo. `place` returns the path of a family's .npz file
/// from the family's key, Structure::FamilyKey(); the same path for several families is an error.
/// Returns the files, which the caller must commit; an empty list after adding a finding.
std::vector<std::unique_ptr<output::PartFile>> WriteNpz(
    std::span<const std::filesystem::path> rows, const Facts& facts,
    const std::function<std::filesystem::path(const std::string& key)>& place,
    diag::Findings& findings);

/// Name of the first member of a family's .npz file, which contains the facts as JSON.
inline constexpr std::string_view kFirstMember = "family";

}  // namespace mjforge::family
