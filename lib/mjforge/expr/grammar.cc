#include "mjforge/expr/grammar.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "mjforge/expr/complaints.h"
#include "mjforge/expr/measures.h"
#include "mjforge/expr/operands.h"
#include "mjforge/expr/units.h"
#include "mjforge/expr/words.h"

namespace mjforge::expr {
namespace {

using diag::Code;

// Far above what anybody writes, and far below what would exhaust the stack.
constexpr std::size_t kMaxBytes = 10'000;
constexpr int kMaxDepth = 200;
// Functions that call others with different arguments each time would make 2^n steps.
constexpr int kMaxCalls = 1000;

// Recursive descent, loosest operator first; one function a level:
//   choice:     any ? choice : choice
//   any:        all (or all)*
//   all:        negation (and negation)*
//   negation:   not negation | comparison
//   comparison: sum (< <= > >= == != sum)?
//   sum, term:  left to right
//   signed:     - signed | + signed | ! signed | power
//   power:      primary (^ signed)?
// Each adds its steps to the program on the way. A call of a spec's function reads the function's
// body, with what its arguments are.
class Grammar : Operands {
 public:
  Grammar(std::string_view text, std::vector<Word> words, Parts& parts, Arguments arguments = {})
      : Operands(text, std::move(words), parts, std::move(arguments)), parts_(parts) {}

  Result Run(Expression::Result wanted = Expression::Result::kNoText) {
    const Result result = Choice();
    if (!result) return result;
    if (Now().kind != Word::Kind::kEnd) return Fail(Unexpected(words_, at_, names_));
    if (result->type == Type::kText && wanted == Expression::Result::kNoText)
      return FailText(*result);
    return result;
  }

 private:
  // Counts the nesting while a function runs.
  class Level {
   public:
    explicit Level(Grammar& grammar) : depth_(grammar.parts_.depth) { ++depth_; }
    ~Level() { --depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    bool too_deep() const { return depth_ > kMaxDepth; }

   private:
    int& depth_;
  };

  Result FailDepth() { return Fail(TooDeep(Now(), kMaxDepth)); }

  Result Choice() {
    const Level level(*this);
    if (level.too_deep()) return FailDepth();
    Result condition = Any();
    if (!condition || !Now().IsSign("?")) return condition;
    if (condition->type == Type::kText) return FailText(*condition);
    const std::size_t question = Now().offset;
    ++at_;
    const std::size_t first = at_;
    const Result yes = Choice();
    if (!yes) return yes;
    const std::size_t colon = at_;
    if (!Take(":")) {
      if (Now().kind != Word::Kind::kEnd) return Fail(Unexpected(words_, at_, names_));
      return Fail({Code::kExprSyntax, question, "'?' has no ':'", "write condition ? a : b"});
    }
    const Result no = Choice();
    if (!no) return no;
    if ((yes->type == Type::kText) != (no->type == Type::kText))
      return Fail(TextBeside(words_[yes->type == Type::kText ? yes->word : no->word]));
    const Type type = yes->type == no->type ? yes->type : Type::kNumber;
    const std::array arguments = {Argument{*condition, {}}, Argument{*yes, Source(first, colon)},
                                  Argument{*no, Source(colon + 1, at_)}};
    Result result = Applied(Operator("?"), type, arguments, words_[colon].offset);
    if (result) result->word = yes->word;
    return result;
  }

  using Rule = Result (Grammar::*)();

  // rule (sign rule)*, where all but texts fit; `word` is another way to write the first sign.
  Result Chain(Rule rule, std::initializer_list<std::string_view> signs, Type type,
               std::string_view word = {}) {
    const std::size_t first = at_;
    Result left = (this->*rule)();
    while (left) {
      const auto* sign = std::find_if(signs.begin(), signs.end(),
                                      [this](std::string_view each) { return Now().IsSign(each); });
      if (!word.empty() && Now().IsName(word)) sign = signs.begin();
      if (sign == signs.end()) break;
      if (left->type == Type::kText) return FailText(*left);
      const std::size_t between = at_++;
      const Result right = (this->*rule)();
      if (!right) return right;
      if (right->type == Type::kText) return FailText(*right);
      left = Applied(Operator(*sign), type, *left, *right, {first, between});
    }
    return left;
  }

