// Encoding and decoding of files of rows (rows.h): blocks with headers, assets and variants.

#include "mjforge/family/rows.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace mjforge::family {
namespace {

// The first eight characters of a block: "mjfrows2", "mjfasset", "mjfchunk".
enum class Block : std::uint64_t {
  kHeader = 0x32737772'6f666a6d,
  kAsset = 0x74657373'61666a6d,
  kChunk = 0x6b6e7568'63666a6d
};

// Number of bytes at the start of each block: its kind, then the size of the rest.
constexpr std::uint64_t kBlockStart = 2 * sizeof(std::uint64_t);

// A material of a variant, as stored in the file.
struct MaterialUse {
  std::uint64_t number = 0;  // position among the materials of the chunk
  std::array<double, 10> numbers{};
};

// Members of the structs in the file, in the order of their encoding.
struct Fields {
  static auto Of(structure::Structure& structure) {
    return std::tie(structure.integers, structure.names);
  }
  static auto Of(ArrayShape& shape) {
    return std::tie(shape.name, shape.type, shape.is_always_stored, shape.dims, shape.elements,
                    shape.components);
  }
  static auto Of(Header& header) {
    return std::tie(header.structure, header.shapes, header.parameters, header.base);
  }
  static auto Of(Material& material) { return std::tie(material.name, material.elements); }
};
using Decoder = bytes::Decoder<Fields>;

template <typename T>
std::string Encode(const T& value) {
  return bytes::Encode<Fields>(value);
}

std::string WithStart(Block block, std::string_view content) {
  return Encode(block) + Encode(content);
}

std::uint64_t RowSize(const std::vector<ArrayShape>& shapes) {
  std::uint64_t size = 0;
  for (const ArrayShape& shape : shapes) size += shape.size();
  return size;
}

}  // namespace

Header DecodeHeader(std::string_view bytes) {
  Decoder in(bytes);
  if (in.Read<Block>() != Block::kHeader) throw std::runtime_error("it is not a file of rows");
  return Decoder(in.Read<std::string_view>()).Read<Header>();
}

std::string ChunkEncoder::Add(const Numbers& numbers, const Parameters& parameters) {
  if (count_ == 0) {
    layout_ = numbers;
    for (const auto& [name, value] : parameters) parameters_.push_back(name);
  } else if (layout_ != numbers) {
    std::string difference = DifferenceOf(numbers, layout_);
    if (!difference.empty()) return difference;
  }
  ++count_;
  values_.insert(values_.end(), numbers.values.begin(), numbers.values.end());
  std::vector<MaterialUse> uses;
  for (const Material& material : numbers.materials) {
    const auto is_it = [&](const Material& known) {
      return known.name == material.name && known.elements == material.elements;
    };
    auto known = std::ranges::find_if(materials_, is_it);
    if (known == materials_.end()) known = materials_.insert(known, material);
    uses.push_back({static_cast<std::uint64_t>(known - materials_.begin()), material.numbers});
  }
  details_ += Encode(uses);
  for (const auto& [name, value] : parameters) details_ += Encode(value);
  return {};
}

std::string ChunkEncoder::Header(std::string_view base) const {
  if (empty()) return {};
  const family::Header header{layout_, parameters_, std::string(base)};
  return WithStart(Block::kHeader, Encode(header));
}

std::string ChunkEncoder::Bytes() const {
  if (empty()) return {};
  std::string out = Encode(count_);
  out.append(reinterpret_cast<const char*>(values_.data()), sizeof(double) * values_.size());
  return WithStart(Block::kChunk, out + Encode(materials_) + details_);
}

std::string AssetBlock(std::string_view name, std::string_view content) {
  return WithStart(Block::kAsset, Encode(name) + Encode(content));
}

std::string DifferenceOf(const Layout& layout, const Layout& other) {
  for (const structure::Difference& difference :
       structure::DifferencesOf(other.structure, layout.structure)) {
    if (!difference.is_coincidence) return structure::Describe(difference);
  }
  for (std::size_t i = 0; i < std::min(layout.shapes.size(), other.shapes.size()); ++i) {
    if (layout.shapes[i] != other.shapes[i]) return layout.shapes[i].name + " has other elements";
  }
  return layout.shapes.size() == other.shapes.size() ? "" : "the meshes are others";
}

bool IsRows(const std::filesystem::path& file) {
  std::string why_not;
  const auto start = bytes::ReadStart(file, kBlockStart, why_not);
  if (!start || start->empty()) return start.has_value();
  if (start->size() < kBlockStart) return false;
  const auto block = Decoder(*start).Read<Block>();
  return block == Block::kHeader || block == Block::kAsset;
}

