// Tar archives by libarchive: segments in memory, and reading one member.

#include "mjforge/output/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

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

// A tar archive ends with two blocks of zeros (POSIX).
constexpr std::size_t kEndBytes = 1024;

template <auto release>
struct Free {
  void operator()(auto* what) const { release(what); }
};
using Writer = std::unique_ptr<archive, Free<archive_write_free>>;
using Reader = std::unique_ptr<archive, Free<archive_read_free>>;
using Entry = std::unique_ptr<archive_entry, Free<archive_entry_free>>;

// Throws if a call failed; this happens only if memory is exhausted or libarchive lacks a format.
void Require(int status, archive* writer) {
  if (status != ARCHIVE_OK) {
    if (archive_errno(writer) == ENOMEM) throw std::bad_alloc();
    const char* words = archive_error_string(writer);
    throw std::runtime_error(fmt::format("libarchive: {}", words == nullptr ? "failed" : words));
  }
}

// Returns a new structure of libarchive; throws if there is no memory for it.
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

// Opens an archive of either format; `status` is the result.
Reader OpenReader(const std::filesystem::path& file, int& status) {
  constexpr std::size_t kBlockBytes = 1 << 20;
  Reader reader(NotNull(archive_read_new()));
  archive_read_support_filter_zstd(reader.get());
  archive_read_support_format_tar(reader.get());
  status = archive_read_open_filename(reader.get(), file.c_str(), kBlockBytes);
  return reader;
}

}  // namespace

struct Segment::TarWriter {
  ArchiveFormat format;
  std::string members;  // declared before the writer, which still appends here when destroyed
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

// The destructor of the writer appends the end of the archive to `members`, which nobody reads.
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

bool IsObjectArchive(const std::filesystem::path& file) {
  std::string why_not;
  const std::optional<std::string> start = bytes::ReadStart(file, 1, why_not);
  if (!start || start->empty()) return start.has_value();
  int status = ARCHIVE_OK;
  const Reader reader = OpenReader(file, status);
  archive_entry* entry = nullptr;
  const auto next = [&] { return archive_read_next_header(reader.get(), &entry); };
  if (status == ARCHIVE_OK) status = next();
  if (status == ARCHIVE_EOF) return true;
  const auto is_asset = [&] {
    const char* path = archive_entry_pathname(entry);
    return path != nullptr && std::string_view(path).starts_with(mjcf::kAssetFolder);
  };
  while (status == ARCHIVE_OK && is_asset()) status = next();
  if (status != ARCHIVE_OK) return false;
  // A damaged archive may end within the object, which is an error after its beginning is read.
  std::string opening(kCommentBytes, '\0');
  archive_read_data(reader.get(), opening.data(), opening.size());
  return mjcf::ReadProvenance(opening.c_str()).has_value();
}

std::optional<std::string> ReadMember(const std::filesystem::path& file, const std::string& name,
                                      diag::Findings& findings) {
  const auto fail = [&](std::string_view why_not) {
    findings.Add(diag::Code::kYamlCannotRead, {},
                 fmt::format("cannot read '{}' in '{}': {}", name, file.string(), why_not));
    return std::nullopt;
  };
  std::string why_not;
  if (!bytes::MayRead(file, std::numeric_limits<std::uint64_t>::max(), why_not))
    return fail(why_not);
  int status = ARCHIVE_OK;
  const Reader reader = OpenReader(file, status);
  archive_entry* entry = nullptr;
  const auto next = [&] { return archive_read_next_header(reader.get(), &entry); };
  if (status == ARCHIVE_OK) status = next();
  // A warning concerns a member that mjforge did not write: a name that cannot be converted, which
  // is null then, or unusual attributes.
  for (; status == ARCHIVE_OK || status == ARCHIVE_WARN; status = next()) {
    const char* path = archive_entry_pathname(entry);
    if (path == nullptr || path != name) continue;
    const la_int64_t size = archive_entry_size(entry);
    if (size < 0 || static_cast<std::uint64_t>(size) > bytes::kMaxMjcf)
      return fail(fmt::format("it has {} bytes, more than {}", size, bytes::kMaxMjcf));
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (archive_read_data(reader.get(), bytes.data(), bytes.size()) == size) return bytes;
    status = ARCHIVE_FATAL;
    break;
  }
  const char* words = archive_error_string(reader.get());
  return fail(status == ARCHIVE_EOF ? "it is not there"
              : words == nullptr    ? "the archive is damaged"
                                    : words);
}

}  // namespace mjforge::output
