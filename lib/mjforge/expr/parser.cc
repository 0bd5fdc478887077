// Recursive-descent parser of expressions.
#include "mjforge/expr/parser.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <utility>

#include "mjforge/expr/dimension_rules.h"
#include "mjforge/expr/error_messages.h"
#include "mjforge/expr/program_builder.h"
#include "mjforge/expr/tokens.h"

namespace mjforge::expr {
namespace {

using diag::Code;

// Maximum size of the text and maximum nesting depth. Within both, the stack cannot overflow.
constexpr std::size_t kMaxBytes = 10'000;
constexpr int kMaxDepth = 200;
// Maximum count of calls of spec functions that are expanded: n functions can make 2^n calls.
constexpr int kMaxCalls = 1000;

// Recursive descent with one function per level of precedence, from the loosest operators:
//   choice:     any ("?" choice ":" choice)?
//   any:        all (or all)*
//   all:        negation (and negation)*
//   negation:   not negation | comparison
//   comparison: sum ((< | <= | > | >= | == | !=) sum)?
//   sum:        term ((+ | -) term)*, with term: signed ((* | / | %) signed)*
//   signed:     - signed | + signed | ! signed | power
//   power:      primary (^ signed)?
// Each function adds its steps to the program. A call of a spec function is expanded: another
// Parser reads the function's body, with the operands of the call as its arguments.
class Parser : ProgramBuilder {
 public:
  Parser(std::string_view text, std::vector<Token> tokens, ParseState& state,
         Arguments arguments = {})
      : ProgramBuilder(text, std::move(tokens), state, std::move(arguments)), state_(state) {}

  OptionalOperand Run(Expression::Result wanted = Expression::Result::kNoText) {
    const OptionalOperand result = Choice();
    if (!result) return result;
    if (Now().kind != Token::Kind::kEnd) return Fail(Unexpected(tokens_, at_, names_));
    if (result->type == Type::kText && wanted == Expression::Result::kNoText)
      return FailText(*result);
    return result;
  }

 private:
  // Counts the nesting depth during the lifetime of the guard.
  class DepthGuard {
   public:
    explicit DepthGuard(Parser& parser) : depth_(parser.state_.depth) { ++depth_; }
    ~DepthGuard() { --depth_; }
    DepthGuard(const DepthGuard&) = delete;
    DepthGuard& operator=(const DepthGuard&) = delete;
    bool is_too_deep() const { return depth_ > kMaxDepth; }

   private:
    int& depth_;
  };

  OptionalOperand FailDepth() { return Fail(TooDeep(Now(), kMaxDepth)); }

  OptionalOperand RejectText(const OptionalOperand& operand) {
    return operand && operand->type == Type::kText ? FailText(*operand) : operand;
  }

  OptionalOperand Choice() {
    const DepthGuard guard(*this);
    if (guard.is_too_deep()) return FailDepth();
    OptionalOperand condition = Any();
    if (!condition || !Now().IsSign("?")) return condition;
    if (condition->type == Type::kText) return FailText(*condition);
    const std::size_t question = Now().offset;
    ++at_;
    const std::size_t first = at_;
    const OptionalOperand yes = Choice();
    if (!yes) return yes;
    const std::size_t colon = at_;
    if (!Take(":")) {
      if (Now().kind != Token::Kind::kEnd) return Fail(Unexpected(tokens_, at_, names_));
      return Fail({Code::kExprSyntax, question, "'?' has no ':'", "write condition ? a : b"});
    }
    const OptionalOperand no = Choice();
    if (!no) return no;
    if ((yes->type == Type::kText) != (no->type == Type::kText))
      return Fail(TextBeside(tokens_[yes->type == Type::kText ? yes->token : no->token]));
    const Type type = yes->type == no->type ? yes->type : Type::kNumber;
    const std::array arguments = {Argument{*condition, {}}, Argument{*yes, Source(first, colon)},
                                  Argument{*no, Source(colon + 1, at_)}};
    OptionalOperand result = AddCall(Operator("?"), type, arguments, tokens_[colon].offset);
    if (result) result->token = yes->token;
    return result;
  }

  using Rule = OptionalOperand (Parser::*)();

