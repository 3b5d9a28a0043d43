#include "core/files/file_bytes.h"

#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include <fmt/format.h>

#include "core/files/hash.h"
#include "core/large_pages.h"

namespace artcal {
namespace {

bool is_windows_path(const std::string& name) {
  const bool has_drive = name.size() > 2 && std::isalpha(static_cast<unsigned char>(name[0])) != 0 && name[1] == ':' &&
                         (name[2] == '\\' || name[2] == '/');
  return has_drive || name.find('\\') != std::string::npos;
}

// Of a path that leads nowhere.
std::string what_is_wrong_with(const std::filesystem::path& path) {
  const std::string name = path.string();
  if (is_windows_path(name)) {
    return "this is a path of Windows, expected one with slashes and without a drive, such as data/recording.toml";
  }
  const std::filesystem::path folder = path.parent_path();
  std::error_code error;
  return folder.empty() ? "the current folder has none of that name; check the path"
         : std::filesystem::is_directory(folder, error)
             ? "its folder is there, but has none of that name; check the name"
             : "its folder is not there either; check the path";
}

}  // namespace

Expected<FileBytes> read_file_bytes(const std::filesystem::path& path, std::size_t max_bytes,
                                    std::string_view expected) {
  return read_unhashed_file_bytes(path, max_bytes, expected).map([](FileBytes&& file) {
    file.sha256 = sha256(file.bytes);
    return std::move(file);
  });
}

Expected<FileBytes> read_unhashed_file_bytes(const std::filesystem::path& path, std::size_t max_bytes,
                                             std::string_view expected) {
  const std::string name = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    const std::string found = "there is no such file";
    return tl::unexpected(Error{ErrorCode::BadInput, fmt::format("{}; {}", found, what_is_wrong_with(path)), name,
                                ErrorKind::MissingFile, found});
  }
  if (!std::filesystem::is_regular_file(status)) {
    return bad_input(std::filesystem::is_directory(status)
                         ? fmt::format("this is a folder, expected {}; name the file that lies in it", expected)
                         : fmt::format("this is a device or a pipe, expected {}", expected),
                     name);
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
  FileBytes file{path, {}, {}};
  file.bytes.reserve(error ? 0 : size);
  prefer_large_pages(file.bytes.data(), file.bytes.capacity());
  file.bytes.resize(error ? 0 : size);
  stream.read(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()));
  if (static_cast<std::size_t>(stream.gcount()) != file.bytes.size()) {
    return bad_input("the file ended early while it was read; is it still being written?", name);
  }
  if (file.bytes.empty()) {
    return bad_input("the file is empty", name);
  }
  return file;
}

}  // namespace artcal
