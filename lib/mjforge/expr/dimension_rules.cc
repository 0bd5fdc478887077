// Dimensional analysis of functions and operators, and messages about mixed units.
#include "mjforge/expr/dimension_rules.h"

#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

namespace mjforge::expr {
namespace {

constexpr double kMaxCount = 12;        // largest number taken for a count
constexpr std::size_t kMaxQuoted = 40;  // maximum bytes of an operand that a message quotes

bool IsOperator(const Builtin& builtin) { return !IsNameCharacter(builtin.name.front()); }

bool IsShort(std::string_view source) {
  return !source.empty() && source.size() <= kMaxQuoted && source.find('\n') == source.npos;
}

// Returns the text "'2kg' is in kg" about an argument. `otherwise` replaces the quoted argument if
// the argument is too long, contains a line end, or has no source text.
std::string DescribeUnit(const Argument& argument, std::string_view otherwise) {
  return fmt::format(
      "{} is in {}",
      IsShort(argument.source) ? fmt::format("'{}'", argument.source) : std::string(otherwise),
      argument.dimension().Text());
}

class DimensionChecker {
 public:
  DimensionChecker(const Builtin& builtin, std::size_t offset, Error& error)
      : builtin_(builtin), offset_(offset), error_(error) {}

  bool Fits(std::span<const Argument> arguments) {
    switch (builtin_.argument_rule) {
      case ArgumentRule::kAnything:
        return true;
      case ArgumentRule::kSame:
        return AreSame(arguments);
      case ArgumentRule::kSameAfterFirst:
        return AreSame(arguments.subspan(1));
      case ArgumentRule::kSameAndCount:
        return AreSame(arguments.first(arguments.size() - 1)) &&
               CheckCount(arguments.back(),
                          IsOperator(builtin_)
                              ? std::string("an exponent")
                              : fmt::format("the last argument of '{}'", builtin_.name),
                          offset_, error_);
      case ArgumentRule::kCount:
        return CheckCount(arguments.front(), fmt::format("what '{}' takes", builtin_.name), offset_,
                          error_);
      case ArgumentRule::kAngle:
        return IsAngle(arguments.front());
    }
    return true;
  }

  // Returns the common dimension that Fits() found. Valid only for the rules kSame, kSameAndCount
  // and kSameAfterFirst, after Fits() returned true.
  Dimension common() const { return common_; }

 private:
  bool AreSame(std::span<const Argument> arguments) {
    const Argument* known = &arguments.front();
    common_ = known->dimension();
    for (const Argument& argument : arguments.subspan(1)) {
      const auto both = CommonDimension(common_, argument.dimension());
      if (!both) return Differ(*known, argument);
      if (known->dimension().is_plain()) known = &argument;
      common_ = *both;
    }
    return true;
  }

  bool Differ(const Argument& a, const Argument& b) {
    error_ = {diag::Code::kExprUnits, offset_,
              fmt::format("{}, but {}", DescribeUnit(a, "one side"), DescribeUnit(b, "the other")),
              IsOperator(builtin_)
                  ? fmt::format("both sides of '{}' must be in one unit",
                                builtin_.name == "?" ? ":" : builtin_.name)
                  : fmt::format("the arguments of '{}' must be in one unit", builtin_.name)};
    return false;
  }

  bool IsAngle(const Argument& argument) {
    if (argument.dimension().is_plain() || argument.dimension() == Dimension::Angle()) return true;
    error_ = {diag::Code::kExprUnits,
              offset_,
              fmt::format("{}, but '{}' takes an angle in rad",
                          DescribeUnit(argument, "what is here"), builtin_.name),
              {}};
    return false;
  }

  const Builtin& builtin_;
  std::size_t offset_;
  Error& error_;
  Dimension common_;
};

Dimension PowerOf(const Argument& base, const Argument& exponent) {
  const Operand& value = exponent.operand.value;
  if (value.step < 0) return Power(base.dimension(), value.constant);
  return base.dimension() == Dimension::Count() ? base.dimension() : Dimension();
}

}  // namespace

std::optional<Dimension> DeriveDimension(const Builtin& builtin,
                                         std::span<const Argument> arguments, std::size_t offset,
                                         Error& error) {
  DimensionChecker checker(builtin, offset, error);
  if (!checker.Fits(arguments)) return std::nullopt;
  switch (builtin.result_rule) {
    case ResultRule::kSame:
      return checker.common();
    case ResultRule::kCount:
      return Dimension::Count();
    case ResultRule::kAngle:
      return Dimension::Angle();
    case ResultRule::kProduct:
      return arguments[0].dimension() * arguments[1].dimension();
    case ResultRule::kQuotient:
      return arguments[0].dimension() / arguments[1].dimension();
    case ResultRule::kPower:
      return PowerOf(arguments[0], arguments[1]);
    case ResultRule::kRoot:
      return Power(arguments[0].dimension(), 0.5);
  }
  return Dimension();
}

bool CheckCount(const Argument& argument, std::string_view what, std::size_t offset, Error& error) {
  if (argument.dimension().is_plain()) return true;
  error = {
      diag::Code::kExprUnits,
      offset,
      fmt::format("{}, but {} is a plain number", DescribeUnit(argument, "what is here"), what),
      {}};
  return false;
}

Dimension DimensionOfLiteral(double number) {
  const bool is_count = number == 0.5 || (number == std::round(number) && number <= kMaxCount);
  return is_count ? Dimension::Count() : Dimension();
}

}  // namespace mjforge::expr
