#include <catch2/catch.hpp>

#include "loading.h"

TEST_CASE("a view has directions in degrees, and positions of joints", "[view]") {
  const Loaded loaded =
      LoadWithBox("view: {azimuth: 90deg, elevation: -pi / 4, pose: {door: 30deg, drawer: 2cm}}\n");
  CHECK(loaded.Report() == Strings{});
  REQUIRE(loaded.spec != nullptr);
  const mjforge::spec::PictureView& view = loaded.spec->view;
  CHECK(view.azimuth == Approx(90));
  CHECK(view.elevation == Approx(-45));
  REQUIRE(view.pose.size() == 2);
  CHECK(view.pose[0].joint == "door");
  CHECK(view.pose[0].value == Approx(0.5235987756));
  CHECK(view.pose[1].joint == "drawer");
  CHECK(view.pose[1].value == 0.02);
  CHECK(view.pose[1].mark.line == 4);
}

TEST_CASE("a view without a direction leaves the camera's", "[view]") {
  const Loaded loaded = LoadWithBox("view: {pose: {door: 0}}\n");
  REQUIRE(loaded.spec != nullptr);
  CHECK_FALSE(loaded.spec->view.azimuth.has_value());
  CHECK_FALSE(loaded.spec->view.elevation.has_value());
}

TEST_CASE("what is wrong in a view is a finding", "[view]") {
  CHECK(ReportWithBox("view: {elevation: 100deg, azimuth: 400deg}\n").size() == 2);
  CHECK(ReportWithBox("view: {elevaton: -10deg}\n").size() == 1);
  CHECK(ReportWithBox("view: front\n").size() == 1);
  CHECK(
      ReportWithBox("params: {a: 10deg .. 20deg}\nview: {azimuth: a}\n") ==
      Strings{"5:8 spec/bad-value: 'azimuth' of a view is not a fixed number (write a number with "
              "its unit: 30deg, 5cm)"});
  CHECK(ReportWithBox("view: {pose: {door: [1, 0, 0, 0]}}\n") ==
        Strings{"4:15 spec/bad-value: 'door' of a view is not a fixed number (write a number with "
                "its unit: 30deg, 5cm)"});
}
