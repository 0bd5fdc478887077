// Writer of NumPy's archives of arrays (.npz): zip members without compression, headers of arrays.
//
// libarchive's writer of zip files is not used, because it links a library of ciphers.

#include "mjforge/output/npz.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "mjforge/bytes/bytes.h"

namespace mjforge::output {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they are");

// NumPy's code for a type, and the size of a value in bytes, in the order of ArrayType. The size of
// a text is that of one code point.
struct TypeInfo {
  std::string_view word;
  std::uint64_t bytes;
};
constexpr TypeInfo kTypes[] = {{"<f8", 8}, {"<i4", 4}, {"<u8", 8},
                               {"|b1", 1}, {"|u1", 1}, {"<U", 4}};

const TypeInfo& InfoOf(ArrayType type) { return kTypes[static_cast<std::size_t>(type)]; }

// Header of format 1.0 (numpy.lib.format): magic, version, length of the rest, a literal of Python,
// blanks up to a multiple of 64 bytes.
std::string HeaderOf(ArrayType type, std::span<const std::uint64_t> shape,
                     std::size_t code_points) {
  constexpr std::size_t kAlignment = 64;
  std::string words =
      fmt::format("{{'descr': '{}{}', 'fortran_order': False, 'shape': ({}{}), }}",
                  InfoOf(type).word, type == ArrayType::kText ? std::to_string(code_points) : "",
                  fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
  const std::size_t start = 10;  // bytes of magic, version and length
  const std::size_t used = start + words.size() + 1;
  words.append((kAlignment - used % kAlignment) % kAlignment, ' ');
  words += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(words.size() & 0xFF);
  header += static_cast<char>(words.size() >> 8);
  return header + words;
}

}  // namespace

std::size_t CodePoints(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(diag::DecodeUtf8(text).length);
  return count;
}

std::string Utf32Of(std::string_view text, std::size_t length) {
  constexpr char32_t kReplacement = 0xFFFD;  // in place of an invalid byte
  std::u32string points;
  while (!text.empty() && points.size() < length) {
    const diag::Utf8Char character = diag::DecodeUtf8(text);
    points += character.valid ? character.value : kReplacement;
    text.remove_prefix(character.length);
  }
  points.resize(length);
  return {reinterpret_cast<const char*>(points.data()), 4 * length};
}

// Writes a zip file (APPNOTE 6.3.10) front to back: the checksum of a member follows its content.
// Numbers are little-endian, sizes and offsets have 64 bits where 32 are not enough.
struct NpzWriter::Zip {
  struct Member {
    std::string name;
    std::uint64_t offset = 0;
    std::uint64_t size = 0;
    std::uint32_t crc = 0;
  };

  PartFile& part;
  diag::Findings& findings;
  bool failed = false;
  std::vector<Member> members;
  std::uint64_t left = 0;  // bytes of the current member that are not written yet

  std::uint64_t end = 0;  // offset of the next byte
  std::string buffer;     // bytes that are not yet written to the part file

