#pragma once

// ObjectSpec + (seed, index) -> values. Every draw is a pure function of the
// seed, the variant's index, the attempt and the path of the value in the spec
// (and of the batch's size, where a Sampler is told it).
//
// An Evaluator first draws the parameters and tests the requirements. Then it gives the model the
// values of the spec one by one, in the order in which the model asks.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mjforge/diag/diag.h"
#include "mjforge/expr/expr.h"
#include "mjforge/sample/sampler.h"
#include "mjforge/sample/streams.h"
#include "mjforge/sample/values.h"
#include "mjforge/spec/spec.h"

namespace mjforge::sample {

/// Evaluates the values of one spec for one variant, in the scope of that spec's names. Errors are
/// added to the findings and make the result useless; then `failed()` is true. Without a sampler
/// everything is drawn at random; a sampler must outlive the evaluator.
class Evaluator {
 public:
  using Overrides = std::span<const std::pair<std::string, ParameterValue>>;

  Evaluator(const spec::ObjectSpec& spec, DrawKey key, StreamId root, diag::Findings& findings,
            const Sampler* sampler = nullptr);

  /// Draws all parameters and tests the requirements. False: some requirement
  /// does not hold (`rejected_by()`), or there was an error (`failed()`).
  /// Overrides replace the parameters' own values.
  bool SampleParameters(Overrides overrides = {});
  /// Draws the parameters until they meet the requirements; `key().attempt` counts up until they
  /// do. Returns false, and adds a finding, if that takes more than kMaxAttempts or a draw fails.
  bool Sample(Overrides overrides);

  double Number(const spec::Value& value, StreamId path);
  bool Boolean(const spec::Value& value, StreamId path);
  std::string Text(const spec::Value& value, StreamId path);
  /// Replaces the content of `out` with the vector's components, of a number the one.
  void Vector(const spec::Value& value, StreamId path, Numbers& out);
  /// The value as its type says; a vector is a list or has several components.
  ParameterValue Any(const spec::Value& value, StreamId path);
  /// The values of a list or a vector.
  Items List(const spec::Value& value, StreamId path);
  PointList Points(const spec::Value& value, StreamId path);
  std::vector<PointList> Outlines(const spec::Value& value, StreamId path);
  /// The values that a loop's variable takes; nothing after a finding.
  std::optional<LoopRange> RangeOf(const spec::Loop& loop);
  bool Condition(const expr::Expression& expression, diag::SourceMark mark);
  /// "a = 1, b = true": what an expression is computed from, texts excluded.
  std::string InputsText(const expr::Expression& expression) const;

  void SetVariable(int slot, double value);
  void SetVariable(int slot, std::string_view text);
  void SetVariable(const spec::Loop& loop, const LoopRange& range, std::size_t i);
  /// Sets the value of a name that the assembly defines, by its first slot, to the value of
  /// other.spec().parameters[i].
  void SetVariable(int slot, const Evaluator& other, std::size_t i);
  /// Gives a local value its value, drawn under `path`.
  void SetLocal(const spec::Local& local, StreamId path);
  StreamId root() const { return root_; }
  const DrawKey& key() const { return key_; }
  const Sampler* sampler() const { return sampler_; }
  const spec::ObjectSpec& spec() const { return spec_; }
  bool failed() const { return failed_; }
  /// Adds a finding of this variant and returns NaN, the value of a failed number.
  double Fail(diag::Code code, diag::SourceMark mark, std::string message, std::string hint = {});
  int rejected_by() const { return rejected_by_; }
  /// The value of spec().parameters[i].
  ParameterValue Parameter(std::size_t i) const;

