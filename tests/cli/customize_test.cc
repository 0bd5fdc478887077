// Tests of `mjforge customize`: who may ask, what is answered, and how it ends.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <fstream>
#include <future>
#include <sstream>
#include <thread>

#include "crate.h"
#include "harness/served_page.h"

namespace mjforge {
namespace {

using harness::HttpAnswer;
using harness::ServedPage;

// Returns the JSON at the start of an answer, after its length.
std::string JsonOf(const HttpAnswer& answer) {
  REQUIRE(answer.body.size() >= 4);
  std::size_t length = 0;
  for (std::size_t i = 4; i-- > 0;)
    length = length << 8 | static_cast<unsigned char>(answer.body[i]);
  REQUIRE(answer.body.size() >= 4 + length);
  return answer.body.substr(4, length);
}

std::string PictureOf(const HttpAnswer& answer) {
  return answer.body.substr(4 + JsonOf(answer).size());
}

bool Contains(std::string_view text, std::string_view part) { return text.find(part) != text.npos; }

// Returns the processes whose parent is `process`.
std::vector<pid_t> ChildrenOf(pid_t process) {
  const std::string name = std::to_string(process);
  std::ifstream file("/proc/" + name + "/task/" + name + "/children");
  std::vector<pid_t> children;
  for (pid_t child = 0; file >> child;) children.push_back(child);
  return children;
}

constexpr const char* kDraw = R"({"action": "draw", "quick": true})";

class CustomizeTest : public CrateTest {
 protected:
  CustomizeTest() : page_(folder().path(), {"crate.yaml"}) {}

