// Tar archives by libarchive: segments in memory, and reading members.

#include "mjforge/output/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include "mjforge/bytes/bytes.h"
#include "mjforge/mjcf/mjcf.h"
#include "mjforge/output/atomic_file.h"

namespace mjforge::output {
namespace {

// Size of the end of a tar archive: two blocks of zeros (POSIX).
constexpr std::size_t kEndBytes = 1024;

template <auto release>
struct Free {
  void operator()(auto* what) const { release(what); }
};
using Writer = std::unique_ptr<archive, Free<archive_write_free>>;
using Reader = std::unique_ptr<archive, Free<archive_read_free>>;
using Entry = std::unique_ptr<archive_entry, Free<archive_entry_free>>;

// Throws if a call of libarchive failed, which happens only if memory is exhausted or libarchive
// lacks a format.
void Require(int status, archive* writer) {
  if (status != ARCHIVE_OK) {
    if (archive_errno(writer) == ENOMEM) throw std::bad_alloc();
    const char* words = archive_error_string(writer);
    throw std::runtime_error(fmt::format("libarchive: {}", words == nullptr ? "failed" : words));
  }
}

// Returns the structure that libarchive allocated; throws if it is null because memory is
// exhausted.
template <typename T>
T* NotNull(T* made) {
  if (made == nullptr) throw std::bad_alloc();
  return made;
}

la_ssize_t AppendTo(archive*, void* text, const void* bytes, std::size_t count) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), count);
  return static_cast<la_ssize_t>(count);
}

void Open(archive* writer, std::string& out) {
  Require(archive_write_set_bytes_per_block(writer, 0), writer);
  Require(archive_write_open(writer, &out, nullptr, AppendTo, nullptr), writer);
}

void Describe(archive_entry* entry, const std::string& name, std::size_t size) {
  archive_entry_clear(entry);
  archive_entry_set_pathname(entry, name.c_str());
  archive_entry_set_filetype(entry, AE_IFREG);
  archive_entry_set_perm(entry, 0644);
  archive_entry_set_mtime(entry, 0, 0);
  archive_entry_set_size(entry, static_cast<la_int64_t>(size));
}

void WriteData(archive* writer, std::string_view bytes) {
  if (archive_write_data(writer, bytes.data(), bytes.size()) < 0) Require(ARCHIVE_FATAL, writer);
}

std::string Compress(std::string_view bytes) {
  std::string out;
  const Writer writer(NotNull(archive_write_new()));
  Require(archive_write_set_format_raw(writer.get()), writer.get());
  Require(archive_write_add_filter_zstd(writer.get()), writer.get());
  Open(writer.get(), out);
  const Entry entry(NotNull(archive_entry_new()));
  Describe(entry.get(), "segment", bytes.size());
  Require(archive_write_header(writer.get(), entry.get()), writer.get());
  WriteData(writer.get(), bytes);
  Require(archive_write_close(writer.get()), writer.get());
  return out;
}

}  // namespace

struct Segment::TarWriter {
  ArchiveFormat format;
  std::string members;  // declared before the writer, whose destructor still appends to this text
  std::string compressed;
  Writer writer{NotNull(archive_write_new())};
  Entry entry{NotNull(archive_entry_new())};
};

Segment::Segment(ArchiveFormat format)
    : tar_(new TarWriter{.format = format, .members = {}, .compressed = {}}) {
  archive* writer = tar_->writer.get();
  Require(archive_write_set_format_ustar(writer), writer);
  Open(writer, tar_->members);
}

// The destructor of the writer appends the end of the archive to `members`, which is not used
// again.
Segment::~Segment() = default;

bool Segment::Add(const std::string& name, std::string_view bytes, diag::Findings& findings) {
  archive* writer = tar_->writer.get();
  const std::size_t before = tar_->members.size();
  Describe(tar_->entry.get(), name, bytes.size());
  if (archive_write_header(writer, tar_->entry.get()) != ARCHIVE_OK) {
    tar_->members.resize(before);
    findings.Add(
        diag::Code::kOutputCannotWrite, {},
        fmt::format("cannot put '{}' into the archive: {}", name, archive_error_string(writer)));
    return false;
  }
  WriteData(writer, bytes);
  Require(archive_write_finish_entry(writer), writer);
  return true;
}

