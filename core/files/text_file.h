#pragma once

#include <filesystem>
#include <string>

#include "core/error.h"

namespace artcal {

/// A text file's whole content, without a UTF-8 byte-order mark, and what it rests on.
struct TextFile {
  std::filesystem::path path;
  std::string text;
  std::string sha256;  ///< of the file's bytes, the mark included
};

/// Reads a text file. Refused, each with a sentence: not there, not readable, a directory or device,
/// empty, binary content or another encoding than UTF-8, more than `max_bytes`.
Expected<TextFile> read_text_file(const std::filesystem::path& path, std::size_t max_bytes = std::size_t{4} << 30);

}  // namespace artcal
