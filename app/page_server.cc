// HTTP server of `mjforge customize`: paths, headers, limit of connections, pages that wait.
#include "page_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <boost/asio/ip/address_v4.hpp>
#include <cstring>
#include <utility>

#include "mjforge/customize/customize.h"
#include "mjforge/output/output.h"

namespace mjforge::app {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;
using boost::system::error_code;
using tcp = asio::ip::tcp;

// Limit of connections that have not yet sent a request with the token (the secret part of the
// page's address). If there are more, the oldest one is closed, so that connections of other users'
// programs cannot keep out a browser, whose request arrives at once.
constexpr std::size_t kMostStrangers = 64;
constexpr std::chrono::milliseconds kInterval(100);  // interval between checks of the spec's files
constexpr std::chrono::seconds kLongestWait(15);     // time limit of a page that waits for a change

constexpr std::string_view kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src blob: data:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

PageServer::Response MakeResponse(http::status status, std::string_view type, std::string body) {
  PageServer::Response response(status, 11);
  response.set(http::field::content_type, {type.data(), type.size()});
  response.set(http::field::cache_control, "no-store");
  response.set("Content-Security-Policy", {kPolicy.data(), kPolicy.size()});
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set("Referrer-Policy", "no-referrer");
  response.set("X-Content-Type-Options", "nosniff");
  response.body() = std::move(body);
  return response;
}

PageServer::Response Text(http::status status, std::string_view text) {
  return MakeResponse(status, "text/plain; charset=utf-8", std::string(text) + "\n");
}

std::string_view View(boost::beast::string_view text) { return {text.data(), text.size()}; }

std::string_view Header(const PageServer::Request& request, std::string_view name) {
  return View(request[boost::beast::string_view(name.data(), name.size())]);
}

// Returns the value of `name` in a query: "7" for `revision` in "revision=7".
std::string_view QueryValue(std::string_view query, std::string_view name) {
  if (!query.starts_with(name) || query.substr(name.size(), 1) != "=") return {};
  return query.substr(name.size() + 1);
}

std::string LengthBytes(std::size_t length) {
  static_assert(std::endian::native == std::endian::little, "the page reads this order");
  const auto number = static_cast<std::uint32_t>(length);
  std::string bytes(sizeof(number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(number));
  return bytes;
}

std::string BodyOf(std::string_view json, std::string_view picture) {
  return fmt::format("{}{}{}", LengthBytes(json.size()), json, picture);
}

// Terminator of each file name in an encoded answer. No file name contains this byte.
constexpr char kEnd = '\0';

}  // namespace

std::string EncodeAnswer(const std::vector<std::filesystem::path>& files, std::string_view json,
                         std::string_view picture) {
  std::string text;
  for (const std::filesystem::path& file : files) text += file.string() + kEnd;
  return text + kEnd + BodyOf(json, picture);
}

PageServer::PageServer(asio::io_context& io, const WorkerMaker& make, Seconds time_limit)
    : io_(io),
      acceptor_(io),
      timer_(io),
      queue_(io, make, time_limit, RequestQueue::Replace::kWaiting),
      slow_queue_(io, make, time_limit, RequestQueue::Replace::kRunning),
      token_(customize::MakeToken()) {}

std::string PageServer::Listen(std::uint16_t port) {
  const tcp::endpoint endpoint(asio::ip::address_v4::loopback(), port);
  error_code error;
  acceptor_.open(endpoint.protocol(), error);
  if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  if (error) return error.message();
  Accept();
  Tick();
  return {};
}

std::string PageServer::Address() const {
  return fmt::format("http://127.0.0.1:{}/{}/", acceptor_.local_endpoint().port(), token_);
}

void PageServer::Accept() {
  acceptor_.async_accept([this](error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted) return;
    if (!error) {
      ++accepted_;
      strangers_[accepted_] = ServeConnection(std::move(socket), *this, accepted_);
    }
    if (strangers_.size() > kMostStrangers) {
      strangers_.begin()->second();
      strangers_.erase(strangers_.begin());
    }
    Accept();
  });
}

PageServer::Response PageServer::TooLong() {
  return Text(http::status::payload_too_large, "mjforge: the request is too long");
}