  void Append(std::string_view bytes) {
    constexpr std::size_t kBuffer = 1 << 20;
    end += bytes.size();
    buffer += bytes;
    if (buffer.size() > kBuffer) Flush();
  }
  void Flush() {
    failed = failed || !part.Append(buffer, findings);
    buffer.clear();
  }
  void BeginMember(std::string name, std::uint64_t size);
  void EndMember();
  void AppendDirectory();
};

namespace {

constexpr std::uint64_t kMax32 = 0xFFFFFFFF;

// Builds the bytes of a zip header from numbers and texts.
class Header {
 public:
  template <typename T>
  Header& Add(T number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof(number));
    return *this;
  }
  Header& Add(const std::string& text) {
    bytes_ += text;
    return *this;
  }
  Header& Short(unsigned number) { return Add(static_cast<std::uint16_t>(number)); }
  Header& Word(std::uint64_t number) {
    return Add(static_cast<std::uint32_t>(std::min(number, kMax32)));
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// Adds version, flags, method (no compression) and time (the earliest that a zip file can have).
Header& AddCommon(Header& header, bool is_large) {
  constexpr unsigned kVersion = 20;
  constexpr unsigned kLargeVersion = 45;  // version with sizes of 64 bits
  constexpr unsigned kChecksumFollows = 1U << 3;
  constexpr unsigned kUtf8Name = 1U << 11;
  constexpr unsigned kFirstDay = 1U << 5 | 1U;  // 1980-01-01
  return header.Short(is_large ? kLargeVersion : kVersion)
      .Short(kChecksumFollows | kUtf8Name)
      .Short(0)
      .Short(0)
      .Short(kFirstDay);
}

// Returns a zip extra field with 64-bit sizes and offsets (Zip64); empty if there are no numbers.
std::string LargeNumbers(const std::vector<std::uint64_t>& numbers) {
  if (numbers.empty()) return {};
  Header field;
  field.Short(1).Short(static_cast<unsigned>(sizeof(std::uint64_t) * numbers.size()));
  for (const std::uint64_t number : numbers) field.Add(number);
  return field.bytes();
}

}  // namespace

void NpzWriter::Zip::BeginMember(std::string name, std::uint64_t size) {
  const bool is_large = size >= kMax32;
  const std::string extra = is_large ? LargeNumbers({0, 0}) : std::string();
  Header header;
  AddCommon(header.Word(0x04034b50), is_large)
      .Word(0)
      .Word(is_large ? kMax32 : 0)
      .Word(is_large ? kMax32 : 0)
      .Short(static_cast<unsigned>(name.size()))
      .Short(static_cast<unsigned>(extra.size()))
      .Add(name)
      .Add(extra);
  members.push_back({std::move(name), end, size, 0});
  left = size;
  Append(header.bytes());
}

void NpzWriter::Zip::EndMember() {
  if (members.empty()) return;
  if (left > 0) throw std::logic_error("an array of an .npz file got fewer numbers than it has");
  const Member& member = members.back();
  Header header;
  header.Word(0x08074b50).Add(member.crc);
  if (member.size >= kMax32) {
    header.Add(member.size).Add(member.size);
  } else {
    header.Word(member.size).Word(member.size);
  }
  Append(header.bytes());
}

void NpzWriter::Zip::AppendDirectory() {
  const std::uint64_t start = end;
  for (const Member& member : members) {
    const bool is_large = member.size >= kMax32;
    std::vector<std::uint64_t> numbers;
    if (is_large) numbers = {member.size, member.size};
    if (member.offset >= kMax32) numbers.push_back(member.offset);
    const std::string extra = LargeNumbers(numbers);
    Header header;
    constexpr unsigned kMadeBy = 45 | 3U << 8;  // version 4.5 of the format, on Unix
    constexpr std::uint64_t kMode = std::uint64_t{0100644} << 16;
    AddCommon(header.Word(0x02014b50).Short(kMadeBy), !numbers.empty())
        .Add(member.crc)
        .Word(member.size)
        .Word(member.size)
        .Short(static_cast<unsigned>(member.name.size()))
        .Short(static_cast<unsigned>(extra.size()))
        .Short(0)
        .Short(0)
        .Short(0)
        .Word(kMode)
        .Word(member.offset)
        .Add(member.name)
        .Add(extra);
    Append(header.bytes());
  }
  const std::uint64_t size = end - start;
  const std::uint64_t count = members.size();
  Header last;
  if (start >= kMax32 || count >= 0xFFFF) {
    const std::uint64_t end_at = end;
    last.Word(0x06064b50).Add(std::uint64_t{44}).Short(45 | 3U << 8).Short(45).Word(0).Word(0);
    last.Add(count).Add(count).Add(size).Add(start);
    last.Word(0x07064b50).Word(0).Add(end_at).Word(1);
  }
  const auto entries = static_cast<unsigned>(std::min<std::uint64_t>(count, 0xFFFF));
  last.Word(0x06054b50).Short(0).Short(0).Short(entries).Short(entries);
  last.Word(size).Word(start).Short(0);
  Append(last.bytes());
}

NpzWriter::NpzWriter(PartFile& part, diag::Findings& findings)
    : zip_(new Zip{.part = part, .findings = findings, .members = {}, .buffer = {}}) {}

NpzWriter::~NpzWriter() = default;

void NpzWriter::Begin(const std::string& name, ArrayType type, std::span<const std::uint64_t> shape,
                      std::size_t code_points) {
  // Stores empty texts with one zero code point, because NumPy has no texts of length 0.
  if (type == ArrayType::kText && code_points == 0) code_points = 1;
  const std::string header = HeaderOf(type, shape, code_points);
  std::uint64_t size = InfoOf(type).bytes;
  if (type == ArrayType::kText) size *= code_points;
  for (const std::uint64_t count : shape) size *= count;
  zip_->EndMember();
  zip_->BeginMember(name + ".npy", header.size() + size);
  Write(header);
}

void NpzWriter::Write(std::string_view bytes) {
  if (bytes.size() > zip_->left)
    throw std::logic_error("an array of an .npz file got more numbers than it has");
  zip_->left -= bytes.size();
  std::uint32_t& crc = zip_->members.back().crc;
  crc = static_cast<std::uint32_t>(
      crc32_z(crc, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
  zip_->Append(bytes);
}

void NpzWriter::Write(std::span<const double> numbers) {
  Write(std::string_view(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes()));
}

bool NpzWriter::Finish() {
  zip_->EndMember();
  zip_->AppendDirectory();
  zip_->Flush();
  return !zip_->failed;
}

bool IsNpzWith(const std::filesystem::path& file, std::string_view first_member) {
  constexpr std::size_t kNameAt = 30;  // size of a zip member's fixed header
  std::string why_not;
  const std::string name = std::string(first_member) + ".npy";
  const auto start = bytes::ReadStart(file, kNameAt + name.size(), why_not);
  if (!start) return false;
  return start->empty() || (start->starts_with("PK\x03\x04") &&
                            start->substr(std::min(kNameAt, start->size())) == name);
}

}  // namespace mjforge::output
