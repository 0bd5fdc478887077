#pragma once

// An MJCF file -> the bodies, assets and sections that attaching one of its bodies brings. All
// numbers come from MuJoCo; the XML says which elements there are and where.

#include <filesystem>
#include <memory>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::attach {

/// Reads MJCF files, each once, and keeps what it read. Installs MuJoCo's error
/// handlers in the whole process; not for two threads at the same time.
class MjcfReader : public model::AttachmentSource {
 public:
  /// The XML files are added to `sources`, so that findings can quote them.
  explicit MjcfReader(diag::Sources& sources);
  ~MjcfReader() override;
  MjcfReader(const MjcfReader&) = delete;
  MjcfReader& operator=(const MjcfReader&) = delete;

  const model::Attachment* Attach(const std::filesystem::path& file, const std::string& body,
                                  diag::SourceMark mark, diag::Findings& findings) override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mjforge::attach
