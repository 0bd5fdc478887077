// Running a batch: tasks for the pool, results in index order, findings, progress, interruption.

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <thread>

#include "mjforge/batch/finding_summary.h"
#include "mjforge/batch/pool.h"
#include "mjforge/batch/schedule.h"
#include "mjforge/batch/sink.h"
#include "mjforge/batch/worker.h"

namespace mjforge::batch {
namespace {

using Clock = std::chrono::steady_clock;

// Approximate limit, in bytes, of results that wait because a result with lower indices is missing.
constexpr std::size_t kMaxWaitingBytes = std::size_t{8} << 20;
// Time that workers have to finish their current variants when the batch must stop.
constexpr std::chrono::seconds kGrace{2};
constexpr auto kProgressEvery = std::chrono::milliseconds(100);

std::uint64_t Cores() { return std::max(1U, std::thread::hardware_concurrency()); }

// Warns if this batch does not cover the values of a sampler or of an exact choice evenly, because
// the batch overlaps several blocks of `options.batch` variants, or because a grid has more or
// fewer points than the batch has variants.
void CheckSpread(const forge::Recipe& recipe, const Request& request, diag::Findings& findings) {
  const forge::Options& options = request.variant;
  const std::uint64_t size = options.batch;
  const sample::Sampler sampler(*recipe.spec, options.sampler, options.seed, size);
  if (!sampler.NeedsBatch() || size == 0) return;
  if (request.first % size != 0 && request.first % size + request.count > size) {
    findings.Warn(diag::Code::kBatchUneven, {},
                  fmt::format("variants {} to {} lie in several blocks of {}: draws are spread "
                              "evenly over each block, not over these variants",
                              request.first, request.first + (request.count - 1), size),
                  fmt::format("make --first a multiple of {}", size));
  }
  const std::uint64_t points = sampler.GridPoints();
  if (points > size) {
    findings.Warn(diag::Code::kBatchUneven, {},
                  fmt::format("the grid has {}; {} variants cover only the first of them",
                              sampler.GridText(), size),
                  "make more variants, or pin a parameter with --set");
  } else if (points > 0 && points < size) {
    findings.Warn(diag::Code::kBatchUneven, {},
                  fmt::format("the grid has {}; the last {} of {} variants repeat some of them",
                              sampler.GridText(), size - points, size),
                  fmt::format("-n {} makes each of them once", points));
  }
}

class BatchRun {
 public:
  BatchRun(const forge::Recipe& recipe, diag::Sources& sources, const Request& request,
           const Observer& observer)
      : recipe_(recipe),
        sources_(sources),
        request_(request),
        observer_(observer),
        all_{request.first, request.count},
        range_(RangeOfShard(request.shard, all_, request.destination)),
        record_(forge::BatchRecord(recipe, OptionsOf(request))) {
    summary_.count = range_.count;
  }

  Summary operator()() {
    const std::unique_ptr<Sink> sink = MakeSink({request_, all_, range_, record_}, summary_.text);
    diag::Findings output_findings;
    CheckSpread(recipe_, request_, output_findings);
    if (const std::optional<ResumedVariants> resumed = sink->Open(output_findings)) {
      static_cast<manifest::StatusCounts&>(summary_) = *resumed;
      summary_.resumed = resumed->done();
      if (observer_.resumed && summary_.resumed > 0) observer_.resumed(summary_.resumed);
      has_lost_worker_ = summary_.resumed < range_.count;  // assumed until Make() succeeds
      try {
        Make(*sink, output_findings);
      } catch (const std::runtime_error& error) {
        output_findings.Add(diag::Code::kBatchWorkerDied, {}, error.what());
        summary_.files_failed = true;
      }
      End(*sink, output_findings);
    } else {
      summary_.files_failed = true;
    }
    summary_.findings = finding_summary_.Findings();
    summary_.more_findings = finding_summary_.not_shown();
    summary_.findings.Append(std::move(output_findings));
    return std::move(summary_);
  }

 private:
  void Make(Sink& sink, diag::Findings& output_findings) {
    const IndexRange todo = {range_.first + summary_.resumed, range_.count - summary_.resumed};
    if (todo.count == 0) return;
    const std::uint64_t jobs = std::min(request_.jobs == 0 ? Cores() : request_.jobs, todo.count);
    Schedule schedule(all_, todo, request_.destination, jobs);
    // Assigns quick workers more tasks, because they may finish before the leader runs again.
    const bool is_quick = request_.variant.validation == manifest::Validation::kNone;
    const Request request = WithSuperset();
    Pool pool(jobs, is_quick ? kMaxTasksPerWorker : 2, request_.time_limit, [&] {
      return MakeTaskHandler(recipe_, sources_, request, sink.overwrite(), bool{observer_.variant});
    });
    next_ = todo.first;
    std::optional<Chunk> chunk = schedule.Next();
    std::optional<Clock::time_point> stopped;
    bool goes_on = true;
    while (chunk || pool.IsBusy() || (goes_on && HasNext())) {
      while (chunk && pool.HasRoom() && waiting_bytes_ < kMaxWaitingBytes) {
        pool.Submit({*chunk, {}});
        chunk = schedule.Next();
      }
      // Takes only one result at a time, so that workers get new tasks in between.
      if (std::optional<ChunkResult> result = pool.Wait(!HasNext())) {
        waiting_bytes_ += SizeOf(*result);
        const std::uint64_t first = result->chunk.first;
        waiting_.emplace(first, *std::move(result));
      }
      goes_on = goes_on && (!HasNext() || TakeNext(sink, output_findings));
      ShowProgress();
      summary_.interrupted |=
          request_.stop != nullptr && request_.stop->load(std::memory_order_relaxed);
      if ((summary_.interrupted || !goes_on) && !stopped) {
        // Workers stop by themselves, so that none leaves an incomplete file.
        stopped = Clock::now();
        pool.AskToStop();
        chunk.reset();
      }
      if (stopped && Clock::now() - *stopped > kGrace) return;
    }
    has_lost_worker_ = pool.has_lost_worker();
  }

