// Reads and answers the HTTP requests of one connection between a browser and the PageServer.
#include "page_connection.h"

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "page_server.h"

namespace mjforge::app {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::system::error_code;

constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 20;  // size limit of a request
constexpr std::chrono::seconds kPatience(30);  // time limit for a request or a response
// Shorter time limit for the first request, because programs of other users can connect, too. Such
// programs do not know the token (the secret part of the page's address).
constexpr std::chrono::seconds kFirstPatience(5);

class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(boost::asio::ip::tcp::socket socket, PageServer& server, std::uint64_t number)
      : stream_(std::move(socket)), server_(server), number_(number) {}

  /// Reads a request, which must arrive within `patience`.
  void Read(std::chrono::seconds patience) {
    parser_.emplace();
    parser_->body_limit(kMostBytes);
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](error_code error, std::size_t) {
                       if (!error) return self->Answer();
                       if (error == http::error::body_limit)
                         self->Write(PageServer::TooLong(), false);
                     });
  }

  void Close() { stream_.close(); }

 private:
  void Answer() {
    if (const auto refusal = server_.Refusal(parser_->get())) return Write(*refusal, false);
    server_.Trust(number_);
    stream_.expires_never();
    server_.Answer(parser_->get(), [self = shared_from_this()](PageServer::Response response) {
      self->Write(std::move(response), self->parser_->get().keep_alive());
    });
  }

  void Write(PageServer::Response response, bool keep_alive) {
    response_ = std::move(response);
    response_.keep_alive(keep_alive);
    response_.prepare_payload();
    stream_.expires_after(kPatience);
    http::async_write(stream_, response_,
                      [self = shared_from_this()](error_code error, std::size_t) {
                        if (!error && self->response_.keep_alive()) self->Read(kPatience);
                      });
  }

  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  PageServer::Response response_;
  PageServer& server_;
  std::uint64_t number_;
};

}  // namespace

CloseConnection ServeConnection(boost::asio::ip::tcp::socket socket, PageServer& server,
                                std::uint64_t number) {
  const auto connection = std::make_shared<Connection>(std::move(socket), server, number);
  connection->Read(kFirstPatience);
  return [weak = std::weak_ptr(connection)] {
    if (const auto still = weak.lock()) still->Close();
  };
}

}  // namespace mjforge::app
