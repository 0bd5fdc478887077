#include "mjforge/tape/traced.h"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace mjforge::tape {
namespace {

TEST_CASE("a traced value reads as the value") {
  const Traced<Eigen::Vector3d> vector = Eigen::Vector3d(1, 2, 3) * 2;
  CHECK(vector.z() == 6);
  CHECK(vector == Eigen::Vector3d(2, 4, 6));
  CHECK(Traced<Eigen::Vector3d>(1, 2.5, 3).norm() == Eigen::Vector3d(1, 2.5, 3).norm());
  const Traced<double> number = 4;
  const double plain = number;
  CHECK(plain == 4);
  CHECK(number.tape() == nullptr);
}

TEST_CASE("what a tape keeps stays where it is") {
  Tape tape;
  const double& first = tape.Keep(1.5);
  const std::string& text = tape.Keep(std::string("kept"));
  const auto list = tape.KeepAll(std::vector{1, 2, 3});
  for (int i = 0; i < 10'000; ++i) tape.Keep(static_cast<double>(i));
  CHECK(first == 1.5);
  CHECK(text == "kept");
  CHECK(std::vector<int>(list.begin(), list.end()) == std::vector{1, 2, 3});
}

TEST_CASE("links give values what the tape has, once they are off it") {
  Tape tape;
  double& source = tape.Keep(1.0);
  Eigen::Vector3d& place = tape.Keep(Eigen::Vector3d(1, 2, 3));
  Traced<double> number(1, tape, source);
  Traced<Eigen::Vector3d> vector(Eigen::Vector3d(1, 2, 3), tape, place);
  Traced<double> plain = 7;
  Links links;
  links.Take(number);
  links.Take(vector);
  links.Take(plain);
  CHECK(number.tape() == nullptr);
  CHECK(vector.at() == nullptr);
  source = 5;
  place = {4, 5, 6};
  links.Update();
  CHECK(static_cast<double>(number) == 5);
  CHECK(vector == Eigen::Vector3d(4, 5, 6));
  CHECK(static_cast<double>(plain) == 7);
}

}  // namespace
}  // namespace mjforge::tape