  // Parses rule (sign rule)*; operands must not be texts. `keyword` also stands for the first sign.
  OptionalOperand Chain(Rule rule, std::initializer_list<std::string_view> signs, Type type,
                        std::string_view keyword = {}) {
    const std::size_t first = at_;
    OptionalOperand left = (this->*rule)();
    while (left) {
      const auto* sign = std::find_if(signs.begin(), signs.end(),
                                      [this](std::string_view each) { return Now().IsSign(each); });
      if (!keyword.empty() && Now().IsName(keyword)) sign = signs.begin();
      if (sign == signs.end()) break;
      if (left->type == Type::kText) return FailText(*left);
      const std::size_t place = at_++;
      const OptionalOperand right = RejectText((this->*rule)());
      if (!right) return right;
      left = AddBinary(Operator(*sign), type, *left, *right, {first, place});
    }
    return left;
  }

  // Indices of a binary operator's tokens: the first token of its left operand, and its sign.
  struct OperatorPlace {
    std::size_t first;
    std::size_t sign;
  };
  OptionalOperand AddBinary(const Builtin& builtin, Type type, const TypedOperand& left,
                            const TypedOperand& right, OperatorPlace place) {
    const std::array arguments = {Argument{left, Source(place.first, place.sign)},
                                  Argument{right, Source(place.sign + 1, at_)}};
    return AddCall(builtin, type, arguments, tokens_[place.sign].offset);
  }

  OptionalOperand Any() { return Chain(&Parser::All, {"||"}, Type::kBoolean, "or"); }

  OptionalOperand All() { return Chain(&Parser::Negation, {"&&"}, Type::kBoolean, "and"); }

  OptionalOperand Negation() {
    if (!Now().IsName("not")) return Comparison();
    const DepthGuard guard(*this);
    if (guard.is_too_deep()) return FailDepth();
    ++at_;
    return Unary("!", &Parser::Negation, Type::kBoolean);
  }

  // Parses the operand of a unary operator, whose sign was already read, and adds the operator.
  OptionalOperand Unary(std::string_view sign, Rule rule, Type type) {
    const OptionalOperand operand = RejectText((this->*rule)());
    if (!operand) return operand;
    return AddCall(UnaryOperator(sign), type, std::array{Argument{*operand, {}}}, 0);
  }

  OptionalOperand Comparison() {
    const std::size_t first = at_;
    const OptionalOperand left = Sum();
    if (!left || !AtComparison()) return left;
    const std::size_t sign = at_++;
    const bool equality = tokens_[sign].text == "==" || tokens_[sign].text == "!=";
    if (left->type == Type::kText && !equality) return FailText(*left);
    beside_text_ = left->type == Type::kText;
    const OptionalOperand right = Sum();
    beside_text_ = false;
    if (!right) return right;
    if (right->type == Type::kText && !equality) return FailText(*right);
    if ((left->type == Type::kText) != (right->type == Type::kText)) {
      return Fail(TextAgainst(tokens_[left->type == Type::kText ? left->token : right->token]));
    }
    if (AtComparison())
      return Fail(ChainedComparison(Source(first, at_), Source(sign + 1, at_), Now()));
    return AddBinary(Operator(tokens_[sign].text), Type::kBoolean, *left, *right, {first, sign});
  }

  OptionalOperand Sum() { return Chain(&Parser::Term, {"+", "-"}, Type::kNumber); }

  OptionalOperand Term() { return Chain(&Parser::Signed, {"*", "/", "%"}, Type::kNumber); }

  OptionalOperand Signed() {
    if (!Now().IsSign("-") && !Now().IsSign("+") && !Now().IsSign("!")) return Power();
    const DepthGuard guard(*this);
    if (guard.is_too_deep()) return FailDepth();
    if (Take("-")) return Unary("-", &Parser::Signed, Type::kNumber);
    if (Take("!")) return Unary("!", &Parser::Signed, Type::kBoolean);
    ++at_;
    const OptionalOperand operand = RejectText(Signed());
    if (!operand) return operand;
    return TypedOperand{
        .value = operand->value, .token = operand->token, .dimension = operand->dimension};
  }

  OptionalOperand Power() {
    const std::size_t first = at_;
    const OptionalOperand base = Primary();
    if (!base || !Now().IsSign("^")) return base;
    if (base->type == Type::kText) return FailText(*base);
    const DepthGuard guard(*this);
    if (guard.is_too_deep()) return FailDepth();
    const std::size_t sign = at_++;
    const OptionalOperand exponent = RejectText(Signed());
    if (!exponent) return exponent;
    return AddBinary(Operator("^"), Type::kNumber, *base, *exponent, {first, sign});
  }

