// Access to the page of `mjforge customize`: a secret token, and rejection of requests from other
// pages.

#pragma once

#include <string>
#include <string_view>

namespace mjforge::customize {

/// Returns 32 hexadecimal digits from the system's source of random numbers.
std::string MakeToken();

/// Parts of a request that decide whether it is allowed. Headers that the request lacks are empty.
struct Caller {
  std::string_view path;  // "/TOKEN/page.js"
  std::string_view host;
  std::string_view origin;
  std::string_view fetch_site;  // Sec-Fetch-Site
  std::string_view proxy_path;  // X-ProxyContextPath, which only Jupyter's proxy sets
};

/// Returns the reason for which a request is rejected; empty if the request is allowed. The path
/// must begin with the token. The host must be this machine, at any port because of SSH tunnels,
/// unless Jupyter's proxy passed the request on. The origin, if there is one, must be the same
/// host.
std::string_view Refusal(const Caller& caller, std::string_view token);

}  // namespace mjforge::customize
