// Binary encoding of the tasks and results that the leading process and its workers exchange.

#include "mjforge/batch/message.h"

#include <stdexcept>
#include <tuple>
#include <utility>

namespace mjforge::batch {
namespace {

// Members of the structs in messages, in the order of their encoding.
struct Fields {
  static auto Of(diag::SourceMark& mark) { return std::tie(mark.file, mark.line, mark.column); }
  static auto Of(diag::Note& note) { return std::tie(note.mark, note.message); }
  static auto Of(diag::Finding& finding) {
    return std::tie(finding.severity, finding.code, finding.mark, finding.message, finding.hint,
                    finding.notes, finding.seed, finding.index);
  }
  static auto Of(FindingSummary::Group& group) {
    return std::tie(group.finding, group.variants, group.last_index);
  }
  static auto Of(FinishedVariant& done) {
    return std::tie(done.index, done.name, done.status, done.attempt, done.place);
  }
  static auto Of(SourceText& source) { return std::tie(source.number, source.name, source.text); }
  static auto Of(Chunk& chunk) { return std::tie(chunk.first, chunk.count, chunk.archive); }
  static auto Of(QuarantinedVariant& quarantined) {
    return std::tie(quarantined.index, quarantined.too_slow, quarantined.how);
  }
  static auto Of(HashedAsset& asset) {
    return std::tie(asset.name, asset.source, asset.sha256, asset.made);
  }
  static auto Of(Task& task) { return std::tie(task.chunk, task.quarantined); }
  static auto Of(ChunkResult& result) {
    return std::tie(result.chunk, result.done, result.statuses, result.lines, result.segment,
                    result.text, result.variants, result.assets, result.inputs, result.findings,
                    result.more_findings, result.sources, result.files_failed,
                    result.output_findings);
  }
};

template <typename Message>
Message Decode(std::string_view message) {
  try {
    return bytes::Decoder<Fields>(message).Read<Message>();
  } catch (const std::runtime_error&) {
    throw std::logic_error("a message from a worker is cut short");
  }
}

}  // namespace

std::string Encode(const Task& task) { return bytes::Encode<Fields>(task); }
std::string Encode(const ChunkResult& result) { return bytes::Encode<Fields>(result); }
std::size_t EncodedSize(const ChunkResult& result) {
  return bytes::EncodeTo<Fields>(nullptr, result);
}
void EncodeTo(char* out, const ChunkResult& result) { bytes::EncodeTo<Fields>(out, result); }
Task DecodeTask(std::string_view bytes) { return Decode<Task>(bytes); }
ChunkResult DecodeResult(std::string_view bytes, std::shared_ptr<const void> memory) {
  ChunkResult result = Decode<ChunkResult>(bytes);
  result.memory = std::move(memory);
  return result;
}

}  // namespace mjforge::batch
