// Removes attributes of `<key>` elements that are too long for older MuJoCo releases.
#include "mjforge/backport/key_limits.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "mjforge/backport/mjcf_versions.h"
#include "mjforge/engine/engine.h"

namespace mjforge::backport {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kStates[] = {"qpos", "qvel", "act", "ctrl", "mpos", "mquat"};

std::size_t CountWords(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find_first_not_of(kBlanks, at)) != text.npos; ++count)
    at = std::min(text.find_first_of(kBlanks, at), text.size());
  return count;
}

}  // namespace

bool RemoveLongKeys(xml::XmlElement& root, int version, const diag::Sources& sources,
                    diag::Findings* findings) {
  constexpr int kWithoutLimit = 325;
  if (version >= kWithoutLimit) return false;
  bool changed = false;
  for (xml::XmlElement& section : root.children) {
    if (section.tag != "keyframe") continue;
    for (xml::XmlElement& key : section.children) {
      for (const std::string_view name : kStates) {
        const std::string* text = key.Find(name);
        const std::size_t count = text == nullptr ? 0 : CountWords(*text);
        if (count <= kMaxKeyNumbers) continue;
        if (findings != nullptr) {
          findings->Warn(
              diag::Code::kMujocoOlder, xml::MarkOfAttribute(sources, key, name),
              fmt::format("'{}' of {} is left out: it has {} numbers, and MuJoCo {} "
                          "rejects a key with more than {}",
                          name, key.Description(), count, VersionText(version), kMaxKeyNumbers),
              fmt::format("MuJoCo {} and later have no such limit", VersionText(kWithoutLimit)));
        }
        key.Remove(name);
        changed = true;
      }
    }
  }
  return changed;
}

}  // namespace mjforge::backport
