// Tests of lists and vectors in expressions.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "mjforge/expr/expr.h"

namespace mjforge::expr {
namespace {

// i, size = (1, 2, 4), widths = (3, 5, 7), woods = (oak, pine), none = ()
struct ListWorld {
  SymbolTable names;
  std::vector<double> variables;
  std::vector<Sequence> lists;

  ListWorld() {
    names.Declare("i", Type::kNumber);
    names.Declare("size", Type::kNumber, 3);
    variables = {0, 1, 2, 4};
    Add("widths", Type::kNumber, {3, 5, 7});
    Add("woods", Type::kText, {TextKey("oak"), TextKey("pine")});
    Add("none", Type::kNumber, {});
    names.Define({"twice", {"x"}, "2 * x + len(widths)"});
    names.Define({"third", {"x"}, "widths[x - 1] / 3"});
  }

  void Add(const std::string& name, Type type, const std::vector<double>& numbers) {
    names.DeclareList(name, type);
    variables.push_back(static_cast<double>(numbers.size()));
    lists.emplace_back(numbers);
  }

  Expression Compiled(const std::string& text) const {
    Error error;
    const auto expression = Expression::Compile(text, names, error, Expression::Result::kAny);
    INFO(text << ": " << error.message);
    REQUIRE(expression);
    return *expression;
  }
  double Value(const std::string& text) const { return Compiled(text).Evaluate(variables, lists); }
  std::string Missing(const std::string& text) const {
    CHECK(std::isnan(Value(text)));
    return Compiled(text).DescribeMissingItem(variables, lists);
  }
  std::string Complaint(const std::string& text) const {
    Error error;
    CHECK_FALSE(Expression::Compile(text, names, error));
    return std::to_string(error.offset) + ": " + error.message +
           (error.hint.empty() ? "" : " (" + error.hint + ")");
  }
};

TEST_CASE("a list has items, sums, a length, a least and a largest value") {
  ListWorld world;
  CHECK(world.Value("widths[0]") == 3);
  CHECK(world.Value("widths[i + 2] * 2") == 14);
  CHECK(world.Value("widths[widths[0] - 1]") == 7);
  CHECK(world.Value("sum(widths)") == 15);
  CHECK(world.Value("sum(widths, i)") == 0);
  CHECK(world.Value("sum(widths, i + 2)") == 8);
  CHECK(world.Value("len(widths) + len(none)") == 3);
  CHECK(world.Value("min(widths) + max(widths)") == 10);
  CHECK(world.Value("max(widths, 9, none[0] > 0 ? 1 : 2)") != 9);  // what is not a number stays so
  CHECK(world.Value("max(4, widths)") == 7);
  CHECK(world.Value("woods[1] == 'pine'") == 1);
  CHECK(world.Value("woods[1]") == TextKey("pine"));
  world.variables[0] = 1;
  CHECK(world.Value("sum(widths, i) + widths[i] / 2") == 5.5);
  CHECK(world.Value("third(3) + twice(1)") == Approx(7.0 / 3 + 5));
}

TEST_CASE("a vector is a list, too") {
  ListWorld world;
  CHECK(world.Value("size[0] + size[2]") == 5);
  CHECK(world.Value("size[i + 1]") == 2);
  CHECK(world.Value("sum(size) + sum(size, 2)") == 10);
  CHECK(world.Value("len(size)") == 3);
  CHECK(world.Compiled("len(size)").constant() == 3);
  CHECK(world.Value("max(size) - min(size)") == 3);
}

TEST_CASE("an item that is not there is told with both numbers") {
  ListWorld world;
  CHECK(world.Missing("1 + widths[i + 3]") ==
        "there is no widths[3]: 'widths' has 3 values, counted from 0");
  CHECK(world.Missing("widths[0.5]") ==
        "there is no widths[0.5]: 'widths' has 3 values, counted from 0");
  CHECK(world.Missing("widths[-1] > 0 ? 1 : 2") ==
        "there is no widths[-1]: 'widths' has 3 values, counted from 0");
  CHECK(world.Missing("size[i - 1]") ==
        "there is no size[-1]: 'size' has 3 values, counted from 0");
  CHECK(world.Missing("sum(widths, 4)") ==
        "there are no first 4 of 'widths': 'widths' has 3 values");
  CHECK(world.Missing("min(none)") == "'none' has no values, so there is no min of them");
  CHECK(world.Missing("sqrt(-widths[0])").empty());
}

TEST_CASE("what is not chosen need not be there") {
  ListWorld world;
  CHECK(world.Value("i > 0 ? widths[i - 1] : 0") == 0);
  CHECK(world.Value("i > 0 and widths[i - 1] > 1") == 0);
  CHECK(world.Value("i == 0 or widths[i - 1] > 1") == 1);
}

TEST_CASE("what is computed from what is not a number is not one") {
  ListWorld world;
  for (const std::string text :
       {"0 / 0 > 1", "not (0 / 0)", "0 / 0 == 0 / 0", "0 / 0 != 1", "1 and 0 / 0", "0 or 0 / 0",
        "0 / 0 ? 1 : 2", "0 / 0 and 1", "clamp(1, 0 / 0, 2)", "clamp(1, 0, 0 / 0)"}) {
    INFO(text);
    CHECK(std::isnan(world.Value(text)));
  }
}

TEST_CASE("misuse of lists is told at its place") {
  ListWorld world;
  CHECK(world.Complaint("1 + widths") ==
        "4: 'widths' is a list; an expression needs a single value (write widths[i], sum(widths), "
        "len(widths), min(widths) or max(widths))");
  CHECK(world.Complaint("abs(widths)").starts_with("4: 'widths' is a list"));
  CHECK(world.Complaint("twice(widths)").starts_with("6: 'widths' is a list"));
  CHECK(world.Complaint("sum(i)") == "4: 'i' is not the name of a list (write sum(list, n))");
  CHECK(world.Complaint("len(widths, 2)") == "0: 'len' takes 1 argument, not 2 (write len(list))");
  CHECK(world.Complaint("sum(woods)") ==
        "4: 'woods' is text; it can only be compared with == or !=");
  CHECK(world.Complaint("size[3]") ==
        "0: there is no size[3]: 'size' has 3 values, counted from 0");
  CHECK(world.Complaint("widths[1") == "6: '[' is not closed");
  CHECK(world.Complaint("widths[1)") == "8: ')' has no '(' before it");
  CHECK(world.Complaint("i[0]") == "1: only a list or a vector has items");
  CHECK(world.Complaint("widths[woods[0]]") ==
        "7: 'woods' is text; it can only be compared with == or !=");
  CHECK(world.Complaint("[1, 2]") ==
        "0: a value is expected before '[' (an expression gives one value, not a list)");
}

TEST_CASE("equal steps over lists are made once") {
  ListWorld world;
  CHECK(world.Value("widths[i] * widths[i] + sum(widths, i + 1) + sum(widths, i + 1)") == 15);
}

}  // namespace
}  // namespace mjforge::expr
