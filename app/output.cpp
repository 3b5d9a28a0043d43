#include "app/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>

namespace artcal {
namespace {

tl::unexpected<Error> cannot_write(const std::string& path) {
  return bad_input(fmt::format("the file cannot be written: {}", std::strerror(errno)), path);
}

bool write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = ::write(file, text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) {
      return false;
    }
    done += written > 0 ? static_cast<std::size_t>(written) : 0;
  }
  return true;
}

}  // namespace

Expected<void> write_file(const std::string& path, const std::string& text) {
  if (std::filesystem::is_directory(path)) {
    return bad_input("this is a folder, expected the name of a file to write", path);
  }
  std::string temporary = path + ".XXXXXX";
  const int file = ::mkstemp(temporary.data());
  if (file < 0) {
    return cannot_write(path);
  }
  const mode_t mask = ::umask(0);
  ::umask(mask);
  const bool written = write_all(file, text) && ::fchmod(file, 0666 & ~mask) == 0 && ::fsync(file) == 0;
  const int reason = errno;
  const bool closed = ::close(file) == 0;
  if (!written || !closed || std::rename(temporary.c_str(), path.c_str()) != 0) {
    errno = written ? errno : reason;
    auto error = cannot_write(path);
    ::unlink(temporary.c_str());
    return error;
  }
  return {};
}

Expected<void> write_json(const std::string& path, const nlohmann::ordered_json& json) {
  if (path.empty()) {
    return {};
  }
  // Names come from files; what is not UTF-8 in them is replaced rather than thrown at.
  const std::string text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  if (path != "-") {
    return write_file(path, text);
  }
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    return cannot_write("standard output");
  }
  return {};
}

int report_error(const Error& error) {
  fmt::print(stderr, "artcal: {}\n", error.text());
  return static_cast<int>(error.code);
}

}  // namespace artcal
