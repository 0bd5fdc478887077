// Functions of Evaluator that evaluate expressions, numbers, texts and vectors.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mjforge/sample/sample.h"

namespace mjforge::sample {
namespace {

using diag::Code;
using diag::SourceMark;

constexpr std::string_view kLeftOutHint = "it was left out by 'if' or 'fewer', or is placed later";

// Returns the first numbers of a list as text: "[0.01, 0.02, 0.03, ...]".
std::string ListText(const std::vector<double>& numbers) {
  constexpr std::size_t kShown = 8;
  const auto shown = std::span(numbers).first(std::min(numbers.size(), kShown));
  return fmt::format("[{}{}]", diag::Joined(shown, ", ", expr::NumberText),
                     numbers.size() > kShown ? ", ..." : "");
}

std::optional<bool> ToBoolean(double number) {
  if (std::isnan(number)) return std::nullopt;
  return number != 0;
}

}  // namespace

double Evaluator::Fail(Code code, SourceMark mark, std::string message, std::string hint) {
  diag::Finding& finding = findings_->Add(code, mark, std::move(message), std::move(hint));
  finding.seed = key_.seed;
  finding.index = key_.index;
  failed_ = true;
  return kFailedNumber;
}

std::string Evaluator::InputsText(const expr::Expression& expression) const {
  std::string text;
  for (const expr::Expression::Input& input : expression.inputs()) {
    if (input.type == expr::Type::kText) continue;
    if (!text.empty()) text += ", ";
    const double value = Variable(input.slot);
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
    if (!std::isnan(Variable(input.slot))) continue;
    // After a failure, a finding already explains the input that has no value. Without a failure,
    // the input is a property of a body that this variant leaves out or places later.
    if (failed_) return kFailedNumber;
    return Fail(Code::kExprNotFinite, mark,
                fmt::format("expression '{}' uses '{}', which has no value in this variant",
                            expression.text(), input.name),
                std::string(kLeftOutHint));
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

std::optional<bool> Evaluator::Condition(const expr::Expression& expression, SourceMark mark) {
  return ToBoolean(EvaluateExpression(expression, mark));
}

double Evaluator::Component(const spec::VariableReference& variable, int i, SourceMark mark) {
  const double component = Variable(variable.slot + i);
  if (!std::isnan(component) || failed_) return component;
  return Fail(Code::kExprNotFinite, mark,
              fmt::format("'{}' has no value in this variant", variable.name),
              std::string(kLeftOutHint));
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
    return Component(*variable, 0, value.mark);
  }
  if (const auto* boolean = std::get_if<bool>(&value.form)) return *boolean ? 1 : 0;
  if (const spec::Draw* choice = ChoiceOf(value)) {
    const spec::Value* chosen = Choose(*choice, value.mark, path);
    return chosen != nullptr ? Number(*chosen, path) : kFailedNumber;
  }
  if (const auto* draw = std::get_if<spec::Draw>(&value.form)) {
    return DrawNumber(*draw, value.mark, path);
  }
  return Fail(Code::kSampleBadArgument, value.mark, "this value is not a number");
}

std::optional<bool> Evaluator::Boolean(const spec::Value& value, StreamId path) {
  return ToBoolean(Number(value, path));
}

bool Evaluator::AppendPiece(const spec::TextPiece& piece, SourceMark mark, std::string& out) {
  out += piece.literal;
  if (piece.variable) {
    out += texts_[static_cast<std::size_t>(piece.variable->slot)];
    return !std::isnan(Component(*piece.variable, 0, mark));
  }
  if (!piece.expression) return true;
  const double result = EvaluateExpression(*piece.expression, mark);
  if (std::isnan(result)) return false;
  if (piece.expression->type() == expr::Type::kText) {
    out += TextOf(*piece.expression, result);
  } else if (piece.expression->type() == expr::Type::kBoolean) {
    out += result != 0 ? "true" : "false";
  } else {
    expr::AppendNumber(out, result);
  }
  return true;
}

const std::string& Evaluator::TextOf(const expr::Expression& expression, double key) const {
  for (const std::string& text : expression.texts()) {
    if (expr::TextKey(text) == key) return text;
  }
  for (const expr::Expression::Input& input : expression.inputs()) {
    if (input.type != expr::Type::kText) continue;
    if (input.list < 0) {
      if (Variable(input.slot) == key) return texts_[static_cast<std::size_t>(input.slot)];
      continue;
    }
    const auto& texts = list_texts_[static_cast<std::size_t>(input.list)];
    const auto same = std::ranges::find(texts, key, expr::TextKey);
    if (same != texts.end()) return *same;
  }
  static const std::string kNone;
  return kNone;
}

std::optional<std::string> Evaluator::Text(const spec::Value& value, StreamId path) {
  if (const auto* text = std::get_if<spec::Text>(&value.form)) {
    std::optional<std::string> out(std::in_place);
    bool is_good = true;
    for (const spec::TextPiece& piece : text->pieces)
      is_good &= AppendPiece(piece, value.mark, *out);
    if (!is_good) out.reset();
    return out;
  }
  if (const spec::Draw* choice = ChoiceOf(value)) {
    const spec::Value* chosen = Choose(*choice, value.mark, path);
    return chosen != nullptr ? Text(*chosen, path) : std::nullopt;
  }
  const double number = Number(value, path);
  if (std::isnan(number)) return std::nullopt;
  if (const auto* variable = std::get_if<spec::VariableReference>(&value.form);
      variable && value.type == expr::Type::kText) {
    return texts_[static_cast<std::size_t>(variable->slot)];
  }
  if (value.type == expr::Type::kBoolean) return number != 0 ? "true" : "false";
  return expr::NumberText(number);
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
    for (int i = 0; i < value.components; ++i) out.push_back(Component(*variable, i, value.mark));
  } else if (const spec::Draw* choice = ChoiceOf(value)) {
    const spec::Value* chosen = Choose(*choice, value.mark, path);
    if (chosen != nullptr) return AppendVector(*chosen, path, out);
    out.insert(out.end(), static_cast<std::size_t>(value.components), kFailedNumber);
  } else if (std::holds_alternative<spec::RandomRotation>(value.form)) {
    AppendRotation(path, out);
  } else if (const auto* about = std::get_if<spec::RotationAbout>(&value.form)) {
    AppendRotationAbout(*about, value.mark, path, out);
  } else if (const auto* point = std::get_if<spec::PointOnSphere>(&value.form)) {
    AppendPointOnSphere(*point, value.mark, path, out);
  } else if (const auto* color = std::get_if<spec::HsvColor>(&value.form)) {
    AppendColor(*color, value.mark, path, out);
  } else {
    out.push_back(Number(value, path));
  }
}

}  // namespace mjforge::sample
