// Access control of the page of `mjforge customize`: a secret token, and rejection of requests from
// other pages and machines.

#pragma once

#include <string>
#include <string_view>

namespace mjforge::customize {

/// Returns a secret token: 32 hexadecimal digits from the system's source of random numbers.
std::string MakeToken();

/// Parts of a request that decide whether it is allowed. Headers that the request lacks are empty.
struct Caller {
  std::string_view path;  // "/TOKEN/page.js"
  std::string_view host;
  std::string_view origin;
  std::string_view fetch_site;  // Sec-Fetch-Site
  std::string_view proxy_path;  // X-ProxyContextPath, which only Jupyter's proxy sets
};

/// Returns the reason why a request is rejected; an empty text if the request is allowed. The first
/// folder of the path must be the token. The header Host must name this machine, at any port
/// because of SSH tunnels, unless Jupyter's proxy passed the request on. The header Origin, if
/// present, must name the same host and port as Host. Sec-Fetch-Site, if present, must be
/// `same-origin` or `none`.
std::string_view Refusal(const Caller& caller, std::string_view token);

}  // namespace mjforge::customize
