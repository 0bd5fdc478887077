// Comparison of batches that make the same variants in several ways.

#include "batches.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <utility>

#include <catch2/catch.hpp>

#include "harness/temporary_folder.h"
#include "mjforge/batch/batch.h"

namespace mjforge::batch {
namespace {

class BatchComparison {
 public:
  BatchComparison(forge::Loaded& loaded, const forge::Options& options, std::uint64_t count,
                  bool is_series)
      : loaded_(loaded), options_(options), count_(count), is_series_(is_series) {}

  bool Run() {
    Make(Of("whole"));
    whole_ = Bytes("whole");
    REQUIRE(whole_.contains(is_series_ ? "x.manifest.jsonl" : "manifest.jsonl"));
    CompareJobs();
    CompareShards();
    CompareGrown();
    CompareAlone();
    CompareRepaired();
    return CompareStopped();
  }

 private:
  // Requests all variants, from one worker.
  Request Of(const std::string& output) const {
    constexpr std::uint64_t kPerArchive = 4;  // the last archive has fewer variants
    Request request;
    request.count = count_;
    request.variant = options_;
    request.jobs = 1;
    request.durability = output::Durability::kNone;
    std::string why_not;
    const std::string path = (folder_ / output).string() + (is_series_ ? "/x_%05d.tar" : "");
    const auto destination = output::ParseDestination(path, kPerArchive, why_not);
    INFO(why_not);
    REQUIRE(destination);
    request.destination = *destination;
    return request;
  }

  Summary Make(const Request& request, const Observer& observer = {}) {
    Summary summary = batch::Run(loaded_.recipe, loaded_.sources, request, observer);
    for (const diag::Finding& finding : summary.findings) UNSCOPED_INFO(finding.message);
    REQUIRE_FALSE(summary.files_failed);
    return summary;
  }

  void Resume(Request request) {
    request.resume = true;
    Make(request);
  }

  std::map<std::string, std::string> Bytes(const std::string& subfolder) const {
    std::map<std::string, std::string> bytes;
    for (const std::string& file : folder_.Files()) {
      if (file.starts_with(subfolder + "/"))
        bytes.emplace(file.substr(subfolder.size() + 1), folder_.Read(file));
    }
    return bytes;
  }

  void CompareJobs() {
    Request request = Of("jobs");
    request.jobs = 3;
    Make(request);
    REQUIRE(Bytes("jobs") == whole_);
  }

  void CompareShards() {
    for (const std::uint64_t index : {2, 0, 1}) {
      Request request = Of("shards");
      request.shard = {index, 3};
      Make(request);
    }
    diag::Sources sources;
    diag::Findings findings;
    const auto merged = Merge(Of("shards").destination, true, sources, findings);
    for (const diag::Finding& finding : findings) UNSCOPED_INFO(finding.message);
    REQUIRE(merged == count_);
    auto bytes = Bytes("shards");
    std::erase_if(bytes,
                  [](const auto& file) { return file.first.find("-of-") != std::string::npos; });
    REQUIRE(bytes == whole_);
  }

  void CompareGrown() {
    Request half = Of("grown");
    half.count = count_ / 2;
    Make(half);
    Resume(Of("grown"));
    REQUIRE(Bytes("grown") == whole_);
  }

  void CompareRepaired() {
    const auto lost = std::ranges::find_if(whole_, [](const auto& file) {
      return file.first.ends_with(".xml") || file.first.ends_with(".tar");
    });
    REQUIRE(lost != whole_.end());
    std::filesystem::remove(folder_ / ("jobs/" + lost->first));
    Resume(Of("jobs"));
    REQUIRE(Bytes("jobs") == whole_);
  }

  // Stops a batch after a third of its variants, and resumes it.
  bool CompareStopped() {
    std::atomic<bool> stop = false;
    Request request = Of("stopped");
    request.stop = &stop;
    Observer observer;
    observer.variant = [&](const FinishedVariant& done) { stop = done.index >= count_ / 3; };
    const bool was_stopped = Make(request, observer).interrupted;
    Resume(Of("stopped"));
    REQUIRE(Bytes("stopped") == whole_);
    return was_stopped;
  }

  // Makes the last valid variant without a batch, and looks for its text in the whole batch.
  void CompareAlone() {
    forge::Variant alone;
    std::uint64_t index = count_;
    do {
      REQUIRE(index > 0);
      forge::Generator(loaded_.recipe, loaded_.sources, options_).Make(--index, alone);
    } while (!alone.ok());
    INFO("index " << index);
    REQUIRE(std::ranges::any_of(whole_, [&](const auto& file) {
      return file.second.find(alone.document.text) != std::string::npos;
    }));
  }

  forge::Loaded& loaded_;
  const forge::Options& options_;
  std::uint64_t count_;
  bool is_series_;
  harness::TemporaryFolder folder_;
  std::map<std::string, std::string> whole_;
};

}  // namespace

bool CompareBatches(forge::Loaded& loaded, const forge::Options& options, std::uint64_t count,
                    bool is_series) {
  return BatchComparison(loaded, options, count, is_series).Run();
}

}  // namespace mjforge::batch
