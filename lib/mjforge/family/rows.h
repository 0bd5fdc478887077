// The file of rows: the variants of a family while it is made.
//
// A file begins with a header (shapes of the arrays, names of the parameters, base MJCF). Blocks
// follow: assets, and chunks of variants. A chunk has the numbers of all its variants, then its
// materials, and then materials and parameters of each variant.

#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "mjforge/family/blob.h"
#include "mjforge/family/family.h"

namespace mjforge::family {

struct Header {
  structure::Structure structure;  // structure of the first variant
  Shapes shapes;
  std::vector<std::string> parameters;
  std::string base;
};
Header DecodeHeader(std::string_view bytes);
/// Describes how one header differs from another: DifferenceOf().
std::string DifferenceOf(const Header& header, const Header& other);

/// A variant as it is in the file.
struct RowView {
  std::span<const double> values;
  std::vector<const Material*> materials;  // names and elements; the numbers are not the variant's
  std::vector<std::array<double, 10>> looks;  // numbers of these materials
  std::vector<sample::ParameterValue> parameters;
};

/// Reads a file of rows. All functions throw std::runtime_error if it is damaged.
class RowsFile {
 public:
  explicit RowsFile(const std::filesystem::path& file);

  const Header& header() const { return header_; }
  std::uint64_t count() const { return count_; }
  const bytes::Assets& assets() const { return assets_; }

  /// Calls the function with each variant, in order.
  void ForEach(const std::function<void(const RowView&)>& visit);
  /// Calls the function with `count` numbers of each variant, from position `first` on.
  void ForEachPart(std::uint64_t first, std::uint64_t count,
                   const std::function<void(std::span<const double>)>& visit);

 private:
  struct Chunk {
    std::uint64_t offset = 0;   // position of the numbers
    std::uint64_t count = 0;    // variants
    std::uint64_t details = 0;  // size of what follows the numbers
  };
  std::string ReadAt(std::uint64_t offset, std::uint64_t count);

  bytes::File file_;
  std::uint64_t size_ = 0;
  Header header_;
  std::uint64_t row_ = 0;  // numbers of a variant
  std::uint64_t count_ = 0;
  std::vector<Chunk> chunks_;
  bytes::Assets assets_;
};

}  // namespace mjforge::family
