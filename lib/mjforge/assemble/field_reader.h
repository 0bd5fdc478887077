// FieldReader: checked access to the fields of one element of a spec.

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "mjforge/model/model.h"

namespace mjforge::assemble {

/// Reads the fields (keys with values) of one element, and checks their values against the rules in
/// spec::FieldInfo. Each function that returns nullopt or false adds a finding.
class FieldReader {
 public:
  /// `path` is the random stream (sequence of random numbers) of the element. Each field draws from
  /// the child stream with the field's key.
  FieldReader(sample::Evaluator& values, diag::Findings& findings, std::string_view element,
              std::string_view name, sample::StreamId path)
      : values_(values), findings_(findings), element_(element), name_(name), path_(path) {}

  /// Returns a reader for a child element: the child at index `position` among the children with
  /// this tag. The child has its own streams, but findings name the parent element.
  FieldReader ForChild(std::string_view tag, std::size_t position) const {
    FieldReader child = *this;
    child.path_ = sample::Child(sample::Child(path_, tag), position);
    return child;
  }

  /// Returns the random stream of the element.
  sample::StreamId path() const { return path_; }

  std::optional<double> Number(const spec::Field& field);
  bool Numbers(const spec::Field& field, sample::Numbers& out);
  /// Returns the numbers of a field that must contain exactly N numbers.
  template <int N>
  std::optional<Eigen::Matrix<double, N, 1>> Vector(const spec::Field& field) {
    sample::Numbers numbers;
    if (!Numbers(field, numbers) || !HasCount(field, numbers, N)) return std::nullopt;
    return Eigen::Matrix<double, N, 1>(numbers.data());
  }
  bool HasCount(const spec::Field& field, const sample::Numbers& numbers, std::size_t count);
  std::optional<sample::PointList> Points(const spec::Field& field);
  std::optional<std::vector<sample::HoleOutline>> Outlines(const spec::Field& field);
  std::optional<std::string> Text(const spec::Field& field);
  /// Returns the text of a field, which must be one of the words in its FieldInfo.
  std::optional<std::string> Word(const spec::Field& field);
  std::optional<bool> Boolean(const spec::Field& field);
  bool ReadAttribute(const spec::Field& field, model::Attribute& out);

  /// Reads an optional field into `out`, which is unchanged if `entry` does not have the field.
  /// `read` is a function above, such as &FieldReader::Number, or one with the same arguments.
  template <typename Entry, typename Read, typename Out>
  bool ReadOptional(const Entry& entry, spec::Key key, Read read, Out& out) {
    const spec::Field* field = entry.Find(key);
    if (field == nullptr) return true;
    auto value = std::invoke(read, *this, *field);
    if (!value) return false;
    out = *std::move(value);
    return true;
  }

  /// Returns the element as messages name it: "part 'head'".
  std::string Owner() const;
  /// Adds the finding "KEY of OWNER <what>". Returns false.
  bool Report(diag::Code code, const spec::Field& field, std::string_view what,
              std::string hint = {});
  /// Adds the finding "OWNER <what>". Returns false.
  bool ReportElement(diag::Code code, diag::SourceMark mark, std::string_view what,
                     std::string hint = {});
  diag::Findings& findings() { return findings_; }

 private:
  /// Returns the random stream of the field. If the field draws no random number, returns the
  /// stream of the element, which saves a hash.
  sample::StreamId PathOf(const spec::Field& field) const {
    return spec::HasDraw(field.value) ? sample::Child(path_, field.info->key) : path_;
  }
  /// Adds a finding with the rule that a number of the field violates. `position` is the index of
  /// the number among the `count` numbers of the field.
  void ReportNumber(const spec::Field& field, double number, std::size_t position,
                    std::size_t count);

  sample::Evaluator& values_;
  diag::Findings& findings_;
  std::string_view element_;
  std::string_view name_;
  sample::StreamId path_;
};

}  // namespace mjforge::assemble
