// Streaming XML writer: one element per line, indented by two spaces per level up to a maximum
// depth. No library is used, because writing is the hot path of a batch and a DOM takes twice the
// time.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::mjcf {

class ElementWriter {
 public:
  /// Formats of numbers: ten significant digits; ten digits, with rounding errors replaced by
  /// zero (FlushNoise); integers in micrometres.
  enum class NumberFormat { kExact, kFlushed, kMicrometres };

  /// Makes a writer that appends to the document's text and origins. The text must not contain a
  /// newline yet, because the writer counts lines from 1. Finish() completes the text.
  explicit ElementWriter(MjcfDocument& document);

  /// Writes a line of XML at the current indentation, without escaping.
  void WriteLine(std::string_view text);

  /// Writes `<tag`. `mark` is the place in the spec that produces this line. The caller writes the
  /// attributes next, and then calls CloseEmpty() or BeginContent().
  void OpenElement(std::string_view tag, diag::SourceMark mark = {});
  void CloseEmpty() { FinishLine("/>\n"); }
  void BeginContent();
  /// Writes the end tag of an element that has content.
  void EndElement(std::string_view tag);

  /// Writes `value` followed by `suffix`, which needs no escaping.
  void WriteText(std::string_view name, std::string_view value, std::string_view suffix = {});
  /// Writes attributes without escaping: ` group="3"`.
  void WriteRaw(std::string_view attributes) { Append(attributes); }
  void WriteNumber(std::string_view name, double value) { WriteNumbers(name, {&value, 1}); }
  void WriteNumbers(std::string_view name, std::span<const double> values,
                    NumberFormat format = NumberFormat::kExact);
  /// Writes the first `count` components of a vector as an attribute.
  template <typename V>
  void WriteVector(std::string_view name, const V& value, std::size_t count = V::SizeAtCompileTime,
                   NumberFormat format = NumberFormat::kExact) {
    WriteNumbers(name, {value.data(), count}, format);
  }
  void WritePoint(std::string_view name, const Eigen::Vector3d& value) {
    WriteVector(name, value, 3, NumberFormat::kFlushed);
  }
  void WriteIntegers(std::string_view name, std::span<const int> values);
  /// Writes `pos`, and `quat` unless it is the identity.
  void WritePose(const model::Pose& pose);
  void WriteAttribute(const model::Attribute& attribute);

  /// Appends a copy of the bytes from `begin` to `end` of the text.
  void RepeatText(std::size_t begin, std::size_t end);
  /// Returns the number of bytes written so far.
  std::size_t size() const { return size_; }
  /// Removes the unused end of the document's text. Nothing can be written afterwards.
  void Finish() { text_.resize(size_); }

 private:
  /// Extends the text by `count` bytes, and returns their address, which is valid until the next
  /// call.
  char* Extend(std::size_t count) {
    const std::size_t begin = size_;
    size_ += count;
    if (size_ > text_.size()) MakeRoom();
    return text_.data() + begin;
  }
  void MakeRoom();
  void Append(std::string_view bytes) { bytes.copy(Extend(bytes.size()), bytes.size()); }
  /// Writes an attribute whose value and suffix need no escaping.
  void WriteUnescaped(std::string_view name, std::string_view value, std::string_view suffix);
  void Indent();
  void FinishLine(std::string_view end);
  /// Writes an attribute of numbers, separated by spaces. `write` writes a number as text and
  /// returns the end of the text.
  template <typename T, typename Write>
  void WriteList(std::string_view name, std::span<const T> values, const Write& write);

  std::string& text_;  // grows in steps, because append() takes time; `size_` bytes are used
  std::size_t size_;
  std::vector<LineOrigin>& origins_;
  int line_ = 1;  // current line, 1-based
  std::size_t depth_ = 0;
};

}  // namespace mjforge::mjcf
