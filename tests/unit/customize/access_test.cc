#include "mjforge/customize/access.h"

#include <catch2/catch.hpp>
#include <set>

namespace mjforge::customize {
namespace {

constexpr std::string_view kToken = "0123456789abcdef0123456789abcdef";

// A request that is allowed.
Caller Allowed() {
  return {"/0123456789abcdef0123456789abcdef/page.js", "127.0.0.1:8000", "", "", ""};
}

TEST_CASE("tokens have 128 bits and differ") {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) {
    const std::string token = MakeToken();
    CHECK(token.size() == 32);
    CHECK(token.find_first_not_of("0123456789abcdef") == std::string::npos);
    tokens.insert(token);
  }
  CHECK(tokens.size() == 100);
}

TEST_CASE("the page's own requests are allowed, at any port of this machine") {
  Caller caller = Allowed();
  CHECK(Refusal(caller, kToken).empty());
  for (const std::string_view host : {"localhost", "localhost:9999", "127.0.0.1", "[::1]:8000"}) {
    INFO(host);
    caller.host = host;
    CHECK(Refusal(caller, kToken).empty());
  }
  caller.origin = "http://[::1]:8000";
  caller.fetch_site = "same-origin";
  CHECK(Refusal(caller, kToken).empty());
}

TEST_CASE("a path without the token is refused") {
  Caller caller = Allowed();
  for (const std::string_view path : {"/", "", "page.js", "/0123456789abcdef0123456789abcdee/",
                                      "/0123456789abcdef0123456789abcdef0/", "/0123456789abcdef/",
                                      "//0123456789abcdef0123456789abcdef/"}) {
    INFO(path);
    caller.path = path;
    CHECK(Refusal(caller, kToken) == "wrong token");
  }
}

TEST_CASE("another host is refused, unless Jupyter's proxy names its path") {
  Caller caller = Allowed();
  for (const std::string_view host :
       {"example.org", "", "127.0.0.1.example.org", "localhost.example.org:80"}) {
    INFO(host);
    caller.host = host;
    CHECK(Refusal(caller, kToken) == "wrong host");
  }
  caller.host = "hub.example.org";
  caller.origin = "https://hub.example.org";
  caller.proxy_path = "/user/ann/proxy/8000";
  CHECK(Refusal(caller, kToken).empty());
}

TEST_CASE("requests of other pages are refused") {
  Caller caller = Allowed();
  for (const std::string_view origin :
       {"http://example.org", "null", "http://127.0.0.1:8001", "http://127.0.0.1"}) {
    INFO(origin);
    caller.origin = origin;
    CHECK(Refusal(caller, kToken) == "wrong origin");
  }
  caller = Allowed();
  for (const std::string_view site : {"cross-site", "same-site"}) {
    caller.fetch_site = site;
    CHECK(Refusal(caller, kToken) == "a request of another page");
  }
}

}  // namespace
}  // namespace mjforge::customize
