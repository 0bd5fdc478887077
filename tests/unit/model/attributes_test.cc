#include "mjforge/model/attributes.h"

#include <catch2/catch.hpp>

namespace mjforge::model {
namespace {

AttributeNumbers Constant() {
  return AttributeNumbers(std::make_shared<const spec::ConstantValue>(
      spec::ConstantValue{.numbers = {0.5, 2}, .text = "0.5 2"}));
}

TEST_CASE("numbers of a spec have its text until they are changed") {
  AttributeNumbers numbers = Constant();
  const AttributeNumbers copy = numbers;
  CHECK(numbers.text() == "0.5 2");
  CHECK(numbers.size() == 2);
  numbers.Change().front() = 3;
  CHECK(numbers.text().empty());
  CHECK(numbers == AttributeNumbers{3, 2});
  CHECK(copy.text() == "0.5 2");
  CHECK(copy == AttributeNumbers{0.5, 2});
}

TEST_CASE("numbers are equal if their values are") {
  CHECK(Constant() == AttributeNumbers{0.5, 2});
  CHECK_FALSE(Constant() == AttributeNumbers{0.5});
  CHECK(AttributeNumbers().empty());
}

}  // namespace
}  // namespace mjforge::model
