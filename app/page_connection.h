// Connection of a browser to the server of `mjforge customize`.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <functional>

namespace mjforge::app {

class PageServer;

/// Closes a connection that is still open.
using CloseConnection = std::function<void()>;

/// Reads requests from a connection and writes the responses of the server, until the browser
/// closes the connection or leaves it idle, or after a response that refuses a request. `number`
/// identifies the connection for PageServer::Trust. Returns a function that closes the connection.
CloseConnection ServeConnection(boost::asio::ip::tcp::socket socket, PageServer& server,
                                std::uint64_t number);

}  // namespace mjforge::app