  // An operator at the word `between` its operands, the first of which begins at `first`.
  struct Place {
    std::size_t first;
    std::size_t between;
  };
  Result Applied(const Callee& callee, Type type, const Typed& left, const Typed& right,
                 Place place) {
    const std::array arguments = {Argument{left, Source(place.first, place.between)},
                                  Argument{right, Source(place.between + 1, at_)}};
    return Applied(callee, type, arguments, words_[place.between].offset);
  }
  using Operands::Applied;

  Result Any() { return Chain(&Grammar::All, {"||"}, Type::kBoolean, "or"); }

  Result All() { return Chain(&Grammar::Negation, {"&&"}, Type::kBoolean, "and"); }

  Result Negation() {
    if (!Now().IsName("not")) return Comparison();
    const Level level(*this);
    if (level.too_deep()) return FailDepth();
    ++at_;
    return Unary("!", &Grammar::Negation, Type::kBoolean);
  }

  // An operator of one operand, already taken, and its operand.
  Result Unary(std::string_view sign, Rule rule, Type type) {
    const Result operand = (this->*rule)();
    if (!operand) return operand;
    if (operand->type == Type::kText) return FailText(*operand);
    return Applied(UnaryOperator(sign), type, std::array{Argument{*operand, {}}}, 0);
  }

  Result Comparison() {
    const std::size_t first = at_;
    const Result left = Sum();
    if (!left || !AtComparison()) return left;
    const std::size_t sign = at_++;
    const bool equality = words_[sign].text == "==" || words_[sign].text == "!=";
    if (left->type == Type::kText && !equality) return FailText(*left);
    beside_text_ = left->type == Type::kText;
    const Result right = Sum();
    beside_text_ = false;
    if (!right) return right;
    if (right->type == Type::kText && !equality) return FailText(*right);
    if ((left->type == Type::kText) != (right->type == Type::kText)) {
      return Fail(TextAgainst(words_[left->type == Type::kText ? left->word : right->word]));
    }
    if (AtComparison()) return FailChained(first, sign);
    return Applied(Operator(words_[sign].text), Type::kBoolean, *left, *right, {first, sign});
  }

  Result FailChained(std::size_t first, std::size_t sign) {
    const std::string_view left = Source(first, at_);
    const std::string_view middle = Source(sign + 1, at_);
    return Fail({Code::kExprSyntax, Now().offset, "comparisons cannot be chained",
                 fmt::format("write {} and {} {} ...", left, middle, Now().text)});
  }

  Result Sum() { return Chain(&Grammar::Term, {"+", "-"}, Type::kNumber); }

  Result Term() { return Chain(&Grammar::Signed, {"*", "/", "%"}, Type::kNumber); }

  Result Signed() {
    if (!Now().IsSign("-") && !Now().IsSign("+") && !Now().IsSign("!")) return Power();
    const Level level(*this);
    if (level.too_deep()) return FailDepth();
    if (Take("-")) return Unary("-", &Grammar::Signed, Type::kNumber);
    if (Take("!")) return Unary("!", &Grammar::Signed, Type::kBoolean);
    ++at_;
    const Result operand = Signed();
    if (!operand) return operand;
    if (operand->type == Type::kText) return FailText(*operand);
    return Typed{.value = operand->value, .word = operand->word, .dimension = operand->dimension};
  }

