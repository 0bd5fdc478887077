// Access control of the page of `mjforge customize`: generation of the token, and checks of the
// path and the headers of a request.

#include "mjforge/customize/access.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <random>

namespace mjforge::customize {
namespace {

// Returns the name of a host without its port: "localhost" for "localhost:8000".
std::string_view WithoutPort(std::string_view host) {
  const std::size_t end = host.starts_with('[') ? host.find(']') + 1 : host.find(':');
  return host.substr(0, end);
}

bool IsThisMachine(std::string_view host) {
  constexpr std::array<std::string_view, 3> kNames = {"127.0.0.1", "localhost", "[::1]"};
  return std::ranges::find(kNames, WithoutPort(host)) != kNames.end();
}

// Compares two texts in a time that does not depend on the position of the first difference,
// because this time would let an attacker guess the token digit by digit.
bool IsEqual(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  int difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= a[i] ^ b[i];
  return difference == 0;
}

std::string_view FirstFolder(std::string_view path) {
  if (!path.starts_with('/')) return {};
  path.remove_prefix(1);
  return path.substr(0, path.find('/'));
}

}  // namespace

std::string MakeToken() {
  std::random_device source;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", source());
  return token;
}

std::string_view Refusal(const Caller& caller, std::string_view token) {
  if (!IsEqual(FirstFolder(caller.path), token)) return "wrong token";
  if (!IsThisMachine(caller.host) && caller.proxy_path.empty()) return "wrong host";
  if (!caller.origin.empty()) {
    const std::size_t scheme = caller.origin.find("://");
    if (scheme == caller.origin.npos || caller.origin.substr(scheme + 3) != caller.host)
      return "wrong origin";
  }
  const bool is_own = caller.fetch_site.empty() || caller.fetch_site == "same-origin" ||
                      caller.fetch_site == "none";
  if (!is_own) return "a request of another page";
  return {};
}

}  // namespace mjforge::customize
