#pragma once

// Streams XML elements into a string: one element per line, indented by two spaces per level up to
// a maximum depth. Written by hand because writing is the hot path of a batch (a DOM costs twice as
// much).

#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Dense>

#include "mjforge/diag/diag.h"
#include "mjforge/mjcf/mjcf.h"

namespace mjforge::mjcf {

/// Rotating and adding leaves noise where zeros belong; below a femtometre (or
/// that part of a turn) nothing is meant.
inline double WithoutNoise(double value) { return std::abs(value) < 1e-15 ? 0.0 : value; }

class ElementWriter {
 public:
  enum class Spelling { kNumber, kWithoutNoise, kMicrometres };

  /// Appends to the document's text and origins; the text must be empty or end with a whole line.
  explicit ElementWriter(MjcfDocument& document);

  /// A line, written unchanged.
  void Line(std::string_view text);

  /// Starts `<tag`; attributes follow, then Close() or Content().
  void Open(std::string_view tag, diag::SourceMark mark = {});
  void Close() { Finish("/>\n"); }
  void Content();
  /// Ends an element that has Content().
  void End(std::string_view tag);

  void Text(std::string_view name, std::string_view value);
  /// A name made of two pieces.
  void Text(std::string_view name, std::string_view value, std::string_view suffix);
  /// Attributes, written unchanged: ` group="3"`.
  void Raw(std::string_view attributes) { text_ += attributes; }
  void Number(std::string_view name, double value);
  void Numbers(std::string_view name, std::span<const double> values,
               Spelling spelling = Spelling::kNumber);
  /// The first `count` elements.
  template <typename V>
  void Vector(std::string_view name, const V& value, std::size_t count = V::SizeAtCompileTime,
              Spelling spelling = Spelling::kNumber) {
    Numbers(name, {value.data(), count}, spelling);
  }
  void Point(std::string_view name, const Eigen::Vector3d& value) {
    Vector(name, value, 3, Spelling::kWithoutNoise);
  }
  /// An attribute of whole numbers.
  void Integers(std::string_view name, std::span<const int> values);
  /// `pos`, and `quat` where it is not the identity.
  void Pose(const model::Pose& pose);
  void Attribute(const model::Attribute& attribute);

  /// The text from `begin` to `end`, written once more.
  void Repeat(std::size_t begin, std::size_t end) { text_.append(text_, begin, end - begin); }
  std::size_t size() const { return text_.size(); }

 private:
  void Indent();
  /// An attribute up to and including the opening quote.
  void Begin(std::string_view name);
  void Finish(std::string_view end);
  void Escaped(std::string_view value);
  /// Appends the numbers, one space apart; `write` writes one and returns its end.
  template <typename T, typename Write>
  void AppendAll(std::span<const T> values, const Write& write);

  std::string& text_;
  std::vector<LineOrigin>& origins_;
  int line_ = 1;  // being written
  std::size_t depth_ = 0;
};

}  // namespace mjforge::mjcf
