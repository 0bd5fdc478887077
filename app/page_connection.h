// A browser's connection to the server.
#pragma once

#include <boost/asio/ip/tcp.hpp>

namespace mjforge::app {

class PageServer;

/// Reads requests from a connection and writes the responses of the server, until the browser
/// closes the connection or leaves it idle.
void ServeConnection(boost::asio::ip::tcp::socket socket, PageServer& server);

}  // namespace mjforge::app