  // Returns the request with the superset, the geoms and sites that padding gives to every variant.
  // The superset is found once, before the workers start, and not by each worker.
  Request WithSuperset() const {
    Request request = request_;
    if (request.variant.pad == 0) return request;
    forge::Options options = OptionsOf(request_);
    options.validation = manifest::Validation::kNone;
    diag::Sources sources = sources_;  // a copy, because workers number attached files themselves
    request.variant.superset =
        forge::Generator(recipe_, sources, options).FindSuperset(request_.stop);
    return request;
  }

  static std::size_t SizeOf(const ChunkResult& result) {
    return result.lines.size() + result.segment.size() + result.text.size();
  }

  // Returns true if the next result in index order is available.
  bool HasNext() const { return !waiting_.empty() && waiting_.begin()->first == next_; }

  // Writes the next result to the sink; returns false if the batch must stop.
  bool TakeNext(Sink& sink, diag::Findings& output_findings) {
    ChunkResult result = std::move(waiting_.extract(waiting_.begin()).mapped());
    waiting_bytes_ -= SizeOf(result);
    RenumberSources(result);
    const bool taken = sink.Take(result, output_findings);
    // Names the first variant of the chunk, because the sink does not report which variant failed.
    if (!taken) output_findings.SetVariant(request_.variant.seed, result.chunk.first);
    if (!taken || result.files_failed) {
      summary_.files_failed = true;
      output_findings.Append(std::move(result.output_findings));
    }
    if (taken) Count(result);
    next_ = result.chunk.end();
    // A result has fewer variants than its task if the worker was asked to stop.
    return !summary_.files_failed && result.done == result.chunk.count;
  }

  void Count(ChunkResult& result) {
    for (const Status status : result.statuses) summary_.Add(status);
    summary_.inputs.insert(result.inputs.begin(), result.inputs.end());
    for (FindingSummary::Group& group : result.findings) finding_summary_.Add(std::move(group));
    finding_summary_.AddNotShown(result.more_findings);
    if (!observer_.variant) return;
    for (const FinishedVariant& done : result.variants) observer_.variant(done);
  }

  // Adds the texts that only workers have read to sources_, each text once. Replaces the worker's
  // numbers of texts in findings by the numbers in sources_.
  void RenumberSources(ChunkResult& result) {
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (SourceText& source : result.sources) {
      auto known = attached_.find(source.name);
      if (known == attached_.end()) {
        const std::uint32_t number = sources_.Add(source.name, std::move(source.text));
        known = attached_.emplace(source.name, number).first;
      }
      numbers.emplace(source.number, known->second);
    }
    const auto renumber = [&](diag::Finding& finding) {
      const auto change = [&](diag::SourceMark& mark) {
        if (const auto number = numbers.find(mark.file); number != numbers.end())
          mark.file = number->second;
      };
      change(finding.mark);
      for (diag::Note& note : finding.notes) change(note.mark);
    };
    for (FindingSummary::Group& group : result.findings) renumber(group.finding);
    for (diag::Finding& finding : result.output_findings) renumber(finding);
  }

  // Writes the snapshot of a spec whose file cannot be read again beside the manifest, so that
  // replaying finds it. Journal::Open has checked that an existing file there may be replaced.
  bool WriteSnapshot(diag::Findings& findings) const {
    return recipe_.snapshot.empty() || !request_.destination.HasManifest() ||
           output::WriteSingleFile(SnapshotPath(request_.destination), recipe_.snapshot, findings);
  }

  void ShowProgress() {
    if (!observer_.progress || Clock::now() - shown_ < kProgressEvery) return;
    shown_ = Clock::now();
    observer_.progress(summary_);
  }

  void End(Sink& sink, diag::Findings& output_findings) {
    if (has_lost_worker_) sink.RemoveAbandoned();
    const bool is_broken = summary_.interrupted || summary_.files_failed;
    // A shard without a valid variant is finished, because merging needs its manifest.
    const bool has_nothing =
        is_broken ? summary_.done() == 0 : summary_.ok == 0 && request_.shard.IsWhole();
    const bool is_withheld = request_.all_or_nothing && summary_.failed > 0;
    if (has_nothing) {
      sink.Drop(is_broken);
    } else if (!WriteSnapshot(output_findings)) {
      summary_.files_failed = true;
    } else if (!is_broken &&
               !is_withheld) {  // an incomplete batch stays under construction, to be resumed
      summary_.files_failed = !sink.Finish(output_findings);
    }
  }

  const forge::Recipe& recipe_;
  diag::Sources& sources_;
  const Request& request_;
  const Observer& observer_;
  IndexRange all_;
  IndexRange range_;
  manifest::Record record_;                       // fields that all records have in common
  std::map<std::uint64_t, ChunkResult> waiting_;  // key: index of the first variant
  std::size_t waiting_bytes_ = 0;
  std::uint64_t next_ = 0;  // index after the last taken result
  bool has_lost_worker_ = false;
  FindingSummary finding_summary_{kMaxFindings};
  std::map<std::string, std::uint32_t>
      attached_;  // leader's numbers of the sources that workers read, by name
  Clock::time_point shown_;
  Summary summary_;
};

}  // namespace

Summary Run(const forge::Recipe& recipe, diag::Sources& sources, const Request& request,
            const Observer& observer) {
  return BatchRun(recipe, sources, request, observer)();
}

}  // namespace mjforge::batch