  OptionalOperand Primary() {
    const Token& token = Now();
    const bool is_operator = token.IsName("and") || token.IsName("or") || token.IsName("not");
    if (token.IsSign("(")) return Group();
    if (token.kind == Token::Kind::kName && !is_operator) return Name();
    if (token.kind != Token::Kind::kNumber && token.kind != Token::Kind::kText)
      return Fail(MissingValue(tokens_, at_));
    ++at_;
    return token.kind == Token::Kind::kNumber ? Number(token) : Quoted(token);
  }

  OptionalOperand Group() {
    const std::size_t open = Now().offset;
    ++at_;
    const OptionalOperand inner = Choice();
    if (!inner) return inner;
    if (!Take(")")) return FailOpen(open, "'(' is not closed");
    return inner;
  }

  OptionalOperand FailOpen(std::size_t open, std::string_view message) {
    if (Now().kind != Token::Kind::kEnd) return Fail(Unexpected(tokens_, at_, names_));
    return Fail({Code::kExprSyntax, open, std::string(message), {}});
  }

  OptionalOperand Name() {
    const Token& token = Now();
    if (tokens_[at_ + 1].IsSign("(")) {
      if (const Builtin* builtin = FindBuiltin(token.text)) return Call(*builtin);
      if (const SpecFunction* function = names_.FindFunction(token.text)) return Call(*function);
      if (token.text == "torque") return NameCall(1);
      if (token.text == "distance") return NameCall(2);
      const ListBuiltin* list_builtin = FindListBuiltin(token.text);
      return list_builtin ? ListBuiltinCall(*list_builtin) : Fail(NotAFunction(token, names_));
    }
    if (IsListAt(at_) && tokens_[at_ + 1].IsSign("[")) return Element();
    ++at_;
    return ResolveName(token, beside_text_);
  }

  // Parses the element of a list: list[index].
  OptionalOperand Element() {
    const Token& name = Now();
    const std::size_t open = tokens_[++at_].offset;
    const std::size_t first = ++at_;
    const DepthGuard guard(*this);
    if (guard.is_too_deep()) return FailDepth();
    const OptionalOperand index = RejectText(Choice());
    if (!index) return index;
    const std::size_t end = at_;
    if (!Take("]")) return FailOpen(open, "'[' is not closed");
    return AddElement(name, {*index, Source(first, end)});
  }

  // Parses a call of a list function: sum(list), sum(list, n), len(list).
  OptionalOperand ListBuiltinCall(const ListBuiltin& builtin) {
    const Token& function = Now();
    const std::size_t open = tokens_[at_ + 1].offset;
    at_ += 2;
    const std::size_t list = at_;
    if (!IsListAt(at_)) return Fail(NotAList(Now(), UsageOf(function.text)));
    ++at_;
    std::optional<Argument> count;
    if (builtin.name == "sum" && Take(",")) {
      const std::size_t first = at_;
      const OptionalOperand operand = RejectText(Choice());
      if (!operand) return operand;
      count = {*operand, Source(first, at_)};
    }
    if (Now().IsSign(",")) return Fail(WrongCount(function, 1, 2, UsageOf(function.text)));
    if (!Take(")")) return FailOpen(open, "'(' is not closed");
    return AddListCall(builtin, list, count ? &*count : nullptr);
  }

  // Parses a call of a function whose arguments are names: torque(joint), distance(a, b).
  OptionalOperand NameCall(std::size_t count) {
    const Token& function = Now();
    const std::size_t open = tokens_[at_ + 1].offset;
    at_ += 2;
    std::vector<std::size_t> names;
    do {
      if (Now().kind != Token::Kind::kName) return Fail(NotAName(Now(), UsageOf(function.text)));
      names.push_back(at_++);
    } while (Take(","));
    if (!Take(")")) return FailOpen(open, "'(' is not closed");
    if (names.size() != count) {
      return Fail(WrongCount(function, static_cast<int>(count), static_cast<int>(names.size()),
                             UsageOf(function.text)));
    }
    return count == 1 ? AddTorque(tokens_[names[0]])
                      : AddDistance(tokens_[names[0]], tokens_[names[1]], function.offset);
  }

