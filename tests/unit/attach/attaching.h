#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "harness/temporary_folder.h"
#include "mjforge/attach/attach.h"

namespace mjforge::attach {

/// Files in a folder of their own, and bodies of them.
class Attaching {
 public:
  /// Nothing but `arm.xml`, if there is a text for it.
  explicit Attaching(const std::string& arm = "");

  void Write(std::string_view name, std::string_view text) const { folder_.Write(name, text); }
  /// Null after an error.
  const model::Attachment* Try(const std::string& body = "", const std::string& file = "arm.xml");
  /// Fails the test, with the findings, if there is none.
  const model::Attachment& Get(const std::string& body = "", const std::string& file = "arm.xml");
  /// Findings of the last call, each as "error mujoco/error: message (hint) [arm.xml:3:5 here]",
  /// without the folder's name.
  std::vector<std::string> Report() const;
  /// The finding of the last call; all of them, separated by line ends, if there are several.
  std::string OnlyFinding() const;
  const diag::Findings& findings() const { return findings_; }

 private:
  harness::TemporaryFolder folder_;
  diag::Sources sources_;
  MjcfReader reader_{sources_};
  diag::Findings findings_;
};

/// The place in a spec that attaches, for all of these tests.
inline constexpr diag::SourceMark kMark = {77, 5, 3};

/// `<mujoco>` with these sections around `<worldbody>`.
std::string Mjcf(const std::string& bodies, const std::string& sections = "");

/// "0.1 2 3" of an attribute, or its text; "-" if there is none.
std::string Said(const std::vector<model::Attribute>& attributes, std::string_view name);
/// All attributes: "contype=0 friction=1 0.1 0.1".
std::string Said(const std::vector<model::Attribute>& attributes);
/// Names of named things, one blank apart.
template <typename List>
std::string Names(const List& list) {
  std::string names;
  for (const auto& item : list) names += (names.empty() ? "" : " ") + item.name;
  return names;
}

}  // namespace mjforge::attach
