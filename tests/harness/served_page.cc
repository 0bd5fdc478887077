// A program that serves a page at this machine, and a client for it.

#include "harness/served_page.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cctype>
#include <csignal>
#include <sstream>

#include "harness/command.h"

namespace mjforge::harness {

namespace {

// Returns what can be read until the end or, if `line`, until the first end of a line.
std::string ReadFrom(int file, bool line) {
  std::string text;
  char c = 0;
  std::array<char, 65536> block;
  if (line) {
    while (::read(file, &c, 1) == 1 && c != '\n') text += c;
    return text;
  }
  for (;;) {
    const ssize_t size = ::read(file, block.data(), block.size());
    if (size <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(size));
  }
}

// Starts the program with a pipe as its standard output, of which it returns the other end.
int Start(const std::filesystem::path& folder, std::vector<std::string> arguments, pid_t& process) {
  arguments.insert(arguments.begin(), MjforgeProgram().string());
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  std::array<int, 2> ends;
  REQUIRE(::pipe2(ends.data(), O_CLOEXEC) == 0);
  process = ::fork();
  REQUIRE(process >= 0);
  if (process == 0) {
    const int nothing = ::open("/dev/null", O_WRONLY);
    ::dup2(ends[1], STDOUT_FILENO);
    ::dup2(nothing, STDERR_FILENO);
    if (::chdir(folder.c_str()) == 0) ::execv(words[0], words.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  return ends[0];
}

HttpAnswer Parse(const std::string& text) {
  HttpAnswer answer;
  const std::size_t end = text.find("\r\n\r\n");
  REQUIRE(end != std::string::npos);
  answer.body = text.substr(end + 4);
  std::istringstream head(text.substr(0, end));
  std::string line;
  std::getline(head, line);
  answer.status = std::stoi(line.substr(line.find(' ') + 1));
  while (std::getline(head, line)) {
    if (line.ends_with('\r')) line.pop_back();
    const std::size_t colon = line.find(": ");
    std::string name = line.substr(0, colon);
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
    answer.headers[name] = line.substr(colon + 2);
  }
  return answer;
}

}  // namespace

ServedPage::ServedPage(const std::filesystem::path& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "customize");
  arguments.emplace_back("--no-open");
  const int out = Start(folder, std::move(arguments), process_);
  const std::string address = ReadFrom(out, true);
  ::close(out);
  INFO("address: " << address);
  const std::string start = "http://127.0.0.1:";
  REQUIRE(address.starts_with(start));
  REQUIRE(address.ends_with('/'));
  const std::size_t slash = address.find('/', start.size());
  port_ = std::stoi(address.substr(start.size()));
  token_ = address.substr(slash + 1, address.size() - slash - 2);
}

ServedPage::~ServedPage() {
  if (process_ > 0) Stop(SIGKILL);
}

HttpAnswer ServedPage::Ask(std::string_view method, std::string_view path, Headers headers,
                           std::string_view body) const {
  headers.try_emplace("Host", host());
  headers.try_emplace("Content-Length", std::to_string(body.size()));
  std::string text = std::string(method) + " " + std::string(path) + " HTTP/1.1\r\n";
  for (const auto& [name, value] : headers) text += name + ": " + value + "\r\n";
  text += "Connection: close\r\n\r\n";
  text += body;
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port_));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  REQUIRE(::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof(address)) == 0);
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t written = ::send(socket, rest.data(), rest.size(), MSG_NOSIGNAL);
    if (written <= 0) break;
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  const std::string answer = ReadFrom(socket, false);
  ::close(socket);
  return Parse(answer);
}

int ServedPage::Stop(int signal) {
  ::kill(process_, signal);
  int status = 0;
  REQUIRE(::waitpid(process_, &status, 0) == process_);
  process_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace mjforge::harness
