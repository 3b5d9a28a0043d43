#include "app/stream/source/line_source.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <functional>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/serial_port.hpp>

#include "app/stream/source/line_splitter.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

constexpr int look_again_ms = 20;

/// What owns a descriptor, by its type.
struct File {
  int descriptor;
  explicit File(int opened) : descriptor(opened) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() { ::close(descriptor); }
};
struct Connection {
  asio::io_context context;
  tcp::socket socket{context};
  tcp::acceptor acceptor{context};
};
struct Port {
  asio::io_context context;
  asio::serial_port port{context};
};

bool is_readable(int descriptor, int wait_ms) {
  pollfd ready{descriptor, POLLIN, 0};
  return ::poll(&ready, 1, wait_ms) > 0;
}

/// Lines of a file descriptor and of what owns it.
class DescriptorSource : public LineSource {
 public:
  enum class AtEnd { Stop, WaitForMore };

  DescriptorSource(int descriptor, AtEnd at_end, bool is_live, std::shared_ptr<void> owner)
      : descriptor_(descriptor), at_end_(at_end), is_live_(is_live), owner_(std::move(owner)) {}

  Kind next(std::string& line, int wait_ms) override {
    for (bool waited = false;; waited = true) {
      switch (lines_.take(line)) {
        case LineSplitter::Taken::Line: return Kind::Line;
        case LineSplitter::Taken::TooLong: return Kind::TooLong;
        case LineSplitter::Taken::Nothing: break;
      }
      if (has_ended_) {
        return end(line);
      }
      if (waited || !is_readable(descriptor_, wait_ms)) {
        return Kind::Nothing;
      }
      read();
    }
  }

  [[nodiscard]] bool is_live() const override { return is_live_; }

 private:
  void read() {
    char buffer[16384];
    const ssize_t count = ::read(descriptor_, buffer, sizeof buffer);
    if (count > 0) {
      lines_.add({buffer, static_cast<std::size_t>(count)});
    } else if (count == 0 && at_end_ == AtEnd::WaitForMore) {
      std::this_thread::sleep_for(std::chrono::milliseconds(look_again_ms));
    } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
      has_ended_ = true;
    }
  }

  Kind end(std::string& line) {
    switch (lines_.take_rest(line)) {
      case LineSplitter::Taken::Line: return Kind::CutOff;
      case LineSplitter::Taken::TooLong: return Kind::TooLong;
      case LineSplitter::Taken::Nothing: break;
    }
    return Kind::End;
  }

  int descriptor_;
  AtEnd at_end_;
  bool is_live_;
  std::shared_ptr<void> owner_;
  LineSplitter lines_;
  bool has_ended_ = false;
};

/// Waits for one connection, then its lines.
class ListeningSource : public LineSource {
 public:
  explicit ListeningSource(std::shared_ptr<Connection> connection) : connection_(std::move(connection)) {}

  Kind next(std::string& line, int wait_ms) override {
    if (!lines_) {
      if (!is_readable(connection_->acceptor.native_handle(), wait_ms)) {
        return Kind::Nothing;
      }
      boost::system::error_code error;
      connection_->acceptor.accept(connection_->socket, error);
      if (error) {
        return Kind::Nothing;
      }
      connection_->acceptor.close(error);
      lines_.emplace(connection_->socket.native_handle(), DescriptorSource::AtEnd::Stop, true, connection_);
    }
    return lines_->next(line, wait_ms);
  }

  [[nodiscard]] bool is_live() const override { return true; }

 private:
  std::shared_ptr<Connection> connection_;
  std::optional<DescriptorSource> lines_;
};

using Opened = Expected<std::unique_ptr<LineSource>>;

tl::unexpected<Error> cannot_open(const std::string& address, const std::string& why) {
  return bad_input(fmt::format("the source {} cannot be opened: {}", in_quotes(address), why));
}

std::optional<int> positive_number(std::string_view text, int highest) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && number > 0 && number <= highest
             ? std::optional(number)
             : std::nullopt;
}

