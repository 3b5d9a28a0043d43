#include "app/stream/line_source.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/serial_port.hpp>

#include "app/stream/stream_event.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr int look_again_ms = 20;

/// Cuts bytes into lines; of a line that is too long nothing is kept.
class Lines {
 public:
  void add(const char* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      if (bytes[i] == '\n') {
        lines_ += too_long_ ? "\x01" : line_;  // no event begins with that byte
        lines_ += '\n';
        line_.clear();
        too_long_ = false;
      } else if (line_.size() >= max_event_bytes) {
        too_long_ = true;
      } else {
        line_ += bytes[i];
      }
    }
  }
  [[nodiscard]] bool take(std::string& line) {
    const auto end = lines_.find('\n', at_);
    if (end == std::string::npos) {
      lines_.erase(0, at_);
      at_ = 0;
      return false;
    }
    line.assign(lines_, at_, end - at_);
    at_ = end + 1;
    return true;
  }

 private:
  std::string lines_;  // whole ones
  std::size_t at_ = 0;
  std::string line_;
  bool too_long_ = false;
};

/// Lines of a file descriptor, which something else may own.
class DescriptorSource : public LineSource {
 public:
  DescriptorSource(int file, bool follow) : file_(file), follow_(follow) {}

  Kind next(std::string& line, int wait_ms) override {
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(wait_ms);
    for (;;) {
      if (lines_.take(line)) {
        return line == "\x01" ? Kind::TooLong : Kind::Line;
      }
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(until - std::chrono::steady_clock::now()).count();
      if (left < 0) {
        return Kind::Nothing;
      }
      pollfd ready{file_, POLLIN, 0};
      if (::poll(&ready, 1, static_cast<int>(left)) <= 0) {
        continue;
      }
      char buffer[16384];
      const ssize_t count = ::read(file_, buffer, sizeof buffer);
      if (count > 0) {
        lines_.add(buffer, static_cast<std::size_t>(count));
      } else if (count == 0 && follow_) {
        std::this_thread::sleep_for(std::chrono::milliseconds(look_again_ms));
      } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
        return Kind::End;
      }
    }
  }

 private:
  int file_;
  bool follow_;
  Lines lines_;
};

/// The same of what it owns.
template <typename Owned>
class OwningSource : public DescriptorSource {
 public:
  OwningSource(std::unique_ptr<Owned> owned, int file, bool follow)
      : DescriptorSource(file, follow), owned_(std::move(owned)) {}

 private:
  std::unique_ptr<Owned> owned_;
};

struct File {
  int file;
  ~File() { ::close(file); }
};
struct Connection {
  asio::io_context context;
  tcp::socket socket{context};
};
struct Port {
  asio::io_context context;
  asio::serial_port port{context};
};

using Opened = Expected<std::unique_ptr<LineSource>>;

tl::unexpected<Error> cannot_open(const std::string& address, const std::string& why) {
  return bad_input(fmt::format("the source {} cannot be opened: {}", in_quotes(address), why));
}

Opened opened(std::unique_ptr<Connection> connection) {
  const int file = connection->socket.native_handle();
  return std::make_unique<OwningSource<Connection>>(std::move(connection), file, false);
}

std::optional<int> number_in(std::string_view text, int highest) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && number > 0 && number <= highest
             ? std::optional(number)
             : std::nullopt;
}

Opened connect(const std::string& address, const std::string& host, const std::string& port) {
  auto connection = std::make_unique<Connection>();
  boost::system::error_code error;
  const auto ends = tcp::resolver(connection->context).resolve(host, port, error);
  if (!error) {
    asio::connect(connection->socket, ends, error);
  }
  return error ? Opened(cannot_open(address, error.message())) : opened(std::move(connection));
}

Opened listen(const std::string& address, int port) {
  auto connection = std::make_unique<Connection>();
  boost::system::error_code error;
  tcp::acceptor acceptor(connection->context);
  const tcp::endpoint end(asio::ip::address_v4::loopback(), static_cast<unsigned short>(port));
  acceptor.open(end.protocol(), error);
  if (!error) {
    acceptor.set_option(tcp::acceptor::reuse_address(true), error);
  }
  if (!error) {
    acceptor.bind(end, error);
  }
  if (!error) {
    acceptor.listen(1, error);
  }
  if (!error) {
    acceptor.accept(connection->socket, error);
  }
  return error ? Opened(cannot_open(address, error.message())) : opened(std::move(connection));
}

Opened open_serial(const std::string& address, const std::string& device, int baud) {
  auto port = std::make_unique<Port>();
  boost::system::error_code error;
  port->port.open(device, error);
  if (!error) {
    port->port.set_option(asio::serial_port_base::baud_rate(static_cast<unsigned>(baud)), error);
  }
  if (error) {
    return cannot_open(address, error.message());
  }
  const int file = port->port.native_handle();
  return std::make_unique<OwningSource<Port>>(std::move(port), file, false);
}

Opened open_address(const std::string& address, std::string_view rest, bool is_listener) {
  const auto colon = rest.rfind(':');
  const std::string host(is_listener || colon == std::string_view::npos ? "" : rest.substr(0, colon));
  const std::string port(is_listener ? rest : colon == std::string_view::npos ? "" : rest.substr(colon + 1));
  const auto number = number_in(port, 65535);
  if (!number || (!is_listener && host.empty())) {
    return wrong_usage(
        fmt::format("the source {} is no address, expected tcp://HOST:PORT or listen://PORT", in_quotes(address)));
  }
  return is_listener ? listen(address, *number) : connect(address, host, port);
}

}  // namespace

Expected<std::unique_ptr<LineSource>> open_source(const std::string& address, bool follow) {
  const std::string_view text(address);
  if (text == "-") {
    return std::make_unique<DescriptorSource>(STDIN_FILENO, false);
  }
  for (const std::string_view scheme : {"tcp://", "listen://"}) {
    if (text.starts_with(scheme)) {
      return open_address(address, text.substr(scheme.size()), scheme == "listen://");
    }
  }
  if (constexpr std::string_view serial = "serial://"; text.starts_with(serial)) {
    const std::string_view rest = text.substr(serial.size());
    const auto query = rest.find("?baud=");
    const auto baud =
        query == std::string_view::npos ? std::optional(9600) : number_in(rest.substr(query + 6), 4'000'000);
    if (!baud) {
      return wrong_usage(
          fmt::format("the source {} has no rate, expected serial:///dev/ttyUSB0?baud=115200", in_quotes(address)));
    }
    return open_serial(address, std::string(rest.substr(0, query)), *baud);
  }
  const int file = ::open(address.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) {
    return cannot_open(address, std::strerror(errno));
  }
  return std::make_unique<OwningSource<File>>(std::make_unique<File>(File{file}), file, follow);
}

}  // namespace artcal
