#include "mjforge/tape/tape.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

namespace mjforge::tape {
namespace {

/// A tape with one number that changes from run to run.
struct Drawn {
  Tape tape;
  double source = 2;
  Traced<double> number{2, tape, source};

  bool Run(double other) {
    source = other;
    return tape.Run();
  }
};

TEST_CASE("what is computed from a number on a tape follows it") {
  Drawn drawn;
  const Traced<double> result = (drawn.number + 1) * 3 / (drawn.number - 1);
  CHECK(result.value() == 9);
  CHECK(drawn.Run(3));
  CHECK(*result.at() == 6);
}

TEST_CASE("what is computed from plain numbers is plain") {
  Drawn drawn;
  const Traced<double> result = Apply([](double a, double b) { return a * b; }, 2.0, 3.0);
  CHECK(result.value() == 6);
  CHECK(result.tape() == nullptr);
  CHECK(drawn.tape.size() == 0);
}

TEST_CASE("a step may be noted that takes nothing from the tape") {
  Tape tape;
  int runs = 0;
  const Traced<double> count = Note(&tape, [&runs] { return static_cast<double>(++runs); });
  CHECK(count.value() == 1);
  CHECK(tape.Run());
  CHECK(tape.Run());
  CHECK(*count.at() == 3);
}

TEST_CASE("a variant with another answer goes another way") {
  Drawn drawn;
  CHECK(drawn.number > 1);
  CHECK_FALSE(drawn.number == 7);
  CHECK(drawn.Run(3));
  CHECK_FALSE(drawn.Run(0.5));  // not > 1
  CHECK_FALSE(drawn.Run(7));    // == 7
  CHECK_FALSE(drawn.Run(std::nan("")));
  CHECK(drawn.Run(1.5));
}

TEST_CASE("a fixed number is the same in all variants of a tape") {
  Drawn drawn;
  CHECK(Fixed(drawn.number) == 2);
  CHECK(drawn.Run(2));
  CHECK_FALSE(drawn.Run(2.5));
}

TEST_CASE("early steps are taken before the others") {
  Tape tape;
  std::vector<int> order;
  const auto note = [&order](int number) {
    return [&order, number] {
      order.push_back(number);
      return true;
    };
  };
  tape.Add(note(2));
  tape.AddEarly(note(1));
  CHECK(tape.Run());
  CHECK(order == std::vector{1, 2});
  CHECK(tape.size() == 2);
}

TEST_CASE("numbers are gathered into vectors, and known again as what they were") {
  Drawn drawn;
  const std::array<Traced<double>, 3> numbers = {1.0, drawn.number, drawn.number * 2};
  const Traced<Eigen::Vector3d> vector = Gather<Eigen::Vector3d>(numbers);
  CHECK(vector == Eigen::Vector3d(1, 2, 4));
  CHECK(Element(vector, 0).at() == nullptr);
  CHECK(Element(vector, 1).at() == &drawn.source);
  const auto again = Gather<Eigen::Vector2d>(std::array{Element(vector, 1), Element(vector, 0)});
  CHECK(Element(again, 0).at() == &drawn.source);
  CHECK(drawn.Run(5));
  CHECK(*vector.at() == Eigen::Vector3d(1, 5, 10));
  CHECK(*again.at() == Eigen::Vector2d(5, 1));
}

struct Pair {
  Eigen::Vector3d sum;
  double first = 0;
};

TEST_CASE("a step may leave a struct, whose members are on the tape") {
  Drawn drawn;
  const auto pair = Apply([](double x) { return Pair{Eigen::Vector3d(x, x, x), x}; }, drawn.number);
  const Traced<double> first = Member(pair, &Pair::first);
  const Traced<Eigen::Vector3d> sum = Member(pair, &Pair::sum);
  CHECK(drawn.Run(4));
  CHECK(*first.at() == 4);
  CHECK(*Element(sum, 2).at() == 4);
  CHECK(Member(Traced<Pair>(Pair()), &Pair::first).tape() == nullptr);
}

}  // namespace
}  // namespace mjforge::tape
