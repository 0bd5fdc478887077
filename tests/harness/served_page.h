// A program that serves a page at this machine, and a client for it.

#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mjforge::harness {

struct HttpAnswer {
  int status = 0;
  std::map<std::string, std::string> headers;  // names in lower case
  std::string body;
};

/// A running mjforge whose first line of output is an address, http://127.0.0.1:PORT/TOKEN/.
class ServedPage {
 public:
  /// Starts the program and waits for the line; fails the test if there is none.
  ServedPage(const std::filesystem::path& folder, std::vector<std::string> arguments);
  /// Kills the program unless it was stopped.
  ~ServedPage();
  ServedPage(const ServedPage&) = delete;
  ServedPage& operator=(const ServedPage&) = delete;

  int port() const { return port_; }
  /// Returns "127.0.0.1:PORT".
  std::string host() const { return "127.0.0.1:" + std::to_string(port_); }
  const std::string& token() const { return token_; }
  ::pid_t process() const { return process_; }

  using Headers = std::map<std::string, std::string>;
  /// Sends a request to a path; the headers replace the default one, Host.
  HttpAnswer Ask(std::string_view method, std::string_view path, Headers headers = {},
                 std::string_view body = {}) const;
  /// Asks below the token.
  HttpAnswer Get(std::string_view name) const {
    return Ask("GET", "/" + token_ + "/" + std::string(name));
  }
  HttpAnswer Post(std::string_view name, std::string_view body) const {
    return Ask("POST", "/" + token_ + "/" + std::string(name), {}, body);
  }
  /// Sends a signal and returns the exit status, 128 + signal if a signal killed the program.
  int Stop(int signal);

 private:
  ::pid_t process_ = 0;
  int port_ = 0;
  std::string token_;
};

}  // namespace mjforge::harness
