#include "app/output/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "app/output/capture.h"
#include "app/output/file_mode.h"
#include "app/output/write_all.h"
#include "app/shell/command_line_paths.h"
#include "app/store/where.h"
#include "core/files/size_limits.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

tl::unexpected<Error> cannot_write(const std::string& path) {
  return bad_input(fmt::format("the file cannot be written: {}", std::strerror(errno)), path);
}

// A pipe or a device such as /dev/null is written to, never replaced by a file.
Expected<void> write_device(const std::string& path, const std::string& text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) {
    return cannot_write(path);
  }
  const bool written = write_all(file, text);
  const int reason = errno;
  if (::close(file) != 0 || !written) {
    errno = written ? errno : reason;
    return cannot_write(path);
  }
  return {};
}

}  // namespace

Expected<void> write_file(const std::string& path, const std::string& text) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) {
    return bad_input("this is a folder, expected the name of a file to write", path);
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    return write_device(path, text);
  }
  // A link stays one: what it leads to is replaced.
  const auto target = std::filesystem::is_symlink(std::filesystem::symlink_status(path, ignored))
                          ? std::filesystem::weakly_canonical(path, ignored).string()
                          : path;
  std::string temporary = target + ".XXXXXX";
  const int file = ::mkstemp(temporary.data());
  if (file < 0) {
    return cannot_write(path);
  }
  const bool written = write_all(file, text) && ::fchmod(file, file_mode(0666)) == 0 && ::fsync(file) == 0;
  const int reason = errno;
  const bool closed = ::close(file) == 0;
  if (!written || !closed || std::rename(temporary.c_str(), target.c_str()) != 0) {
    errno = written ? errno : reason;
    auto error = cannot_write(path);
    ::unlink(temporary.c_str());
    return error;
  }
  return {};
}

Expected<void> check_outputs(const std::vector<std::string>& outputs, const std::vector<InputFile>& inputs) {
  std::vector<std::filesystem::path> files;
  for (const std::string& output : outputs) {
    if (output.empty() || output == "-") {
      continue;
    }
    std::error_code error;
    for (const InputFile& input : inputs) {
      if (std::filesystem::equivalent(output, input.path, error)) {
        return wrong_usage(fmt::format(
            "{} is an input of this result and would be overwritten; give the output another name", in_quotes(output)));
      }
    }
    const auto file = std::filesystem::weakly_canonical(std::filesystem::absolute(output, error), error);
    if (std::find(files.begin(), files.end(), file) != files.end()) {
      return wrong_usage(fmt::format("two outputs are to be written to {}; give each its own name", in_quotes(output)));
    }
    files.push_back(file);
  }
  return {};
}

Expected<void> check_replaced(const std::string& output, OutputKind kind) {
  std::error_code ignored;
  if (output.empty() || output == "-" || !std::filesystem::is_regular_file(output, ignored)) {
    return {};
  }
  constexpr std::string_view page = "<!doctype html";
  std::string beginning(page.size(), '\0');
  std::ifstream stream(output, std::ios::binary);
  stream.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(stream.gcount()));
  std::transform(beginning.begin(), beginning.end(), beginning.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const bool is_ours = kind == OutputKind::Page ? beginning == page : beginning.starts_with('{');
  if (!stream.is_open() || beginning.empty() || is_ours) {
    return {};
  }
  return wrong_usage(
      fmt::format("{} exists and is no {}; it may be an input and would be overwritten; give the output "
                  "another name",
                  in_quotes(output), kind == OutputKind::Page ? "page (HTML)" : "result (JSON)"));
}

std::string json_text(const nlohmann::ordered_json& json) {
  // What is not UTF-8 is replaced.
  return json.dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

Expected<void> write_json(const std::string& path, const nlohmann::ordered_json& json) {
  if (path.empty()) {
    return {};
  }
  std::string text = json_text(json);
  if (path != "-") {
    return write_file(path, text);
  }
  if (Capture* const capture = current_capture()) {
    capture->json = std::move(text);
    return {};
  }
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    return cannot_write("standard output");
  }
  return {};
}

int report_error(const Error& error) {
  if (Capture* const capture = current_capture()) {
    capture->error = error;
    return static_cast<int>(error.code);
  }
  fmt::print(stderr, "artcal: {}\n", truncated(largest::message, without_passwords(text_with_origin(error))));
  return static_cast<int>(error.code);
}

}  // namespace artcal