RowsFile::RowsFile(const std::filesystem::path& file)
    : file_([&] {
        std::string why_not;
        std::optional<bytes::File> opened = bytes::File::Open(file, why_not);
        if (!opened) throw std::runtime_error(why_not);
        return *std::move(opened);
      }()),
      size_(std::filesystem::file_size(file)) {
  std::size_t family = 0;  // index of the family of the last header
  for (std::uint64_t at = 0; at < size_;) {
    const std::string start = ReadAt(at, std::min(size_ - at, kBlockStart));
    Decoder in(start);
    const auto block = in.Read<Block>();
    const auto size = in.Read<std::uint64_t>();
    if (size > size_ - at - kBlockStart) throw std::runtime_error("it is cut short");
    if (block == Block::kHeader) {
      Header header = DecodeHeader(ReadAt(at, kBlockStart + size));
      family = Find(header);
      const std::uint64_t row = RowSize(header.shapes);
      if (family == families_.size()) families_.push_back({std::move(header), row, 0, {}});
    } else if (block == Block::kAsset) {
      AddAsset(at + kBlockStart, size);
    } else if (block == Block::kChunk && family < families_.size()) {
      AddChunk(at + kBlockStart, size, family);
    } else {
      throw std::runtime_error("it is damaged");
    }
    at += kBlockStart + size;
  }
}

std::vector<Header> RowsFile::Headers() const {
  return diag::Mapped<Header>(families_, &Family::header);
}

std::size_t RowsFile::Find(const Header& header) const {
  const auto found = std::ranges::find_if(
      families_, [&](const Family& family) { return DifferenceOf(header, family.header).empty(); });
  return static_cast<std::size_t>(found - families_.begin());
}

void RowsFile::Select(const Header& header) { selected_ = Find(header); }

void RowsFile::AddAsset(std::uint64_t at, std::uint64_t size) {
  const std::string asset = ReadAt(at, size);
  Decoder content(asset);
  auto name = content.Read<std::string>();
  assets_.push_back({.name = std::move(name),
                     .file = {},
                     .made = std::make_shared<const std::string>(content.Read<std::string>())});
}

void RowsFile::AddChunk(std::uint64_t at, std::uint64_t size, std::size_t number) {
  Family& family = families_[number];
  const auto count = Decoder(ReadAt(at, std::min<std::uint64_t>(size, sizeof(std::uint64_t))))
                         .Read<std::uint64_t>();
  // Divides, because a product of numbers in a damaged file may overflow.
  if (size < sizeof(count) || family.row == 0 ||
      count > (size - sizeof(count)) / sizeof(double) / family.row)
    throw std::runtime_error("it is damaged");
  const std::uint64_t numbers = sizeof(double) * family.row * count;
  family.chunks.push_back({at + sizeof(count), count, size - sizeof(count) - numbers});
  family.count += count;
}

std::string RowsFile::ReadAt(std::uint64_t offset, std::uint64_t count) {
  std::string why_not;
  std::string bytes(count, '\0');
  file_.Seek(offset);
  const auto got = file_.Read(std::span(bytes.data(), bytes.size()), why_not);
  if (got != count) throw std::runtime_error(why_not.empty() ? "it is cut short" : why_not);
  return bytes;
}

void RowsFile::ForEach(const std::function<void(const RowView&)>& visit) {
  if (count() == 0) return;
  const auto& [header, row_size, all, chunks] = families_[selected_];
  for (const Chunk& chunk : chunks) {
    const std::string numbers = ReadAt(chunk.offset, sizeof(double) * row_size * chunk.count);
    const std::string details = ReadAt(chunk.offset + numbers.size(), chunk.details);
    std::vector<double> values(row_size);
    Decoder in(details);
    const auto materials = in.Read<std::vector<Material>>();
    for (std::uint64_t i = 0; i < chunk.count; ++i) {
      std::memcpy(values.data(), numbers.data() + sizeof(double) * row_size * i,
                  sizeof(double) * row_size);
      RowView row;
      row.values = values;
      for (const auto& [material, material_numbers] : in.Read<std::vector<MaterialUse>>()) {
        if (material >= materials.size()) throw std::runtime_error("it is damaged");
        row.materials.push_back(&materials[material]);
        row.material_numbers.push_back(material_numbers);
      }
      for (std::size_t j = 0; j < header.parameters.size(); ++j)
        row.parameters.push_back(in.Read<sample::ParameterValue>());
      visit(row);
    }
  }
}

void RowsFile::ForEachPart(std::uint64_t first, std::uint64_t count,
                           const std::function<void(std::span<const double>)>& visit) {
  // Largest number of doubles in a row for which whole chunks are read, because one large read is
  // faster than many small ones. For longer rows (variants with meshes), reads only the requested
  // numbers.
  constexpr std::uint64_t kLargeRow = 8192;
  std::vector<double> part(count);
  const auto show = [&](const char* from) {
    std::memcpy(part.data(), from, sizeof(double) * count);
    visit(part);
  };
  if (this->count() == 0) return;
  const std::uint64_t row_size = families_[selected_].row;
  for (const Chunk& chunk : families_[selected_].chunks) {
    if (row_size > kLargeRow) {
      for (std::uint64_t i = 0; i < chunk.count; ++i) {
        show(ReadAt(chunk.offset + sizeof(double) * (row_size * i + first), sizeof(double) * count)
                 .data());
      }
      continue;
    }
    const std::string numbers = ReadAt(chunk.offset, sizeof(double) * row_size * chunk.count);
    for (std::uint64_t i = 0; i < chunk.count; ++i)
      show(numbers.data() + sizeof(double) * (row_size * i + first));
  }
}

}  // namespace mjforge::family
