#include "app/stream/row_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "app/output/write_all.h"

namespace artcal {
namespace {

tl::unexpected<Error> failed(const std::filesystem::path& path) {
  return bad_input(fmt::format("the table cannot be written: {}", std::strerror(errno)), path.string());
}

std::string read_all(int file) {
  std::string text;
  char buffer[65536];
  for (ssize_t read = 0; (read = ::pread(file, buffer, sizeof buffer, static_cast<off_t>(text.size()))) > 0;) {
    text.append(buffer, static_cast<std::size_t>(read));
  }
  return text;
}

// The folder's entry too is to survive a power cut.
bool sync_folder(const std::filesystem::path& path) {
  const std::string folder = path.parent_path().empty() ? "." : path.parent_path().string();
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const bool done = file >= 0 && ::fsync(file) == 0;
  if (file >= 0) {
    ::close(file);
  }
  return done;
}

}  // namespace

RowFile::RowFile(RowFile&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      path_(std::move(other.path_)),
      rows_(other.rows_),
      first_rows_(std::move(other.first_rows_)) {}

RowFile::~RowFile() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

Expected<RowFile> RowFile::open(const std::filesystem::path& path, const std::string& header) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (file < 0) {
    return failed(path);
  }
  RowFile table(file, path);
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
    return bad_input("another artcal records into this table; end it first, or record into another folder",
                     path.string());
  }
  std::string text = read_all(file);
  text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);
  if (text.empty()) {
    if (::ftruncate(file, 0) != 0 || !write_all(file, header + "\n") || ::fsync(file) != 0 || !sync_folder(path)) {
      return failed(path);
    }
    return table;
  }
  if (!text.starts_with(header + "\n")) {
    return bad_input("the table begins with other columns than this stream gives; record into another folder",
                     path.string());
  }
  if (::ftruncate(file, static_cast<off_t>(text.size())) != 0 || ::fsync(file) != 0) {
    return failed(path);
  }
  for (std::size_t at = header.size() + 1; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    table.first_rows_.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  table.rows_ = table.first_rows_.size();
  return table;
}

Expected<void> RowFile::append(const std::string& row) {
  if (!write_all(file_, row + "\n") || ::fsync(file_) != 0) {
    return failed(path_);  // half a row has no line end: open() takes it away
  }
  ++rows_;
  return {};
}

Expected<void> RowFile::remove_last() {
  const std::string text = read_all(file_);
  const std::size_t end = text.size() < 2 ? std::string::npos : text.rfind('\n', text.size() - 2);
  if (rows_ == 0 || end == std::string::npos) {
    return {};
  }
  if (::ftruncate(file_, static_cast<off_t>(end + 1)) != 0 || ::fsync(file_) != 0) {
    return failed(path_);
  }
  --rows_;
  return {};
}

}  // namespace artcal
