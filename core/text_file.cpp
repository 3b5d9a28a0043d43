#include "core/text_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

#include "core/hash.h"

namespace artcal {
namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

bool looks_binary(std::string_view text) { return text.find('\0') != std::string_view::npos; }

}  // namespace

Expected<TextFile> read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
  const std::string name = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    return bad_input("there is no such file; check the path, which is taken from the folder of the file that names it",
                     name);
  }
  if (!std::filesystem::is_regular_file(status)) {
    return bad_input("this is a folder or a device, expected a text file", name);
  }
  const auto size = std::filesystem::file_size(path, error);
  if (!error && size > max_bytes) {
    return bad_input(fmt::format("the file has {} bytes, more than the {} that are read; split it", size, max_bytes),
                     name);
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return bad_input(fmt::format("the file cannot be opened: {}", std::strerror(errno)), name);
  }
  TextFile file{path, {}, {}};
  file.text.resize(error ? 0 : size);
  stream.read(file.text.data(), static_cast<std::streamsize>(file.text.size()));
  if (static_cast<std::size_t>(stream.gcount()) != file.text.size()) {
    return bad_input("the file ended early while it was read; is it still being written?", name);
  }
  file.sha256 = sha256(file.text);
  if (file.text.starts_with(utf8_mark)) {
    file.text.erase(0, utf8_mark.size());
  }
  if (file.text.empty()) {
    return bad_input("the file is empty", name);
  }
  if (looks_binary(file.text)) {
    return bad_input("the file holds zero bytes (binary or UTF-16), expected plain UTF-8 text", name);
  }
  return file;
}

}  // namespace artcal
