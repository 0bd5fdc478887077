#ifndef MJFORGE_FORGE_DIGEST_H_
#define MJFORGE_FORGE_DIGEST_H_

#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "mjforge/diag/diag.h"

namespace mjforge::forge {

/// The findings of many variants in little room: the first of each kind and
/// place, and how many variants had it. Values differ from variant to variant
/// and so do messages; the mistake to mend is one.
class Digest {
 public:
  explicit Digest(std::size_t limit) : limit_(limit) {}

  /// The findings of one variant.
  void Add(const diag::Findings& findings, bool as_warnings);

  /// In file order.
  diag::Findings Result() const;
  std::uint64_t not_shown() const { return not_shown_; }

 private:
  // The place, that of the first note (an attached file's findings all stand at
  // one place of the spec), and without a place the message.
  using Key = std::tuple<diag::Code, diag::SourceMark, diag::SourceMark, std::string>;
  struct Entry {
    diag::Finding finding;
    std::uint64_t variants = 0;
    std::uint64_t last_index = 0;
  };

  std::size_t limit_;
  std::map<Key, std::size_t> positions_;
  std::vector<Entry> entries_;
  std::uint64_t not_shown_ = 0;
};

}  // namespace mjforge::forge

#endif  // MJFORGE_FORGE_DIGEST_H_
