// Evaluator: draws the parameters of a spec for one variant, and evaluates the values of the spec.

#pragma once

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

/// Evaluates the values of one spec for one variant. Sample() draws the parameters and tests the
/// requirements. After that, the assembler of the MuJoCo model requests the values of the spec's
/// fields in any order. Every draw is a pure function of the key (seed, index, attempt) and of the
/// value's path in the spec; some samplers also use the size of the batch.
///
/// A function that fails adds a finding, and returns nullopt, or NaN if it returns numbers. Values
/// that depend on a failed value fail without another finding. After the first failure the variant
/// is unusable, and failed() is true.
///
/// Without a sampler, all draws are independent random numbers. The sampler must outlive the
/// evaluator.
class Evaluator {
 public:
  using Overrides = std::span<const std::pair<std::string, ParameterValue>>;

  Evaluator(const spec::ObjectSpec& spec, DrawKey key, StreamId root, diag::Findings& findings,
            const Sampler* sampler = nullptr);

  /// Draws the parameters until they meet all requirements; each redraw increases key().attempt.
  /// `overrides` replace the values that the spec gives to parameters. Returns false, and adds a
  /// finding, if a draw fails or if kMaxAttempts draws are rejected.
  bool Sample(Overrides overrides);
  /// Draws the parameters once. Returns the index of the first requirement that is not met, or the
  /// number of requirements if all are met; nullopt if a draw fails.
  std::optional<std::size_t> SampleParameters(Overrides overrides = {});

  double Number(const spec::Value& value, StreamId path);
  std::optional<bool> Boolean(const spec::Value& value, StreamId path);
  std::optional<std::string> Text(const spec::Value& value, StreamId path);
  /// Evaluates a vector or a single number, and replaces the content of `out` by its components.
  void Vector(const spec::Value& value, StreamId path, Numbers& out);
  /// Evaluates a value of any kind. A value in the form of a list of numbers gives a vector, also
  /// with one component.
  std::optional<ParameterValue> Any(const spec::Value& value, StreamId path);
  std::optional<PointList> Points(const spec::Value& value, StreamId path);
  std::optional<std::vector<HoleOutline>> Outlines(const spec::Value& value, StreamId path);
  std::optional<LoopRange> RangeOf(const spec::Loop& loop);
  std::optional<bool> Condition(const expr::Expression& expression, diag::SourceMark mark);
  /// Returns "a = 1, b = true": the values of the names that the expression uses, without texts.
  std::string InputsText(const expr::Expression& expression) const;

  void SetVariable(int slot, double value);
  void SetVariable(int slot, std::string_view text);
  void SetVariable(const spec::Loop& loop, const LoopRange& range, std::size_t i);
  /// Returns the current values of an entry's loop variables and local values, for Restore().
  SavedVariables Save(const spec::Entry& entry) const;
  void Restore(const SavedVariables& saved);
  /// Sets the variables of a value, from slot `slot` on, to kFailedNumber. `list` is the index of
  /// the value among the lists; -1 if the value is not a list.
  void ClearVariables(int slot, int list, const spec::Value& value);
  /// Sets the variables of a parameter from slot `slot` on: one for a number, boolean or text, one
  /// per component for a vector.
  void Assign(int slot, const ParameterValue& value);
  /// Evaluates a local value and sets its variables. Draws in the value use the stream `path`.
  /// Returns false, and adds a finding, if the evaluation fails.
  bool SetLocal(const spec::Local& local, StreamId path);

  /// Appends a uniformly distributed random rotation as a quaternion w x y z.
  void AppendRotation(StreamId path, Numbers& out);

  /// Returns the four uniform numbers in (0, 1) of the stream `path`, as the sampler distributes
  /// them.
  std::array<double, 4> Uniforms(StreamId path) const {
    return sampler_ != nullptr ? sampler_->Uniforms(key_, path) : sample::Uniforms(key_, path);
  }

  /// Returns the current value of spec().parameters[i].
  ParameterValue Parameter(std::size_t i) const;
  StreamId root() const { return root_; }
  const DrawKey& key() const { return key_; }
  const Sampler* sampler() const { return sampler_; }
  const spec::ObjectSpec& spec() const { return spec_; }
  bool failed() const { return failed_; }
  /// Adds a finding about this variant, sets failed(), and returns NaN.
  double Fail(diag::Code code, diag::SourceMark mark, std::string message, std::string hint = {});

 private:
  // Defined in rejection.cc.
  bool SampleShared(Overrides overrides);
  bool Holds(const spec::Requirement& requirement);
  void ReportConstant(const spec::Requirement& requirement);
  void ReportRejections(std::span<const std::uint64_t> rejections);

