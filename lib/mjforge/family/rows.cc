// Encoding and decoding of the file of rows.

#include "mjforge/family/rows.h"

#include <algorithm>
#include <span>
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

std::string WithStart(Block block, std::string_view content) {
  BlobWriter out;
  out.Number(block);
  out.Text(content);
  return out.Take();
}

template <typename List, typename Put>
void PutList(BlobWriter& out, const List& list, const Put& put) {
  out.Number(std::uint64_t{list.size()});
  for (const auto& item : list) put(item);
}

// Reads a list: its length, then each item with `get`.
template <typename Get>
auto GetList(BlobReader& in, const Get& get) {
  std::vector<decltype(get())> list(in.Count());
  for (auto&& item : list) item = get();
  return list;
}

void Put(BlobWriter& out, const sample::ParameterValue& value) {
  out.Number(static_cast<std::uint8_t>(value.index()));
  const auto put = [&](const auto& one) {
    if constexpr (std::is_same_v<std::decay_t<decltype(one)>, std::string>)
      out.Text(one);
    else
      out.Number(one);
  };
  std::visit(
      [&](const auto& held) {
        using Held = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<Held, std::vector<bool>>) {
          PutList(out, held, [&](bool one) { put(one); });
        } else if constexpr (std::is_same_v<Held, std::vector<double>> ||
                             std::is_same_v<Held, std::vector<std::string>>) {
          PutList(out, held, put);
        } else {
          put(held);
        }
      },
      value);
}

sample::ParameterValue GetValue(BlobReader& in) {
  const auto text = [&] { return std::string(in.Text()); };
  switch (in.Number<std::uint8_t>()) {
    case 0:
      return in.Number<double>();
    case 1:
      return in.Number<bool>();
    case 2:
      return text();
    case 3:
      return GetList(in, [&] { return in.Number<double>(); });
    case 4:
      return GetList(in, text);
    case 5:
      return GetList(in, [&] { return in.Number<bool>(); });
    default:
      throw std::runtime_error("it is damaged");
  }
}

// Describes why two variants cannot be in one family; returns an empty text if they can. Ignores
// coincidences, because Complete() in final_base.h removes those that are not in all variants.
std::string DifferenceOf(const structure::Structure& structure, const Shapes& shapes,
                         const structure::Structure& other, const Shapes& other_shapes) {
  for (const structure::Difference& difference : structure::DifferencesOf(other, structure)) {
    if (!difference.is_coincidence) return structure::Describe(difference);
  }
  for (std::size_t i = 0; i < std::min(shapes.size(), other_shapes.size()); ++i) {
    if (shapes[i] != other_shapes[i]) return shapes[i].name + " has other elements";
  }
  return shapes.size() == other_shapes.size() ? std::string() : "the meshes are others";
}

std::string EncodeHeader(const structure::Structure& structure, const Shapes& shapes,
                         const std::vector<std::string>& parameters, std::string_view base) {
  BlobWriter out;
  PutList(out, structure.integers, [&](int number) { out.Number(number); });
  out.Text(structure.names);
  const auto put_text = [&](const std::string& text) { out.Text(text); };
  const auto put_number = [&](std::uint64_t number) { out.Number(number); };
  PutList(out, shapes, [&](const ArrayShape& shape) {
    out.Text(shape.name);
    out.Number(shape.type);
    out.Number(shape.is_always_stored);
    PutList(out, shape.dims, put_number);
    PutList(out, shape.elements, put_text);
    PutList(out, shape.components, put_number);
  });
  PutList(out, parameters, put_text);
  out.Text(base);
  return out.Take();
}

std::uint64_t RowSize(const Shapes& shapes) {
  std::uint64_t size = 0;
  for (const ArrayShape& shape : shapes) size += shape.size();
  return size;
}

}  // namespace

Header DecodeHeader(std::string_view bytes) {
  BlobReader in(bytes);
  const auto text = [&] { return std::string(in.Text()); };
  const auto number = [&] { return in.Number<std::uint64_t>(); };
  if (in.Number<Block>() != Block::kHeader) throw std::runtime_error("it is not a file of rows");
  in = BlobReader(in.Text());
  Header header;
  header.structure.integers = GetList(in, [&] { return in.Number<int>(); });
  header.structure.names = in.Text();
  header.shapes = GetList(in, [&] {
    ArrayShape shape;
    shape.name = in.Text();
    shape.type = in.Number<ArrayShape::Type>();
    shape.is_always_stored = in.Number<bool>();
    shape.dims = GetList(in, number);
    shape.elements = GetList(in, text);
    shape.components = GetList(in, number);
    return shape;
  });
  header.parameters = GetList(in, text);
  header.base = in.Text();
  return header;
}

