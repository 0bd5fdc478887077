#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/temporary_folder.h"
#include "mjforge/attach/attach.h"

namespace mjforge::attach {

/// MJCF files in a temporary folder, and a reader that attaches bodies of these files.
class Attaching {
 public:
  /// Creates the folder. Writes `arm` to arm.xml, unless `arm` is empty.
  explicit Attaching(const std::string& arm = "");

  void Write(std::string_view name, std::string_view text) const { folder_.Write(name, text); }
  /// Attaches a body of a file (empty: the first body). Returns null after an error.
  const model::Attachment* Try(const std::string& body = "", const std::string& file = "arm.xml");
  /// Attaches a body like Try(). After an error, fails the test and shows the findings.
  const model::Attachment& Get(const std::string& body = "", const std::string& file = "arm.xml");
  /// Returns the findings of the last call, each as "error mujoco/error: message (hint)
  /// [arm.xml:3:5 here]", without the path of the folder.
  std::vector<std::string> Report() const;
  /// Returns the findings of the last call as one text, separated by line ends.
  std::string OnlyFinding() const;
  const diag::Findings& findings() const { return findings_; }

 private:
  harness::TemporaryFolder folder_;
  diag::Sources sources_;
  MjcfReader reader_{sources_};
  diag::Findings findings_;
};

/// Place in a spec at which these tests attach bodies.
inline constexpr diag::SourceMark kMark = {77, 5, 3};

/// Returns an MJCF file with these sections, followed by `<worldbody>` with these bodies.
std::string Mjcf(const std::string& bodies, const std::string& sections = "");

/// Returns the value of an attribute as in MJCF ("0.1 2 3"); "-" if the attribute is missing.
std::string Said(const std::vector<model::Attribute>& attributes, std::string_view name);
/// Returns the names and values of all attributes: "contype=0 friction=1 0.1 0.1".
std::string Said(const std::vector<model::Attribute>& attributes);
/// Returns the names of the items of a list, separated by blanks.
template <typename List>
std::string Names(const List& list) {
  std::string names;
  for (const auto& item : list) names += (names.empty() ? "" : " ") + item.name;
  return names;
}

}  // namespace mjforge::attach
