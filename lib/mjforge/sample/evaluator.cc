#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "mjforge/sample/distributions.h"
#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

using diag::Code;
using diag::SourceMark;

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

// Picks one of several values of any kind rather than a number.
bool IsPick(const spec::Draw& draw) {
  return draw.distribution == spec::Distribution::kChoice ||
         draw.distribution == spec::Distribution::kCycle;
}

// "[0.01, 0.02, 0.03, ...]"
std::string ListText(const std::vector<double>& numbers) {
  constexpr std::size_t kShown = 8;
  std::string text = "[";
  for (std::size_t i = 0; i < std::min(numbers.size(), kShown); ++i) {
    if (i > 0) text += ", ";
    expr::AppendNumber(text, numbers[i]);
  }
  return text + (numbers.size() > kShown ? ", ...]" : "]");
}

// False for a failed number.
bool Truth(double number) { return std::abs(number) > 0; }

}  // namespace

double Evaluator::Fail(Code code, SourceMark mark, std::string message, std::string hint) {
  diag::Finding& finding = findings_->Add(code, mark, std::move(message), std::move(hint));
  finding.seed = key_.seed;
  finding.index = key_.index;
  failed_ = true;
  return kNoNumber;
}

std::string Evaluator::InputsText(const expr::Expression& expression) const {
  std::string text;
  for (const expr::Expression::Input& input : expression.inputs()) {
    if (input.type == expr::Type::kText) continue;
    if (!text.empty()) text += ", ";
    const double value = variables_[static_cast<std::size_t>(input.slot)];
    text += input.name + " = ";
    if (input.list >= 0) {
      text += ListText(lists_[static_cast<std::size_t>(input.list)].numbers());
    } else if (input.type == expr::Type::kBoolean) {
      text += value != 0 ? "true" : "false";
    } else {
      expr::AppendNumber(text, value);
    }
  }
  return text;
}

double Evaluator::EvaluateExpression(const expr::Expression& expression, SourceMark mark) {
  const double result = expression.Evaluate(variables_, lists_);
  if (std::isfinite(result)) return result;
  for (const expr::Expression::Input& input : expression.inputs()) {
    if (!std::isnan(variables_[static_cast<std::size_t>(input.slot)])) continue;
    // The failure of the input is the cause; it has its finding already, unless
    // it never got a value: a property of a body that `if` left out.
    if (failed_) return kNoNumber;
    return Fail(Code::kExprNotFinite, mark,
                fmt::format("expression '{}' uses '{}', which has no value in this variant",
                            expression.text(), input.name),
                "its body was left out by 'if'");
  }
  const std::string inputs = InputsText(expression);
  if (std::string missing = expression.DescribeMissingItem(variables_, lists_); !missing.empty())
    return Fail(Code::kExprOutOfRange, mark, std::move(missing),
                inputs.empty() ? "" : "here " + inputs);
  return Fail(Code::kExprNotFinite, mark,
              fmt::format("expression '{}' is {}{}{}", expression.text(),
                          std::isnan(result) ? "not a number" : "infinite",
                          inputs.empty() ? "" : ": ", inputs));
}

double Evaluator::Variable(int slot) const { return variables_[static_cast<std::size_t>(slot)]; }

void Evaluator::SetVariable(int slot, double value) {
  variables_[static_cast<std::size_t>(slot)] = value;
}

void Evaluator::SetVariable(int slot, std::string_view text) {
  texts_[static_cast<std::size_t>(slot)] = text;
  SetVariable(slot, expr::TextKey(text));
}

void Evaluator::SetVariable(int slot, const Evaluator& other, std::size_t i) {
  const spec::Parameter& parameter = other.spec_.parameters[i];
  const auto first = static_cast<std::size_t>(slot);
  texts_[first] = other.texts_[static_cast<std::size_t>(parameter.slot)];
  for (int k = 0; k < std::max(parameter.value.components, 1); ++k) {
    SetVariable(slot + k, other.Variable(parameter.slot + k));
  }
}

StreamId Evaluator::ItemStream(const spec::Value& item, StreamId path, std::size_t i) {
  return std::holds_alternative<spec::Draw>(item.form) ? Child(path, i) : path;
}

