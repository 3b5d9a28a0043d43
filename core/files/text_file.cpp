#include "core/files/text_file.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "core/files/file_bytes.h"

namespace artcal {
namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

bool looks_binary(std::string_view text) { return text.find('\0') != std::string_view::npos; }

// Length of the UTF-8 character that `text` begins with, or 0 if it begins with none (RFC 3629).
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const unsigned first = byte(0);
  if (first < 0x80) {
    return 1;
  }
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) {
      return 0;
    }
  }
  // Overlong forms, surrogates and what lies beyond the last code point.
  const unsigned second = byte(1);
  const bool beyond = (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ||
                      (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F);
  return beyond ? 0 : length;
}

constexpr std::size_t ascii_step = sizeof(std::uint64_t);

// Whether the next eight bytes are there and ASCII: nearly all of nearly every file.
bool is_ascii(std::string_view text, std::size_t at) {
  std::uint64_t bytes = ~std::uint64_t{0};
  if (text.size() - at >= ascii_step) {
    std::memcpy(&bytes, text.data() + at, ascii_step);
  }
  return (bytes & 0x8080808080808080u) == 0;
}

// Offset of the first byte that is not UTF-8, or npos.
std::size_t find_not_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    if (is_ascii(text, i)) {
      i += ascii_step;
      continue;
    }
    const std::size_t length = character_length(text.substr(i));
    if (length == 0) {
      return i;
    }
    i += length;
  }
  return std::string_view::npos;
}

}  // namespace

Expected<TextFile> read_text_file(const std::filesystem::path& path, std::size_t max_bytes) {
  auto whole = read_file_bytes(path, max_bytes, "a text file");
  if (!whole) {
    return tl::unexpected(whole.error());
  }
  const std::string name = path.string();
  TextFile file{path, std::move(whole->bytes), std::move(whole->sha256)};
  if (file.text.starts_with(utf8_mark)) {
    file.text.erase(0, utf8_mark.size());
  }
  if (file.text.empty()) {
    return bad_input("the file is empty", name);
  }
  if (looks_binary(file.text)) {
    return bad_input("the file holds zero bytes (binary or UTF-16), expected plain UTF-8 text", name);
  }
  if (const auto at = find_not_utf8(file.text); at != std::string::npos) {
    const auto line = 1 + std::count(file.text.begin(), file.text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    return bad_input(fmt::format("the byte 0x{:02x} is not UTF-8; save the file as UTF-8 (it may be Latin-1 now)",
                                 static_cast<unsigned char>(file.text[at])),
                     fmt::format("{}:{}", name, line));
  }
  return file;
}

}  // namespace artcal
