#include "core/files/text_file.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/files/file_bytes.h"
#include "core/text/utf8.h"

namespace artcal {
namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

bool looks_binary(std::string_view text) { return text.find('\0') != std::string_view::npos; }

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