std::string ChunkEncoder::Add(const Numbers& numbers, const Parameters& parameters) {
  if (count_ == 0) {
    structure_ = numbers.structure;
    shapes_ = numbers.shapes;
    for (const auto& [name, value] : parameters) parameters_.push_back(name);
  } else if (structure_ != numbers.structure || shapes_ != numbers.shapes) {
    std::string difference = DifferenceOf(numbers.structure, numbers.shapes, structure_, shapes_);
    if (!difference.empty()) return difference;
  }
  ++count_;
  values_.insert(values_.end(), numbers.values.begin(), numbers.values.end());
  BlobWriter out;
  PutList(out, numbers.materials, [&](const Material& material) {
    const auto is_it = [&](const Material& known) {
      return known.name == material.name && known.elements == material.elements;
    };
    auto known = std::ranges::find_if(materials_, is_it);
    if (known == materials_.end()) known = materials_.insert(known, material);
    out.Number(static_cast<std::uint64_t>(known - materials_.begin()));
    out.Number(material.numbers);
  });
  for (const auto& [name, value] : parameters) Put(out, value);
  details_ += out.Take();
  return {};
}

std::string ChunkEncoder::Header(std::string_view base) const {
  if (empty()) return {};
  return WithStart(Block::kHeader, EncodeHeader(structure_, shapes_, parameters_, base));
}

std::string ChunkEncoder::Bytes() const {
  if (empty()) return {};
  BlobWriter out;
  out.Number(count_);
  out.Raw({reinterpret_cast<const char*>(values_.data()), sizeof(double) * values_.size()});
  PutList(out, materials_, [&](const Material& material) {
    out.Text(material.name);
    out.Text(material.elements);
  });
  out.Raw(details_);
  return WithStart(Block::kChunk, out.bytes());
}

std::string AssetBlock(std::string_view name, std::string_view content) {
  BlobWriter out;
  out.Text(name);
  out.Text(content);
  return WithStart(Block::kAsset, out.bytes());
}

std::string DifferenceOf(const Header& header, const Header& other) {
  return DifferenceOf(header.structure, header.shapes, other.structure, other.shapes);
}

bool IsRows(const std::filesystem::path& file) {
  std::string why_not;
  const auto start = bytes::ReadStart(file, kBlockStart, why_not);
  if (!start || start->empty()) return start.has_value();
  if (start->size() < kBlockStart) return false;
  const auto block = BlobReader(*start).Number<Block>();
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
    BlobReader in(start);
    const auto block = in.Number<Block>();
    const auto size = in.Number<std::uint64_t>();
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
  std::vector<Header> headers;
  for (const Family& family : families_) headers.push_back(family.header);
  return headers;
}

std::size_t RowsFile::Find(const Header& header) const {
  const auto found = std::ranges::find_if(
      families_, [&](const Family& family) { return DifferenceOf(header, family.header).empty(); });
  return static_cast<std::size_t>(found - families_.begin());
}

void RowsFile::Select(const Header& header) { selected_ = Find(header); }

void RowsFile::AddAsset(std::uint64_t at, std::uint64_t size) {
  const std::string asset = ReadAt(at, size);
  BlobReader content(asset);
  std::string name(content.Text());
  assets_.push_back({.name = std::move(name),
                     .file = {},
                     .made = std::make_shared<const std::string>(content.Text())});
}

void RowsFile::AddChunk(std::uint64_t at, std::uint64_t size, std::size_t number) {
  Family& family = families_[number];
  const auto count = BlobReader(ReadAt(at, std::min<std::uint64_t>(size, sizeof(std::uint64_t))))
                         .Number<std::uint64_t>();
  const std::uint64_t numbers = sizeof(double) * family.row * count;
  if (family.row == 0 || count > size || numbers > size - sizeof(count))
    throw std::runtime_error("it is damaged");
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
    BlobReader in(details);
    const std::vector<Material> materials = GetList(in, [&] {
      Material material;
      material.name = in.Text();
      material.elements = in.Text();
      return material;
    });
    for (std::uint64_t i = 0; i < chunk.count; ++i) {
      std::memcpy(values.data(), numbers.data() + sizeof(double) * row_size * i,
                  sizeof(double) * row_size);
      RowView row;
      row.values = values;
      const std::uint64_t count = in.Count();
      for (std::uint64_t j = 0; j < count; ++j) {
        const auto material = in.Number<std::uint64_t>();
        if (material >= materials.size()) throw std::runtime_error("it is damaged");
        row.materials.push_back(&materials[material]);
        row.material_numbers.push_back(in.Number<std::array<double, 10>>());
      }
      for (std::size_t j = 0; j < header.parameters.size(); ++j)
        row.parameters.push_back(GetValue(in));
      visit(row);
    }
  }
}

void RowsFile::ForEachPart(std::uint64_t first, std::uint64_t count,
                           const std::function<void(std::span<const double>)>& visit) {
  // Rows of more doubles than this (with meshes) are read in part, because that takes less time.
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