  // Parses the arguments of a call, up to the closing ")". If `list_builtin` is not null, it is
  // applied to each argument that is a list. Returns false after an error.
  bool ReadArguments(const ListBuiltin* list_builtin, std::vector<Argument>& arguments) {
    const std::size_t open = tokens_[at_ + 1].offset;
    at_ += 2;
    if (!Now().IsSign(")")) {
      do {
        const std::size_t first = at_;
        const bool is_list = list_builtin != nullptr && IsListAt(at_) &&
                             (tokens_[at_ + 1].IsSign(",") || tokens_[at_ + 1].IsSign(")"));
        const OptionalOperand argument =
            is_list ? AddListCall(*list_builtin, at_++, nullptr) : RejectText(Choice());
        if (!argument) return false;
        arguments.push_back({*argument, Source(first, at_)});
      } while (Take(","));
    }
    return Take(")") || FailOpen(open, "'(' is not closed").has_value();
  }

  OptionalOperand Call(const Builtin& builtin) {
    const Token& name = Now();
    std::vector<Argument> arguments;
    if (!ReadArguments(FindListBuiltin(builtin.name), arguments)) return std::nullopt;
    const int arity = builtin.arity();
    const int count = static_cast<int>(arguments.size());
    if (arity == 0 ? count == 0 : count != arity) {
      return Fail(WrongCount(name, arity, count, UsageOf(name.text)));
    }
    return AddCall(builtin, Type::kNumber, arguments, name.offset);
  }

  OptionalOperand Call(const SpecFunction& function) {
    const Token& name = Now();
    std::vector<Argument> operands;
    if (!ReadArguments(nullptr, operands)) return std::nullopt;
    const auto arity = static_cast<int>(function.arguments.size());
    if (const auto count = static_cast<int>(operands.size()); count != arity)
      return Fail(WrongCount(name, arity, count, function.Usage()));
    parsed_.functions.insert(function.name);
    ParseState::Call call = {&function, {}};
    Arguments arguments;
    for (std::size_t i = 0; i < operands.size(); ++i) {
      const auto& [operand, type, token, dimension] = operands[i].operand;
      call.second.emplace_back(operand.step, std::bit_cast<std::uint64_t>(operand.constant), type,
                               dimension);
      arguments.emplace(function.arguments[i], operands[i].operand);
    }
    const auto known = state_.results.find(call);
    if (known != state_.results.end()) return known->second;
    const DepthGuard guard(*this);
    if (guard.is_too_deep()) return Fail(TooDeep(name, kMaxDepth));
    ++state_.calls;
    const OptionalOperand result =
        state_.calls > kMaxCalls ? std::nullopt : Inline(function, std::move(arguments));
    // Each caller replaces the error of a nested call, so that the final error is about the call in
    // the expression's own text.
    if (state_.calls > kMaxCalls) return Fail(TooManyCalls(name, kMaxCalls));
    if (result) state_.results.emplace(std::move(call), *result);
    return result;
  }

  OptionalOperand Inline(const SpecFunction& function, Arguments arguments) {
    std::vector<Token> tokens;
    OptionalOperand result;
    if (Tokenize(function.body, tokens, error_))
      result = Parser(function.body, std::move(tokens), state_, std::move(arguments)).Run();
    if (!result && error_.function.empty()) error_.function = function.name;
    return result;
  }

  ParseState& state_;
  bool beside_text_ = false;  // true while the right operand of a comparison with a text is read
};

}  // namespace

bool Parse(std::string_view text, const SymbolTable& names, Expression::Result wanted,
           ParsedExpression& parsed, Error& error) {
  if (text.size() > kMaxBytes) {
    error = TooLong(text.size(), kMaxBytes);
    return false;
  }
  std::vector<Token> tokens;
  if (!Tokenize(text, tokens, error)) return false;
  ParseState state{.names = names, .parsed = parsed, .error = error};
  const auto result = Parser(text, std::move(tokens), state).Run(wanted);
  if (!result) return false;
  parsed.type = result->type;
  parsed.dimension = result->dimension;
  parsed.program.SetResult(result->value);
  return true;
}

}  // namespace mjforge::expr
