#include "mjforge/expr/measures.h"

#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace mjforge::expr {
namespace {

constexpr double kMostCounted = 12;
// What is longer says little in the middle of a message.
constexpr std::size_t kMostShown = 40;
constexpr Dimension kAngle = {0, 0, 0, 1};

bool IsOperator(const Callee& callee) { return !IsNameCharacter(callee.name.front()); }

bool IsShort(std::string_view source) {
  return !source.empty() && source.size() <= kMostShown && source.find('\n') == source.npos;
}

// "'2kg' is in kg". `otherwise`: what to call it where it is too long.
std::string What(const Measured& argument, std::string_view otherwise) {
  return fmt::format(
      "{} is in {}",
      IsShort(argument.source) ? fmt::format("'{}'", argument.source) : std::string(otherwise),
      argument.dimension.Text());
}

class Checker {
 public:
  Checker(const Callee& callee, std::size_t offset, Error& error)
      : callee_(callee), offset_(offset), error_(error) {}

  bool Fits(std::span<const Measured> arguments) {
    switch (callee_.takes) {
      case Takes::kAnything:
        return true;
      case Takes::kSame:
        return AreSame(arguments);
      case Takes::kSameAfterFirst:
        return AreSame(arguments.subspan(1));
      case Takes::kSameAndCount:
        return AreSame(arguments.first(arguments.size() - 1)) &&
               IsCount(arguments.back(),
                       IsOperator(callee_) ? std::string("an exponent")
                                           : fmt::format("the last argument of '{}'", callee_.name),
                       offset_, error_);
      case Takes::kCount:
        return IsCount(arguments.front(), fmt::format("what '{}' takes", callee_.name), offset_,
                       error_);
      case Takes::kAngle:
        return IsAngle(arguments.front());
    }
    return true;
  }

  // Of arguments that fit.
  Dimension common() const { return common_; }

 private:
  bool AreSame(std::span<const Measured> arguments) {
    const Measured* known = &arguments.front();
    common_ = known->dimension;
    for (const Measured& argument : arguments.subspan(1)) {
      const auto both = Common(common_, argument.dimension);
      if (!both) return Differ(*known, argument);
      if (known->dimension.is_plain()) known = &argument;
      common_ = *both;
    }
    return true;
  }

  bool Differ(const Measured& a, const Measured& b) {
    error_ = {diag::Code::kExprUnits, offset_,
              fmt::format("{}, but {}", What(a, "one side"), What(b, "the other")),
              IsOperator(callee_)
                  ? fmt::format("both sides of '{}' must be in one unit",
                                callee_.name == "?" ? ":" : callee_.name)
                  : fmt::format("the arguments of '{}' must be in one unit", callee_.name)};
    return false;
  }

  bool IsAngle(const Measured& argument) {
    if (argument.dimension.is_plain() || argument.dimension == kAngle) return true;
    error_ = {diag::Code::kExprUnits,
              offset_,
              fmt::format("{}, but '{}' takes an angle in rad", What(argument, "what is here"),
                          callee_.name),
              {}};
    return false;
  }

  const Callee& callee_;
  std::size_t offset_;
  Error& error_;
  Dimension common_;
};

Dimension PowerOf(const Measured& base, const Measured& exponent) {
  if (exponent.constant) return Power(base.dimension, *exponent.constant);
  return base.dimension == Dimension::Count() ? base.dimension : Dimension();
}

}  // namespace

std::optional<Dimension> MeasureOf(const Callee& callee, std::span<const Measured> arguments,
                                   std::size_t offset, Error& error) {
  Checker checker(callee, offset, error);
  if (!checker.Fits(arguments)) return std::nullopt;
  switch (callee.gives) {
    case Gives::kSame:
      return checker.common();
    case Gives::kCount:
      return Dimension::Count();
    case Gives::kAngle:
      return kAngle;
    case Gives::kProduct:
      return arguments[0].dimension * arguments[1].dimension;
    case Gives::kQuotient:
      return arguments[0].dimension / arguments[1].dimension;
    case Gives::kPower:
      return PowerOf(arguments[0], arguments[1]);
    case Gives::kRoot:
      return Power(arguments[0].dimension, 0.5);
  }
  return Dimension();
}

bool IsCount(const Measured& argument, std::string_view what, std::size_t offset, Error& error) {
  if (argument.dimension.is_plain()) return true;
  error = {diag::Code::kExprUnits,
           offset,
           fmt::format("{}, but {} is a plain number", What(argument, "what is here"), what),
           {}};
  return false;
}

Dimension OfPlainNumber(double number) {
  const bool is_count = number == 0.5 || (number == std::round(number) && number <= kMostCounted);
  return is_count ? Dimension::Count() : Dimension();
}

}  // namespace mjforge::expr