double Evaluator::Number(const spec::Value& value, StreamId path) {
  if (const auto* number = std::get_if<double>(&value.form)) return *number;
  if (const auto* expression = std::get_if<expr::Expression>(&value.form)) {
    return EvaluateExpression(*expression, value.mark);
  }
  if (const auto* variable = std::get_if<spec::VariableReference>(&value.form)) {
    return Variable(variable->slot);
  }
  if (const auto* boolean = std::get_if<bool>(&value.form)) return *boolean ? 1 : 0;
  if (const auto* draw = std::get_if<spec::Draw>(&value.form)) {
    if (!IsPick(*draw)) return DrawNumber(*draw, value.mark, path);
    const spec::Value& chosen = Chosen(*draw, value.mark, path);
    return Number(chosen, path);
  }
  return Fail(Code::kSampleBadArgument, value.mark, "this value is not a number");
}

bool Evaluator::Boolean(const spec::Value& value, StreamId path) {
  return Truth(Number(value, path));
}

bool Evaluator::Condition(const expr::Expression& expression, SourceMark mark) {
  return Truth(EvaluateExpression(expression, mark));
}

void Evaluator::AppendPiece(const spec::TextPiece& piece, SourceMark mark, std::string& out) {
  out += piece.literal;
  if (piece.text_slot >= 0) out += texts_[static_cast<std::size_t>(piece.text_slot)];
  if (!piece.expression) return;
  const double result = EvaluateExpression(*piece.expression, mark);
  if (piece.expression->type() == expr::Type::kText) {
    out += TextOf(*piece.expression, result);
  } else if (piece.expression->type() == expr::Type::kBoolean) {
    out += result != 0 ? "true" : "false";
  } else if (std::isfinite(result)) {
    expr::AppendNumber(out, result);
  }
}

const std::string& Evaluator::TextOf(const expr::Expression& expression, double key) const {
  for (const std::string& text : expression.texts()) {
    if (expr::TextKey(text) == key) return text;
  }
  static const std::string kNone;
  for (const expr::Expression::Input& input : expression.inputs()) {
    const auto slot = static_cast<std::size_t>(input.slot);
    if (input.type != expr::Type::kText) continue;
    if (input.list < 0 && variables_[slot] == key) return texts_[slot];
    if (input.list < 0) continue;
    const auto& texts = list_texts_[static_cast<std::size_t>(input.list)];
    const auto same = std::ranges::find(texts, key, expr::TextKey);
    if (same != texts.end()) return *same;
  }
  return kNone;  // of a body that is not there; reported
}

std::string Evaluator::Text(const spec::Value& value, StreamId path) {
  if (const auto* text = std::get_if<spec::Text>(&value.form)) {
    std::string out;
    for (const spec::TextPiece& piece : text->pieces) AppendPiece(piece, value.mark, out);
    return out;
  }
  if (const auto* draw = std::get_if<spec::Draw>(&value.form); draw && IsPick(*draw)) {
    const spec::Value& chosen = Chosen(*draw, value.mark, path);
    return Text(chosen, path);
  }
  if (const auto* variable = std::get_if<spec::VariableReference>(&value.form);
      variable && value.type == expr::Type::kText) {
    return texts_[static_cast<std::size_t>(variable->slot)];
  }
  const double number = Number(value, path);
  if (value.type == expr::Type::kBoolean) return number != 0 ? "true" : "false";
  return std::isfinite(number) ? expr::NumberText(number) : std::string();
}

void Evaluator::Vector(const spec::Value& value, StreamId path, Numbers& out) {
  out.clear();
  AppendVector(value, path, out);
}

void Evaluator::AppendVector(const spec::Value& value, StreamId path, Numbers& out) {
  if (const auto* list = std::get_if<spec::List>(&value.form)) {
    for (std::size_t i = 0; i < list->items.size(); ++i) {
      out.push_back(Number(list->items[i], ItemStream(list->items[i], path, i)));
    }
  } else if (const auto* variable = std::get_if<spec::VariableReference>(&value.form)) {
    for (int i = 0; i < value.components; ++i) out.push_back(Variable(variable->slot + i));
  } else if (const auto* draw = std::get_if<spec::Draw>(&value.form); draw && IsPick(*draw)) {
    const spec::Value& chosen = Chosen(*draw, value.mark, path);
    AppendVector(chosen, path, out);
  } else if (std::holds_alternative<spec::RandomRotation>(value.form)) {
    AppendRotation(path, out);
  } else if (const auto* about = std::get_if<spec::RotationAbout>(&value.form)) {
    AppendAbout(*about, value.mark, path, out);
  } else if (const auto* point = std::get_if<spec::PointOnSphere>(&value.form)) {
    AppendOnSphere(*point, value.mark, path, out);
  } else if (const auto* color = std::get_if<spec::HsvColor>(&value.form)) {
    AppendColor(*color, value.mark, path, out);
  } else {
    out.push_back(Number(value, path));
  }
}

}  // namespace mjforge::sample