  Result Power() {
    const std::size_t first = at_;
    const Result base = Primary();
    if (!base || !Now().IsSign("^")) return base;
    if (base->type == Type::kText) return FailText(*base);
    const Level level(*this);
    if (level.too_deep()) return FailDepth();
    const std::size_t sign = at_++;
    const Result exponent = Signed();
    if (!exponent) return exponent;
    if (exponent->type == Type::kText) return FailText(*exponent);
    return Applied(Operator("^"), Type::kNumber, *base, *exponent, {first, sign});
  }

  Result Primary() {
    const Word& word = Now();
    switch (word.kind) {
      case Word::Kind::kNumber:
        return Number();
      case Word::Kind::kText:
        ++at_;
        return Quoted(word);
      case Word::Kind::kName:
        if (word.text == "and" || word.text == "or" || word.text == "not") break;
        return Name();
      case Word::Kind::kSign:
        if (word.text == "(") return Group();
        break;
      case Word::Kind::kEnd:
        break;
    }
    return Fail(MissingValue(words_, at_));
  }

  Result Number() {
    const Word& word = Now();
    if (word.unit.empty()) {
      ++at_;
      return Literal(word.number, Type::kNumber, OfPlainNumber(word.number));
    }
    const std::optional<KnownUnit> unit = FindKnownUnit(word.unit);
    if (!unit) return Fail(UnknownUnit(word, names_));
    ++at_;
    return Literal(word.number * unit->numerator / unit->denominator, Type::kNumber,
                   unit->dimension);
  }

  Result Group() {
    const std::size_t open = Now().offset;
    ++at_;
    const Result inner = Choice();
    if (!inner) return inner;
    if (!Take(")")) return FailOpen(open, "'(' is not closed");
    return inner;
  }

  Result FailOpen(std::size_t open, std::string_view message) {
    if (Now().kind != Word::Kind::kEnd) return Fail(Unexpected(words_, at_, names_));
    return Fail({Code::kExprSyntax, open, std::string(message), {}});
  }

  Result Name() {
    const Word& word = Now();
    if (words_[at_ + 1].IsSign("(")) {
      if (const Callee* callee = FindCallee(word.text)) return Call(*callee);
      if (const Formula* formula = names_.FindFormula(word.text)) return Call(*formula);
      const ListCallee* list_callee = FindListCallee(word.text);
      return list_callee ? ListCall(*list_callee) : Fail(NotAFunction(word, names_));
    }
    if (IsListAt(at_) && words_[at_ + 1].IsSign("[")) return Element();
    ++at_;
    return Named(word, beside_text_);
  }

  // list[index]
  Result Element() {
    const Word& name = Now();
    const std::size_t open = words_[++at_].offset;
    const std::size_t first = ++at_;
    const Level level(*this);
    if (level.too_deep()) return FailDepth();
    const Result index = Choice();
    if (!index) return index;
    if (index->type == Type::kText) return FailText(*index);
    const std::size_t end = at_;
    if (!Take("]")) return FailOpen(open, "'[' is not closed");
    return ElementOf(name, {*index, Source(first, end)});
  }

  // sum(list), sum(list, n), len(list)
  Result ListCall(const ListCallee& callee) {
    const Word& function = Now();
    const std::size_t open = words_[at_ + 1].offset;
    at_ += 2;
    const std::size_t list = at_;
    if (!IsListAt(at_)) return Fail(NotAList(Now(), UsageOf(function.text)));
    ++at_;
    std::optional<Argument> count;
    if (callee.name == "sum" && Take(",")) {
      const std::size_t first = at_;
      const Result read = Choice();
      if (!read) return read;
      if (read->type == Type::kText) return FailText(*read);
      count = {*read, Source(first, at_)};
    }
    if (Now().IsSign(",")) return Fail(WrongCount(function, 1, 2, UsageOf(function.text)));
    if (!Take(")")) return FailOpen(open, "'(' is not closed");
    return OfList(callee, list, count ? &*count : nullptr);
  }

