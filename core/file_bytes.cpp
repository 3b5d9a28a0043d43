#include "core/file_bytes.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

#include "core/hash.h"

namespace artcal {

Expected<FileBytes> read_file_bytes(const std::filesystem::path& path, std::size_t max_bytes,
                                    std::string_view expected) {
  const std::string name = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) {
    return bad_input("there is no such file; check the path, which is taken from the folder of the file that names it",
                     name);
  }
  if (!std::filesystem::is_regular_file(status)) {
    return bad_input(fmt::format("this is a folder or a device, expected {}", expected), name);
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
  file.bytes.resize(error ? 0 : size);
  stream.read(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()));
  if (static_cast<std::size_t>(stream.gcount()) != file.bytes.size()) {
    return bad_input("the file ended early while it was read; is it still being written?", name);
  }
  if (file.bytes.empty()) {
    return bad_input("the file is empty", name);
  }
  file.sha256 = sha256(file.bytes);
  return file;
}

}  // namespace artcal