std::string_view Segment::Bytes() {
  const std::string& members = tar_->members;
  if (members.empty() || tar_->format == ArchiveFormat::kTar) return members;
  return tar_->compressed = Compress(members);
}

void Segment::Clear() { tar_->members.clear(); }

std::string ArchiveEnd(ArchiveFormat format) {
  const std::string end(kEndBytes, '\0');
  return format == ArchiveFormat::kTar ? end : Compress(end);
}

struct ArchiveReader::TarReader {
  Reader reader{NotNull(archive_read_new())};
  archive_entry* entry = nullptr;  // the current member, which belongs to the reader
  std::string why_not;             // reason why the archive could not be opened

  std::string Error() const {
    const char* words = archive_error_string(reader.get());
    return words == nullptr ? "the archive is damaged" : words;
  }
};

ArchiveReader::ArchiveReader(const std::filesystem::path& file) : tar_(new TarReader) {
  constexpr std::size_t kBlockBytes = 1 << 20;
  archive* reader = tar_->reader.get();
  if (!bytes::MayRead(file, std::numeric_limits<std::uint64_t>::max(), tar_->why_not)) return;
  archive_read_support_filter_zstd(reader);
  archive_read_support_format_tar(reader);
  if (archive_read_open_filename(reader, file.c_str(), kBlockBytes) != ARCHIVE_OK)
    tar_->why_not = tar_->Error();
}

ArchiveReader::~ArchiveReader() = default;

std::optional<std::string> ArchiveReader::Next(std::string& why_not) {
  why_not = tar_->why_not;
  while (why_not.empty()) {
    const int status = archive_read_next_header(tar_->reader.get(), &tar_->entry);
    if (status == ARCHIVE_EOF) break;
    // Accepts warnings, which concern members that mjforge did not write: they have unusual
    // attributes, or a name that cannot be converted and is null.
    if (status != ARCHIVE_OK && status != ARCHIVE_WARN) {
      why_not = tar_->Error();
    } else if (const char* name = archive_entry_pathname(tar_->entry)) {
      return name;
    }
  }
  return std::nullopt;
}

std::optional<std::string> ArchiveReader::Content(std::string& why_not) {
  const la_int64_t size = archive_entry_size(tar_->entry);
  if (size < 0 || static_cast<std::uint64_t>(size) > bytes::kMaxMjcf)
    return diag::Refuse(why_not,
                        fmt::format("it has {} bytes, more than {}", size, bytes::kMaxMjcf));
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (archive_read_data(tar_->reader.get(), bytes.data(), bytes.size()) == size) return bytes;
  return diag::Refuse(why_not, tar_->Error());
}

std::string ArchiveReader::ReadStart(std::size_t count) {
  std::string bytes(count, '\0');
  // Ignores errors: if the archive ends within the member, zeros follow the bytes that were read.
  archive_read_data(tar_->reader.get(), bytes.data(), bytes.size());
  bytes.resize(std::min(bytes.find('\0'), bytes.size()));
  return bytes;
}

// Returns true for a member in the asset folder of the archive or of a variant.
static bool IsAsset(std::string_view member) {
  return member.starts_with(mjcf::kAssetFolder) ||
         member.find('/' + std::string(mjcf::kAssetFolder)) != member.npos;
}

bool IsObjectArchive(const std::filesystem::path& file) {
  std::string why_not;
  const std::optional<std::string> start = bytes::ReadStart(file, 1, why_not);
  if (!start || start->empty()) return start.has_value();
  ArchiveReader reader(file);
  std::optional<std::string> member = reader.Next(why_not);
  if (!member) return why_not.empty();
  while (member && IsAsset(*member)) member = reader.Next(why_not);
  return member && mjcf::ReadProvenance(reader.ReadStart(kCommentBytes)).has_value();
}

std::optional<std::string> ReadMember(const std::filesystem::path& file, const std::string& name,
                                      diag::Findings& findings) {
  ArchiveReader reader(file);
  std::string why_not;
  std::optional<std::string> member;
  do member = reader.Next(why_not);
  while (member && *member != name);
  std::optional<std::string> bytes;
  if (member) bytes = reader.Content(why_not);
  if (bytes) return bytes;
  findings.Add(diag::Code::kYamlCannotRead, {},
               fmt::format("cannot read '{}' in '{}': {}", name, file.string(),
                           why_not.empty() ? "it is not there" : why_not));
  return std::nullopt;
}

}  // namespace mjforge::output