  ServedPage page_;
};

TEST_CASE_METHOD(CustomizeTest,
                 "the page and its files are served with a policy that allows no others") {
  const HttpAnswer html = page_.Get("");
  CHECK(html.status == 200);
  CHECK(html.headers.at("content-type") == "text/html; charset=utf-8");
  CHECK(html.headers.at("content-security-policy")
            .starts_with("default-src 'none'; script-src 'self';"));
  CHECK(html.headers.at("cache-control") == "no-store");
  CHECK(html.headers.at("x-content-type-options") == "nosniff");
  CHECK(html.headers.at("referrer-policy") == "no-referrer");
  CHECK_FALSE(Contains(html.body, "http"));  // nothing from elsewhere
  CHECK(page_.Get("page.css").headers.at("content-type") == "text/css; charset=utf-8");
  CHECK(page_.Get("page.js").headers.at("content-type") == "text/javascript; charset=utf-8");
  for (const char* name : {"crate.yaml", "../", "page.html", "%2e%2e/", "etc/passwd", "ask"}) {
    INFO(name);
    CHECK(page_.Get(name).status == 404);
  }
  CHECK(page_.Post("", "{}").status == 404);
  CHECK(page_.Ask("PUT", "/" + page_.token() + "/").status == 405);
}

TEST_CASE_METHOD(CustomizeTest, "a wrong token, host or origin is refused") {
  const std::string path = "/" + page_.token() + "/";
  const std::string port = std::to_string(page_.port());
  CHECK(page_.Ask("GET", "/").status == 403);
  CHECK(page_.Ask("GET", "/page.js").status == 403);
  CHECK(page_.Ask("POST", "/00000000000000000000000000000000/ask", {}, kDraw).body ==
        "mjforge: wrong token\n");
  CHECK(page_.Ask("GET", path, {{"Host", "example.org:" + port}}).body == "mjforge: wrong host\n");
  CHECK(page_.Ask("POST", path + "ask", {{"Origin", "http://example.org"}}, kDraw).body ==
        "mjforge: wrong origin\n");
  CHECK(page_.Ask("POST", path + "ask", {{"Origin", "null"}}, kDraw).status == 403);
  CHECK(page_.Ask("GET", path, {{"Sec-Fetch-Site", "cross-site"}}).status == 403);
  CHECK(page_.Ask("GET", path, {{"Host", "localhost:9999"}}).status == 200);  // an SSH tunnel
  CHECK(page_
            .Ask("GET", path,
                 {{"Host", "hub.example.org"},
                  {"Origin", "https://hub.example.org"},
                  {"X-ProxyContextPath", "/proxy/" + port}})
            .status == 200);
}

TEST_CASE_METHOD(CustomizeTest, "a parameter changes the picture") {
  const HttpAnswer drawn = page_.Post("draw?client=a", kDraw);
  CHECK(drawn.status == 200);
  CHECK(PictureOf(drawn).starts_with("RIFF"));
  const HttpAnswer low = page_.Post(
      "draw?client=a",
      R"({"action": "draw", "quick": true, "settings": [{"name": "height", "value": 0.1}]})");
  CHECK(PictureOf(low).starts_with("RIFF"));
  CHECK(PictureOf(low) != PictureOf(drawn));
  CHECK(Contains(JsonOf(low), R"("height":0.1)"));
}

TEST_CASE_METHOD(CustomizeTest,
                 "the page hears of a file that was saved, with an error or without") {
  CHECK(PictureOf(page_.Post("ask", kDraw)).starts_with("RIFF"));
  folder().Write("crate.yaml", "mjforge: 1\nname: crate\nparts: [{type: bx}]\n");
  CHECK(page_.Get("events?revision=0").body == "{\"revision\":1}");
  const HttpAnswer broken = page_.Post("ask", R"({"action": "draw", "revision": "1"})");
  CHECK(Contains(JsonOf(broken), R"("line":3)"));
  CHECK(Contains(JsonOf(broken), "'bx' is not one of"));
  CHECK(PictureOf(broken).empty());
  folder().Write("crate.yaml", kText);
  CHECK(page_.Get("events?revision=1").body == "{\"revision\":2}");
  CHECK(PictureOf(page_.Post("ask", R"({"action": "draw", "revision": "2"})")).starts_with("RIFF"));
}

TEST_CASE_METHOD(CustomizeTest, "of two requests of a page that wait, the newer one is answered") {
  // Nine full pictures keep the worker busy while the others arrive.
  constexpr const char* kLong =
      R"({"action": "draw", "nine": true, "width": 2048, "height": 2048})";
  auto busy =
      std::async(std::launch::async, [&] { return page_.Post("draw?client=a", kLong).status; });
  std::vector<std::future<int>> waiting;
  for (int i = 0; i < 8; ++i) {
    waiting.push_back(
        std::async(std::launch::async, [&] { return page_.Post("draw?client=b", kDraw).status; }));
  }
  int answered = 0;
  int replaced = 0;
  for (auto& request : waiting) {
    const int status = request.get();
    answered += status == 200 ? 1 : 0;
    replaced += status == 409 ? 1 : 0;
  }
  CHECK(busy.get() == 200);  // another page replaces nothing
  CHECK(answered >= 1);
  CHECK(replaced >= 1);
  CHECK(answered + replaced == 8);
}

TEST_CASE_METHOD(CustomizeTest, "a film delays no picture, and a newer film replaces it") {
  constexpr const char* kFilm =
      R"({"action": "film", "width": 2048, "height": 2048})";  // takes several seconds
  auto film =
      std::async(std::launch::async, [&] { return page_.Post("slow?client=a", kFilm).status; });
  // The worker that makes the film must have begun, so that it is replaced while it works.
  while (ChildrenOf(page_.process()).empty()) std::this_thread::yield();
  CHECK(page_.Post("draw?client=a", kDraw).status == 200);
  CHECK(film.wait_for(std::chrono::seconds(0)) == std::future_status::timeout);
  const HttpAnswer newer =
      page_.Post("slow?client=a", R"({"action": "film", "width": 64, "height": 64})");
  CHECK(PictureOf(newer).starts_with("RIFF"));
  CHECK(film.get() == 409);
}

TEST_CASE_METHOD(CustomizeTest, "programs without the token cannot keep a browser away") {
  const auto connect = [&] {
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(page_.port()));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    REQUIRE(::connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0);
    return socket;
  };
  std::vector<int> sockets;
  for (int i = 0; i < 300; ++i) sockets.push_back(connect());
  CHECK(page_.Get("").status == 200);
  char byte = 0;
  CHECK(::recv(sockets.front(), &byte, 1, 0) == 0);  // the oldest one was closed
  for (const int socket : sockets) ::close(socket);
}

TEST_CASE_METHOD(CustomizeTest, "a request that is too long is refused") {
  CHECK(
      page_.Ask("POST", "/" + page_.token() + "/ask", {{"Content-Length", "99999999999"}}).status ==
      413);
  CHECK(page_.Get("").status == 200);
}

TEST_CASE_METHOD(CustomizeTest, "a worker that was killed is replaced") {
  page_.Post("ask", kDraw);
  const std::vector<pid_t> workers = ChildrenOf(page_.process());
  REQUIRE(workers.size() == 1);
  ::kill(workers.front(), SIGKILL);
  CHECK(JsonOf(page_.Post("ask", kDraw)) ==
        "{\"error\":\"the variant made MuJoCo crash (SIGKILL)\"}");
  CHECK(PictureOf(page_.Post("ask", kDraw)).starts_with("RIFF"));
}

TEST_CASE_METHOD(CustomizeTest, "Ctrl-C and SIGTERM end the program, also while a page waits") {
  page_.Post("ask", kDraw);
  CHECK(page_.Stop(SIGINT) == 0);
  ServedPage other(folder().path(), {"crate.yaml"});
  CHECK(other.token() != page_.token());
  CHECK(other.Stop(SIGTERM) == 0);
}

TEST_CASE_METHOD(CustomizeTest, "a port that is in use is an error") {
  const auto result =
      Run({"customize", "crate.yaml", "--no-open", "--port", std::to_string(page_.port())});
  CHECK(result.status == 3);
  CHECK(result.out.empty());
  CHECK(result.err ==
        "mjforge: error: cannot listen at port " + std::to_string(page_.port()) +
            ": Address already in use\n  hint: without --port a free one is chosen\n");
}

TEST_CASE_METHOD(CrateTest, "a spec with an error is served, and its page shows the error") {
  folder().Write("bad.yaml", "mjforge: 1\nname: bad\nparts: [{type: bx}]\n");
  const ServedPage page(folder().path(), {"bad.yaml"});
  const std::string json = JsonOf(page.Post("ask", R"({"action": "open"})"));
  CHECK(Contains(json, R"("controls":null)"));
  CHECK(Contains(json, "'bx' is not one of"));
}

TEST_CASE_METHOD(CrateTest, "the page hears of an import that was missing") {
  folder().Write("ball.yaml",
                 "mjforge: 1\nname: ball\nimport: [size.yaml]\n"
                 "parts: [{name: ball, type: sphere, size: a}]\n");
  const ServedPage page(folder().path(), {"ball.yaml"});
  CHECK(PictureOf(page.Post("ask", kDraw)).empty());
  folder().Write("size.yaml", "mjforge: 1\nparams: {a: 5cm}\n");
  CHECK(page.Get("events?revision=0").body == "{\"revision\":1}");
  CHECK(PictureOf(page.Post("ask", R"({"action": "draw", "quick": true, "revision": "1"})"))
            .starts_with("RIFF"));
}

TEST_CASE_METHOD(CrateTest, "customize takes the settings and the seed of the command line") {
  const ServedPage page(folder().path(), {"crate.yaml", "--set", "height=15cm", "--seed", "7"});
  const std::string json = JsonOf(page.Post("ask", R"({"action": "open"})"));
  CHECK(Contains(json, R"("settings":[{"name":"height","text":"15cm"}])"));
  CHECK(Contains(json, R"("seed":"7")"));
}

TEST_CASE_METHOD(CrateTest, "customize takes a spec that exists, and no other") {
  CHECK(Run({"customize", "none.yaml", "--no-open"}).status == 3);
  CHECK(Run({"customize", "-", "--no-open"}).status == 2);
  CHECK(Run({"customize", "x.xml", "--no-open"}).err ==
        "mjforge: error: 'x.xml' is not a spec in a file\n"
        "  hint: see 'mjforge customize --help'\n");
  CHECK(Run({"customize", "crate.yaml", "--port", "0"}).status == 2);
  CHECK(Run({"customize", "crate.yaml", "--port", "65536"}).status == 2);
}

}  // namespace
}  // namespace mjforge
