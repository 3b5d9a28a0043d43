#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"

namespace artcal {

/// A file's whole content, and the hash by which a result names it.
struct FileBytes {
  std::filesystem::path path;
  std::string bytes;
  std::string sha256;
};

/// Reads a file of any kind. Refused, each with a sentence: not there, not readable, a directory or device,
/// empty, more than `max_bytes`. `expected` says what kind of file a folder stands in for.
Expected<FileBytes> read_file_bytes(const std::filesystem::path& path, std::size_t max_bytes,
                                    std::string_view expected = "a file");

/// The same without the hash, which takes as long as reading does: for who computes it (core/files/hash.h) beside what
/// is done with the bytes.
Expected<FileBytes> read_unhashed_file_bytes(const std::filesystem::path& path, std::size_t max_bytes,
                                             std::string_view expected = "a file");

}  // namespace artcal