std::optional<PageServer::Response> PageServer::Refusal(const Request& request) const {
  const std::string_view target = View(request.target());
  const std::string_view refusal =
      customize::Refusal({.path = target.substr(0, target.find('?')),
                          .host = Header(request, "Host"),
                          .origin = Header(request, "Origin"),
                          .fetch_site = Header(request, "Sec-Fetch-Site"),
                          .proxy_path = Header(request, "X-ProxyContextPath")},
                         token_);
  if (refusal.empty()) return std::nullopt;
  return Text(http::status::forbidden, fmt::format("mjforge: {}", refusal));
}

void PageServer::Answer(const Request& request, const Respond& respond) {
  const std::string_view target = View(request.target());
  const std::string_view path = target.substr(0, target.find('?'));
  const std::size_t slash = path.find('/', 1);
  if (slash == path.npos) return respond(Text(http::status::not_found, "mjforge: no such page"));
  const std::string_view name = path.substr(slash + 1);
  const std::string_view query = target.substr(std::min(path.size() + 1, target.size()));
  if (request.method() == http::verb::get) return AnswerGet(name, query, respond);
  if (request.method() == http::verb::post) return AnswerPost(name, query, request.body(), respond);
  respond(Text(http::status::method_not_allowed, "mjforge: only GET and POST"));
}

void PageServer::AnswerGet(std::string_view name, std::string_view query, const Respond& respond) {
  if (name == "events") {
    const auto revision = output::ReadIndex(QueryValue(query, "revision")).value_or(0);
    waiting_.push_back({revision, std::chrono::steady_clock::now() + kLongestWait, respond});
    return;
  }
  for (const customize::PageFile& file : customize::PageFiles()) {
    if (file.name == name)
      return respond(MakeResponse(http::status::ok, file.type, std::string(file.text)));
  }
  respond(Text(http::status::not_found, "mjforge: no such page"));
}

void PageServer::AnswerPost(std::string_view name, std::string_view query, const std::string& body,
                            const Respond& respond) {
  if (name != "ask" && name != "draw" && name != "slow")
    return respond(Text(http::status::not_found, "mjforge: no such page"));
  const std::string client(name != "ask" ? QueryValue(query, "client") : std::string_view());
  RequestQueue& queue = name == "slow" ? slow_queue_ : queue_;
  queue.Add(client, body,
            [this, respond](const RequestQueue::Outcome& outcome) { respond(AnswerOf(outcome)); });
}

PageServer::Response PageServer::AnswerOf(const RequestQueue::Outcome& outcome) {
  constexpr std::string_view kType = "application/octet-stream";
  if (outcome.kind == RequestQueue::Outcome::Kind::kReplaced)
    return Text(http::status::conflict, "mjforge: a newer request replaced it");
  if (outcome.kind == RequestQueue::Outcome::Kind::kFailed) {
    const std::string json = diag::JsonObject(
        nullptr, [&](diag::Json& body) { body.Member("error", "the variant " + outcome.text); });
    return MakeResponse(http::status::ok, kType, BodyOf(json, {}));
  }
  std::string_view text = outcome.text;
  while (text.front() != kEnd) {
    watched_.Add(text.substr(0, text.find(kEnd)));
    text.remove_prefix(text.find(kEnd) + 1);
  }
  return MakeResponse(http::status::ok, kType, std::string(text.substr(1)));
}

// Checks the files for changes, and answers the pages that wait for a change.
void PageServer::Tick() {
  if (watched_.HasChanged()) ++revision_;
  const auto now = std::chrono::steady_clock::now();
  const auto is_done = [&](const Waiting& page) {
    return page.revision != revision_ || page.end <= now;
  };
  const auto done = std::stable_partition(waiting_.begin(), waiting_.end(),
                                          [&](const Waiting& page) { return !is_done(page); });
  const std::vector<Waiting> pages(done, waiting_.end());
  waiting_.erase(done, waiting_.end());
  for (const Waiting& page : pages)
    page.respond(MakeResponse(http::status::ok, "application/json",
                              fmt::format("{{\"revision\":{}}}", revision_)));
  timer_.expires_after(kInterval);
  timer_.async_wait([this](error_code error) {
    if (!error) Tick();
  });
}

}  // namespace mjforge::app
