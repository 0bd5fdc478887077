#include "mjforge/engine/captured_stderr.h"

#include <cstdio>
#include <thread>

#include <catch2/catch.hpp>

#include "harness/standard_error.h"

namespace mjforge::engine {
namespace {

using Messages = std::vector<std::string>;

TEST_CASE("Qhull's messages are captured without their details") {
  Messages messages;
  const std::string printed = harness::StandardErrorOf([&] {
    const CapturedStderr captured;
    std::fprintf(stderr, "QH7089 qhull precision warning: narrow.  Is %s flat?\n", "it");
    std::fputs("\nOptions:\n  run-id 1\nQH6000 no colon\nQH6154 Qhull error: flat", stderr);
    messages = captured.QhullMessages();
  });
  CHECK(printed.empty());
  CHECK(messages == Messages{"narrow.  Is it flat?", "QH6000 no colon", "flat"});
}

TEST_CASE("after the capture text is printed as before") {
  CHECK(harness::StandardErrorOf([] {
          { const CapturedStderr captured; }
          std::fputs("seen", stderr);
        }) == "seen");
}

TEST_CASE("each thread captures its own text, and the newest capture that of other threads") {
  Messages inner;
  Messages outer;
  const std::string printed = harness::StandardErrorOf([&] {
    const CapturedStderr captured;
    std::thread([&] {
      const CapturedStderr newest;
      std::fputs("QH6001 x: inner\n", stderr);
      std::thread([] { std::fputs("QH6002 x: helper\n", stderr); }).join();
      inner = newest.QhullMessages();
    }).join();
    std::fputs("QH6003 x: outer\n", stderr);
    outer = captured.QhullMessages();
  });
  CHECK(printed.empty());
  CHECK(inner == Messages{"inner", "helper"});
  CHECK(outer == Messages{"outer"});
}

}  // namespace
}  // namespace mjforge::engine
