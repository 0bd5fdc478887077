// Check of mesh files in the Wavefront OBJ format.
#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "mjforge/expr/expr.h"
#include "mjforge/mesh_data/formats.h"

namespace mjforge::mesh_data {
namespace {

// A kind of data that faces refer to by index.
struct Kind {
  std::string_view keyword;
  std::string_view name;
  std::size_t numbers;  // least number of numbers in a line
};
// Kinds of data, in the order of their indices in a corner of a face: `vertex/texcoord/normal`.
constexpr std::array<Kind, 3> kKinds = {
    {{"v", "vertex", 3}, {"vt", "texture coordinate", 1}, {"vn", "normal", 3}}};

class ObjCheck {
 public:
  Check Run(std::string_view content) {
    while (!content.empty() && fault_.empty()) {
      ++line_;
      const std::size_t end = std::min(content.find_first_of("\r\n"), content.size());
      CheckLine(content.substr(0, end));
      content.remove_prefix(end);
      content.remove_prefix(content.starts_with("\r\n") ? 2 : content.empty() ? 0 : 1);
    }
    for (std::size_t i = 0; i < kKinds.size() && fault_.empty(); ++i) CheckGreatest(i);
    return {std::move(fault_), data_[0].count};
  }

 private:
  // Number of lines so far with a kind of data, and the greatest index by which a face refers to
  // that kind.
  struct Data {
    std::size_t count = 0;
    double greatest = 0;
    std::string_view word;  // word in the file that has the index `greatest`
    std::size_t line = 0;   // line in the file that has the index `greatest`
  };

  void CheckLine(std::string_view text) {
    const std::vector<std::string_view> words = expr::WordsOf(text);
    if (words.empty()) return;
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
      if (words[0] == kKinds[i].keyword) CheckNumbers(i, words);
    }
    if (words[0] != "f") return;
    for (std::size_t i = 1; i < words.size(); ++i) CheckCorner(words[i]);
  }

  void CheckNumbers(std::size_t kind, const std::vector<std::string_view>& words) {
    const auto& [keyword, name, numbers] = kKinds[kind];
    ++data_[kind].count;
    if (words.size() <= numbers)
      return Report(line_, fmt::format("a {} has fewer than {} numbers", name, numbers));
    const std::size_t end = std::min<std::size_t>(words.size(), 4);
    for (std::size_t i = 1; i < end; ++i) {
      const std::optional<double> number = expr::ParseNumber(words[i]);
      if (number && IsFiniteFloat(*number)) continue;
      return Report(line_, fmt::format("'{}' of a {} is not a finite number", words[i], name));
    }
  }

  void CheckCorner(std::string_view word) {
    std::string_view rest = word;
    for (std::size_t i = 0; i < kKinds.size() && !(rest.empty() && i > 0); ++i) {
      const std::string_view index = diag::CutAt('/', rest);
      if (i == 0 || !index.empty()) CheckIndex(i, index);
    }
    if (!rest.empty()) Report(line_, fmt::format("'{}' is not a corner of a face", word));
  }

  // Checks an index of a face. A negative index counts back from the last line before the face that
  // has this kind of data. Positive indices are checked at the end of the file (CheckGreatest),
  // because the data may be in later lines.
  void CheckIndex(std::size_t kind, std::string_view word) {
    Data& data = data_[kind];
    const std::optional<double> index = ParseInteger(word);
    if (!index) {
      return Report(line_, fmt::format("'{}' is not the number of a {}", word, kKinds[kind].name));
    }
    if (*index > data.greatest) {
      data.greatest = *index;
      data.word = word;
      data.line = line_;
    }
    if (*index == 0 || -*index > static_cast<double>(data.count)) ReportIndex(kind, word, line_);
  }

  // Reports the greatest index by which faces refer to this kind of data if this index is out of
  // range. MuJoCo does not use indices of texture coordinates and normals if the file has no such
  // data.
  void CheckGreatest(std::size_t kind) {
    const Data& data = data_[kind];
    if (kind > 0 && data.count == 0) return;
    if (data.greatest > static_cast<double>(data.count)) ReportIndex(kind, data.word, data.line);
  }

  void ReportIndex(std::size_t kind, std::string_view word, std::size_t line) {
    Report(line,
           fmt::format("a face uses {} {} of {}", kKinds[kind].name, word, data_[kind].count));
  }

  void Report(std::size_t line, std::string_view what) {
    if (fault_.empty()) fault_ = fmt::format("line {}: {}", line, what);
  }

  std::array<Data, kKinds.size()> data_;
  std::size_t line_ = 0;
  std::string fault_;
};

}  // namespace

Check CheckObj(std::string_view content) { return ObjCheck().Run(content); }

}  // namespace mjforge::mesh_data
