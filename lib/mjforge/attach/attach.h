// Reader of a body of an MJCF file, with everything below it and all elements that refer to it, for
// use in a spec. All numbers come from MuJoCo's compiled model (mjModel); names, files and line
// numbers come from the XML.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "mjforge/diag/diag.h"
#include "mjforge/model/model.h"

namespace mjforge::attach {

/// Reads MJCF files, each only once, and stores the results. Replaces MuJoCo's error handlers,
/// which the whole process shares. Not thread-safe.
class MjcfReader : public model::AttachmentSource {
 public:
  /// The reader adds the XML files to `sources`, so that findings can quote them.
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