  // Defined in parameters.cc.
  void DrawParameter(const spec::Parameter& parameter);
  void SetParameter(const spec::Parameter& parameter, const ParameterValue& value);

  // Defined in evaluator.cc.
  double Variable(int slot) const { return variables_[static_cast<std::size_t>(slot)]; }
  /// Returns component `i` of the vector to which a name refers. Fails if the component has no
  /// value.
  double Component(const spec::VariableReference& variable, int i, diag::SourceMark mark);
  double EvaluateExpression(const expr::Expression& expression, diag::SourceMark mark);
  /// Evaluates one piece of a text and appends the result. Returns false if the evaluation fails.
  bool AppendPiece(const spec::TextPiece& piece, diag::SourceMark mark, std::string& out);
  /// Returns the text whose TextKey() is `key`, the result of `expression`.
  const std::string& TextOf(const expr::Expression& expression, double key) const;
  /// Evaluates a vector or a single number, and appends its components.
  void AppendVector(const spec::Value& value, StreamId path, Numbers& out);
  /// Returns the random stream of item `i` of the list with stream `path`. Returns `path` itself
  /// for an item without draws, which uses no stream.
  static StreamId ItemStream(const spec::Value& item, StreamId path, std::size_t i);

  // Defined in lists.cc.
  std::optional<Items> List(const spec::Value& value, StreamId path);
  std::optional<Items> CopyList(const spec::VariableReference& variable, const spec::Value& value);
  std::optional<Items> Repeat(const spec::Each& each, StreamId path);
  std::optional<Items> Arrange(const spec::Arrangement& arrangement, StreamId path);
  std::optional<std::size_t> Length(const spec::Value& count, StreamId path);
  /// Appends an item to a list whose items have this type. Returns false if the evaluation of the
  /// item fails.
  bool AppendItem(const spec::Value& item, expr::Type type, StreamId path, Items& out);
  /// Returns the numbers 0 to count - 1 in random order.
  std::vector<std::size_t> RandomPermutation(std::size_t count, StreamId path) const;

  // Defined in draws.cc.
  double DrawNumber(const spec::Draw& draw, diag::SourceMark mark, StreamId path);
  /// Returns the draw of a value that is a choice, a cycle or a column of a record; null for other
  /// values.
  static const spec::Draw* ChoiceOf(const spec::Value& value);
  /// Chooses an option, and replaces `path` by the stream of the option. Returns null if the choice
  /// fails.
  const spec::Value* Choose(const spec::Draw& draw, diag::SourceMark mark, StreamId& path);
  /// Returns the option of a column of a record that belongs to the drawn key of the record.
  const spec::Value* ChooseRow(const spec::Draw& draw, diag::SourceMark mark, StreamId& path);
  std::optional<std::size_t> DrawOption(const spec::Draw& draw, diag::SourceMark mark,
                                        StreamId path);
  /// Returns the weights of a choice; an empty list if all options have the same weight.
  std::optional<Numbers> Weights(const spec::Draw& draw, diag::SourceMark mark, StreamId path);
  void AppendRotationAbout(const spec::RotationAbout& about, diag::SourceMark mark, StreamId path,
                           Numbers& out);
  void AppendPointOnSphere(const spec::PointOnSphere& point, diag::SourceMark mark, StreamId path,
                           Numbers& out);
  void AppendColor(const spec::HsvColor& color, diag::SourceMark mark, StreamId path, Numbers& out);

  const spec::ObjectSpec& spec_;
  DrawKey key_;
  StreamId root_;
  diag::Findings* findings_;
  const Sampler* sampler_;
  std::vector<double> variables_;      // values of variables by slot; kFailedNumber if failed
  std::vector<std::string> texts_;     // texts by slot; empty for numbers
  std::vector<expr::Sequence> lists_;  // indexed by list number
  // Texts of each list in `lists_`; empty for lists of numbers or booleans.
  std::vector<std::vector<std::string>> list_texts_;
  std::vector<Evaluator> shared_;  // evaluators of spec_.shared, the imported files
  bool failed_ = false;
};

/// Number of rejected draws after which the requirements are reported as impossible.
inline constexpr std::uint64_t kMaxAttempts = 1000;

/// Returns an evaluator with drawn parameters; nullopt, after adding a finding, if
/// Evaluator::Sample() fails.
std::optional<Evaluator> Sample(const spec::ObjectSpec& spec, DrawKey key, StreamId root,
                                Evaluator::Overrides overrides, diag::Findings& findings,
                                const Sampler* sampler = nullptr);

}  // namespace mjforge::sample