 private:
  std::array<double, 4> Uniforms(StreamId path) const {
    return sampler_ != nullptr ? sampler_->Uniforms(key_, path) : sample::Uniforms(key_, path);
  }
  /// Draws the parameters of imported files. False after a finding.
  bool SampleShared(Overrides overrides);
  bool Holds(const spec::Requirement& requirement);
  void DrawParameter(std::size_t i);
  void SetParameter(const spec::Parameter& parameter, const ParameterValue& value);
  void SetComponents(const spec::Parameter& parameter, std::span<const double> components);
  void SetList(const spec::Parameter& parameter, std::vector<double> numbers,
               std::vector<std::string> texts);
  /// All of a list, or of a vector, that a name stands for.
  Items Whole(const spec::VariableReference& variable, int components);
  Items Repeated(const spec::Each& each, StreamId path);
  Items Arranged(const spec::Arrangement& arrangement, StreamId path);
  /// How long a list is to be; nothing after a finding.
  std::optional<std::size_t> Length(const spec::Value& count, StreamId path);
  void AppendItem(const spec::Value& item, expr::Type type, StreamId path, Items& out);
  /// The numbers 0 to count - 1 in random order.
  std::vector<std::size_t> Order(std::size_t count, StreamId path) const;
  double Variable(int slot) const;
  double EvaluateExpression(const expr::Expression& expression, diag::SourceMark mark);
  double DrawNumber(const spec::Draw& draw, diag::SourceMark mark, StreamId path);
  const spec::Value& Chosen(const spec::Draw& draw, diag::SourceMark mark, StreamId& path);
  /// The value of a record's column in the row of its key.
  const spec::Value& OfRow(const spec::Draw& draw, diag::SourceMark mark, StreamId& path);
  /// Whether the draw is planned over the batch rather than made for each item.
  bool IsExact(const spec::Draw& draw) const {
    return draw.exact && sampler_ != nullptr && sampler_->batch() > 0;
  }
  std::optional<Numbers> Weights(const spec::Draw& draw, diag::SourceMark mark, StreamId path);
  std::size_t Option(const spec::Draw& draw, std::span<const double> weights, StreamId path) const;
  void AppendPiece(const spec::TextPiece& piece, diag::SourceMark mark, std::string& out);
  /// The text that an expression's result stands for.
  const std::string& TextOf(const expr::Expression& expression, double key) const;
  void AppendRotation(StreamId path, Numbers& out);
  void AppendAbout(const spec::RotationAbout& about, diag::SourceMark mark, StreamId path,
                   Numbers& out);
  void AppendOnSphere(const spec::PointOnSphere& point, diag::SourceMark mark, StreamId path,
                      Numbers& out);
  void AppendColor(const spec::HsvColor& color, diag::SourceMark mark, StreamId path, Numbers& out);
  /// The stream of item i below path; path itself for items that draw nothing.
  static StreamId ItemStream(const spec::Value& item, StreamId path, std::size_t i);
  /// Appends the components of a value that is a vector or a number.
  void AppendVector(const spec::Value& value, StreamId path, Numbers& out);
  friend class Attempts;

  const spec::ObjectSpec& spec_;
  DrawKey key_;
  StreamId root_;
  diag::Findings* findings_;
  const Sampler* sampler_;
  std::vector<double> variables_;   // by slot
  std::vector<std::string> texts_;  // by slot
  std::vector<expr::Sequence> lists_;
  std::vector<std::vector<std::string>> list_texts_;  // of the lists of texts
  std::vector<StreamId> streams_;                     // by parameter
  std::vector<Evaluator> shared_;                     // of the specs of spec_.shared
  bool failed_ = false;
  int rejected_by_ = -1;
};

/// The most redraws before a variant counts as impossible.
inline constexpr std::uint64_t kMaxAttempts = 1000;

/// An Evaluator after its Sample(); nothing, and a finding, when that fails.
std::optional<Evaluator> Sample(const spec::ObjectSpec& spec, DrawKey key, StreamId root,
                                Evaluator::Overrides overrides, diag::Findings& findings,
                                const Sampler* sampler = nullptr);

}  // namespace mjforge::sample