  // What is in the parentheses of a call, read to its end; a list is what `of_list`, if any, gives.
  // False after an error.
  bool ReadArguments(const ListCallee* of_list, std::vector<Argument>& arguments) {
    const std::size_t open = words_[at_ + 1].offset;
    at_ += 2;
    if (!Now().IsSign(")")) {
      do {
        const std::size_t first = at_;
        const bool is_list = of_list != nullptr && IsListAt(at_) &&
                             (words_[at_ + 1].IsSign(",") || words_[at_ + 1].IsSign(")"));
        const Result argument = is_list ? OfList(*of_list, at_++, nullptr) : Choice();
        if (!argument) return false;
        if (argument->type == Type::kText) return FailText(*argument).has_value();
        arguments.push_back({*argument, Source(first, at_)});
      } while (Take(","));
    }
    return Take(")") || FailOpen(open, "'(' is not closed").has_value();
  }

  Result Call(const Callee& callee) {
    const Word& name = Now();
    std::vector<Argument> arguments;
    if (!ReadArguments(FindListCallee(callee.name), arguments)) return std::nullopt;
    const int arity = callee.arity();
    const int count = static_cast<int>(arguments.size());
    if (arity == 0 ? count == 0 : count != arity) {
      return Fail(WrongCount(name, arity, count, UsageOf(name.text)));
    }
    return Applied(callee, Type::kNumber, arguments, name.offset);
  }

  Result Call(const Formula& formula) {
    const Word& name = Now();
    std::vector<Argument> read;
    if (!ReadArguments(nullptr, read)) return std::nullopt;
    const auto arity = static_cast<int>(formula.arguments.size());
    if (const auto count = static_cast<int>(read.size()); count != arity)
      return Fail(WrongCount(name, arity, count, formula.Usage()));
    parsed_.formulas.insert(formula.name);
    Parts::Call call = {&formula, {}};
    Arguments arguments;
    for (std::size_t i = 0; i < read.size(); ++i) {
      const auto& [operand, type, word, dimension] = read[i].read;
      call.second.emplace_back(operand.step, std::bit_cast<std::uint64_t>(operand.constant), type,
                               dimension);
      arguments.emplace(formula.arguments[i], read[i].read);
    }
    const auto known = parts_.made.find(call);
    if (known != parts_.made.end()) return known->second;
    const Level level(*this);
    if (level.too_deep()) return Fail(TooDeep(name, kMaxDepth));
    ++parts_.calls;
    const Result result =
        parts_.calls > kMaxCalls ? std::nullopt : Inline(formula, std::move(arguments));
    // Of all the calls, the one in the expression itself is shown.
    if (parts_.calls > kMaxCalls) return Fail(TooManyCalls(name, kMaxCalls));
    if (result) parts_.made.emplace(std::move(call), *result);
    return result;
  }

  Result Inline(const Formula& formula, Arguments arguments) {
    std::vector<Word> words;
    Result result;
    if (SplitWords(formula.body, words, error_))
      result = Grammar(formula.body, std::move(words), parts_, std::move(arguments)).Run();
    if (!result && error_.formula.empty()) error_.formula = formula.name;
    return result;
  }

  Parts& parts_;
  bool beside_text_ = false;  // the other side of a comparison, already read, is text
};

}  // namespace

bool Parse(std::string_view text, const Names& names, Expression::Result wanted, Parsed& parsed,
           Error& error) {
  if (text.size() > kMaxBytes) {
    error = TooLong(text.size(), kMaxBytes);
    return false;
  }
  std::vector<Word> words;
  if (!SplitWords(text, words, error)) return false;
  Parts parts{.names = names, .parsed = parsed, .error = error};
  const auto result = Grammar(text, std::move(words), parts).Run(wanted);
  if (!result) return false;
  parsed.type = result->type;
  parsed.dimension = result->dimension;
  parsed.program.SetResult(result->value);
  return true;
}

}  // namespace mjforge::expr