Opened connect(const std::string& address, const std::string& host, const std::string& port) {
  auto connection = std::make_shared<Connection>();
  boost::system::error_code error;
  const auto ends = tcp::resolver(connection->context).resolve(host, port, error);
  if (!error) {
    asio::connect(connection->socket, ends, error);
  }
  if (error) {
    return cannot_open(address, error.message());
  }
  const int descriptor = connection->socket.native_handle();
  return std::make_unique<DescriptorSource>(descriptor, DescriptorSource::AtEnd::Stop, true, std::move(connection));
}

Opened listen(const std::string& address, int port) {
  auto connection = std::make_shared<Connection>();
  boost::system::error_code error;
  tcp::acceptor& acceptor = connection->acceptor;
  const tcp::endpoint end(asio::ip::address_v4::loopback(), static_cast<unsigned short>(port));
  const std::function<void()> steps[] = {
      [&] { acceptor.open(end.protocol(), error); },
      [&] { acceptor.set_option(tcp::acceptor::reuse_address(true), error); },
      [&] { acceptor.bind(end, error); },
      [&] { acceptor.listen(1, error); },
  };
  for (const auto& step : steps) {
    if (step(); error) {
      return cannot_open(address, error.message());
    }
  }
  return std::make_unique<ListeningSource>(std::move(connection));
}

Opened open_serial(const std::string& address, const std::string& device, int baud) {
  auto port = std::make_shared<Port>();
  boost::system::error_code error;
  port->port.open(device, error);
  if (!error) {
    port->port.set_option(asio::serial_port_base::baud_rate(static_cast<unsigned>(baud)), error);
  }
  if (error) {
    return cannot_open(address, error.message());
  }
  const int descriptor = port->port.native_handle();
  return std::make_unique<DescriptorSource>(descriptor, DescriptorSource::AtEnd::Stop, true, std::move(port));
}

Opened open_network(const std::string& address, std::string_view rest, bool is_listener) {
  const auto colon = rest.rfind(':');
  const bool has_host = !is_listener && colon != std::string_view::npos;
  const std::string host(has_host ? rest.substr(0, colon) : std::string_view{});
  const std::string port(is_listener ? rest : has_host ? rest.substr(colon + 1) : std::string_view{});
  const auto number = positive_number(port, 65535);
  if (!number || (!is_listener && host.empty())) {
    return wrong_usage(
        fmt::format("the source {} is no address, expected tcp://HOST:PORT or listen://PORT", in_quotes(address)));
  }
  return is_listener ? listen(address, *number) : connect(address, host, port);
}

Opened open_file(const std::string& address, bool follow) {
  const int descriptor = ::open(address.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (descriptor < 0 || ::fstat(descriptor, &status) != 0) {
    return cannot_open(address, std::strerror(errno));
  }
  auto file = std::make_shared<File>(descriptor);
  if (S_ISDIR(status.st_mode)) {
    return cannot_open(address, "it is a folder");
  }
  return std::make_unique<DescriptorSource>(
      descriptor, follow ? DescriptorSource::AtEnd::WaitForMore : DescriptorSource::AtEnd::Stop,
      follow || !S_ISREG(status.st_mode), std::move(file));
}

}  // namespace

Opened open_source(const std::string& address, bool follow) {
  const std::string_view text(address);
  if (text == "-") {
    struct stat status {};
    const bool is_file = ::fstat(STDIN_FILENO, &status) == 0 && S_ISREG(status.st_mode);
    return std::make_unique<DescriptorSource>(STDIN_FILENO, DescriptorSource::AtEnd::Stop, !is_file, nullptr);
  }
  for (const std::string_view scheme : {"tcp://", "listen://"}) {
    if (text.starts_with(scheme)) {
      return open_network(address, text.substr(scheme.size()), scheme == "listen://");
    }
  }
  if (constexpr std::string_view serial = "serial://"; text.starts_with(serial)) {
    const std::string_view rest = text.substr(serial.size());
    const auto query = rest.find("?baud=");
    const auto baud =
        query == std::string_view::npos ? std::optional(9600) : positive_number(rest.substr(query + 6), 4'000'000);
    if (!baud || rest.substr(0, query).empty()) {
      return wrong_usage(fmt::format("the source {} is no serial port, expected serial:///dev/ttyUSB0?baud=115200",
                                     in_quotes(address)));
    }
    return open_serial(address, std::string(rest.substr(0, query)), *baud);
  }
  return open_file(address, follow);
}

}  // namespace artcal
