// The file of rows, which stores variants of one or more families, one row per variant. The .npz
// files of families are written from such files.
//
// A file consists of blocks: headers (structure, shapes of the arrays, names of the parameters,
// base MJCF), assets, and chunks of variants. A chunk belongs to the last header before the chunk.
// A chunk has the numbers of all its variants, then its materials, and then materials and
// parameters of each variant. Headers without a difference (DifferenceOf) are of one family; the
// first of these headers applies to all chunks of the family.

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "mjforge/family/family.h"

namespace mjforge::family {

/// Layout and parameters of a variant, and the base MJCF of its family.
struct Header : Layout {
  std::vector<std::string> parameters;
  std::string base;
};
Header DecodeHeader(std::string_view bytes);
/// Returns a description of the difference because of which two variants cannot be in one family;
/// an empty text if they can. Ignores flags for special poses, because Complete() in final_base.h
/// makes a base without those flags that are wrong for any variant.
std::string DifferenceOf(const Layout& layout, const Layout& other);

/// A variant (row) in a file of rows.
struct RowView {
  std::span<const double> values;
  /// Materials of the variant. Material::numbers are not those of this variant.
  std::vector<const Material*> materials;
  /// Numbers (as Material::numbers) of each of `materials` in this variant.
  std::vector<std::array<double, 10>> material_numbers;
  std::vector<sample::ParameterValue> parameters;
};

/// Reads a file of rows. All functions throw std::runtime_error if the file is damaged.
class RowsFile {
 public:
  explicit RowsFile(const std::filesystem::path& file);

  /// Returns the first header of each family in the file, in the order of the file.
  std::vector<Header> Headers() const;
  /// Selects the family of this header for all functions below except assets(). If the file does
  /// not contain the family, count() is 0, and header() must not be called.
  void Select(const Header& header);

  const Header& header() const { return families_[selected_].header; }
  std::uint64_t count() const {
    return selected_ < families_.size() ? families_[selected_].count : 0;
  }
  const bytes::Assets& assets() const { return assets_; }

  /// Calls the function with each variant of the selected family, in the order of the file.
  void ForEach(const std::function<void(const RowView&)>& visit);
  /// Calls the function with a part of the numbers of each variant: `count` numbers from position
  /// `first` on.
  void ForEachPart(std::uint64_t first, std::uint64_t count,
                   const std::function<void(std::span<const double>)>& visit);

 private:
  struct Chunk {
    std::uint64_t offset = 0;   // position of the numbers in the file, in bytes
    std::uint64_t count = 0;    // number of variants
    std::uint64_t details = 0;  // number of bytes after the numbers
  };
  struct Family {
    Header header;
    std::uint64_t row = 0;    // number of doubles of a variant
    std::uint64_t count = 0;  // number of variants
    std::vector<Chunk> chunks;
  };
  std::string ReadAt(std::uint64_t offset, std::uint64_t count);
  /// Returns the index of the family of a header; families_.size() if there is none.
  std::size_t Find(const Header& header) const;
  void AddChunk(std::uint64_t at, std::uint64_t size, std::size_t number);
  void AddAsset(std::uint64_t at, std::uint64_t size);

  bytes::File file_;
  std::uint64_t size_ = 0;
  std::vector<Family> families_;
  std::size_t selected_ = 0;
  bytes::Assets assets_;
};

}  // namespace mjforge::family
