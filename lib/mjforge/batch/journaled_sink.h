// Base class of the sinks (outputs of a batch) that keep a journal: folders, archives and families.

#pragma once

#include <optional>

#include "mjforge/batch/journal.h"
#include "mjforge/batch/sink.h"

namespace mjforge::batch {

/// Sink (output of a batch) with a journal of checkpoints, so that an unfinished batch can be
/// resumed.
class JournaledSink : public Sink {
 public:
  explicit JournaledSink(const SinkOptions& options)
      : options_(options),
        request_(options.request),
        destination_(request_.destination),
        journal_(options) {
    checkpoint_.next = options_.range.first;
  }

  std::optional<ResumedVariants> Open(diag::Findings& findings) override;

 protected:
  /// Continues the outputs of an earlier run, after the journal was opened. Returns the variants
  /// that need not be made again; nullopt after adding a finding.
  virtual std::optional<ResumedVariants> Continue(diag::Findings& findings) = 0;

  SinkOptions options_;
  const Request& request_;
  const output::Destination& destination_;
  output::MadeFolders folders_;  // declared before journal_, to be destroyed after journal_
  Journal journal_;
  Checkpoint checkpoint_;  // state of all outputs (manifest, archives)
};

}  // namespace mjforge::batch
