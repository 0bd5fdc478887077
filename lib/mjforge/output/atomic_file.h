#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/diag/diag.h"
#include "mjforge/output/durability.h"

namespace mjforge::output {

/// A file under construction: it has a hidden name in the same folder until Commit() gives it its
/// final one. Without Commit() nothing is left of it.
class AtomicFile {
 public:
  static std::unique_ptr<AtomicFile> Create(const std::filesystem::path& file,
                                            diag::Findings& findings);

  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  bool Append(std::string_view bytes, diag::Findings& findings);
  /// With kBatch, once its bytes are on the disk, and waits until the name is there as well.
  bool Commit(Durability durability, diag::Findings& findings);

 private:
  AtomicFile(std::filesystem::path file, std::string temporary, int descriptor);
  void Drop();

  std::filesystem::path file_;
  std::string temporary_;  // empty: committed or dropped
  int descriptor_ = -1;    // -1: closed
};

/// The final name of a file under construction: "x.xml" for ".x.xml.tmp123-0". Nothing for all
/// other names.
std::optional<std::string> UnderConstruction(std::string_view hidden);

/// Adds "cannot write 'FILE': WORDS" with the system's words for `error`, an errno.
void AddCannotWrite(const std::filesystem::path& file, int error, diag::Findings& findings);

/// Writes all bytes to an open file; false, and that finding about `file`, if it
/// cannot.
bool WriteAll(int descriptor, std::string_view bytes, const std::filesystem::path& file,
              diag::Findings& findings);

}  // namespace mjforge::output
