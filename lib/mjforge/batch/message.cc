// Binary encoding of tasks and results.

#include "mjforge/batch/message.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <utility>

namespace mjforge::batch {
namespace {

// Encoder and Decoder have one overload Code(x) for each type, so that one order of fields serves
// both directions. Numbers keep their representation in memory, because leader and worker are the
// same program.

// Writes values to `out`, or only counts their bytes if `out` is null.
class Encoder {
 public:
  explicit Encoder(char* out) : out_(out) {}

  template <typename T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void Code(const T& value) { Put(&value, sizeof(value)); }
  void Code(std::string_view text) {
    Code(text.size());
    Put(text.data(), text.size());
  }
  std::size_t size() const { return size_; }

  static constexpr bool kReads = false;

 private:
  void Put(const void* bytes, std::size_t size) {
    // Uses std::copy_n, because memcpy must not get the null pointer of an empty view.
    if (out_ != nullptr) std::copy_n(static_cast<const char*>(bytes), size, out_ + size_);
    size_ += size;
  }

  char* out_;
  std::size_t size_ = 0;
};

class Decoder {
 public:
  explicit Decoder(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void Code(T& value) { std::memcpy(&value, Take(sizeof(value)).data(), sizeof(value)); }
  void Code(std::string_view& text) {
    std::size_t size = 0;
    Code(size);
    text = Take(size);
  }
  void Code(std::string& text) {
    std::string_view taken;
    Code(taken);
    text = taken;
  }

  static constexpr bool kReads = true;

 private:
  std::string_view Take(std::size_t count) {
    if (count > bytes_.size()) throw std::logic_error("a message from a worker is cut short");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }

  std::string_view bytes_;
};

// Members(x) returns references to the members of a struct in the order of their encoding.
auto Members(diag::SourceMark& mark) { return std::tie(mark.file, mark.line, mark.column); }
auto Members(diag::Note& note) { return std::tie(note.mark, note.message); }
auto Members(diag::Finding& finding) {
  return std::tie(finding.severity, finding.code, finding.mark, finding.message, finding.hint,
                  finding.notes, finding.seed, finding.index);
}
auto Members(FindingSummary::Group& group) {
  return std::tie(group.finding, group.variants, group.last_index);
}
auto Members(FinishedVariant& done) {
  return std::tie(done.index, done.name, done.status, done.attempt, done.place);
}
auto Members(SourceText& source) { return std::tie(source.number, source.name, source.text); }
auto Members(Chunk& chunk) { return std::tie(chunk.first, chunk.count, chunk.archive); }
auto Members(QuarantinedVariant& quarantined) {
  return std::tie(quarantined.index, quarantined.too_slow, quarantined.how);
}
auto Members(HashedAsset& asset) {
  return std::tie(asset.name, asset.source, asset.sha256, asset.made);
}
auto Members(Task& task) { return std::tie(task.chunk, task.quarantined); }
auto Members(ChunkResult& result) {
  return std::tie(result.chunk, result.done, result.statuses, result.lines, result.segment,
                  result.text, result.variants, result.assets, result.inputs, result.findings,
                  result.more_findings, result.sources, result.files_failed,
                  result.output_findings);
}

template <typename Coder, typename T>
void Code(Coder& coder, T& value) {
  if constexpr (requires { Members(value); }) {
    std::apply([&](auto&... members) { (Code(coder, members), ...); }, Members(value));
  } else {
    coder.Code(value);
  }
}

template <typename Coder, typename T>
void Code(Coder& coder, std::vector<T>& list) {
  std::size_t size = list.size();
  coder.Code(size);
  if constexpr (Coder::kReads) list.resize(size);
  for (T& item : list) Code(coder, item);
}

template <typename Coder, typename T>
void Code(Coder& coder, std::optional<T>& value) {
  bool has_value = value.has_value();
  coder.Code(has_value);
  if constexpr (Coder::kReads) {
    if (has_value) value.emplace();
  }
  if (value) Code(coder, *value);
}

template <typename Coder>
void Code(Coder& coder, diag::Findings& findings) {
  std::vector<diag::Finding> list(findings.begin(), findings.end());
  Code(coder, list);
  if constexpr (Coder::kReads) {
    for (diag::Finding& finding : list) findings.Add(std::move(finding));
  }
}

// Encodes to `out`, or only counts the bytes if `out` is null; returns the number of bytes.
template <typename Message>
std::size_t EncodeMessage(char* out, const Message& message) {
  Encoder encoder(out);
  Code(encoder, const_cast<Message&>(message));  // an encoder only reads
  return encoder.size();
}

template <typename Message>
std::string EncodeMessage(const Message& message) {
  std::string bytes(EncodeMessage(nullptr, message), '\0');
  EncodeMessage(bytes.data(), message);
  return bytes;
}

template <typename Message>
Message DecodeMessage(std::string_view bytes) {
  Message message;
  Decoder decoder(bytes);
  Code(decoder, message);
  return message;
}

}  // namespace

std::string Encode(const Task& task) { return EncodeMessage(task); }
std::string Encode(const ChunkResult& result) { return EncodeMessage(result); }
std::size_t EncodedSize(const ChunkResult& result) { return EncodeMessage(nullptr, result); }
void EncodeTo(char* out, const ChunkResult& result) { EncodeMessage(out, result); }
Task DecodeTask(std::string_view bytes) { return DecodeMessage<Task>(bytes); }
ChunkResult DecodeResult(std::string_view bytes, std::shared_ptr<const void> memory) {
  ChunkResult result = DecodeMessage<ChunkResult>(bytes);
  result.memory = std::move(memory);
  return result;
}

}  // namespace mjforge::batch
