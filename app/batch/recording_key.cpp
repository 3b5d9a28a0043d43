#include "app/batch/recording_key.h"

#include <string_view>

#include "app/version.h"
#include "core/files/file_bytes.h"
#include "core/files/hash.h"
#include "core/files/size_limits.h"

namespace artcal {
namespace {

std::string content_now(const std::filesystem::path& path) {
  const auto file = read_file_bytes(path, largest::any);
  return file ? file->sha256 : std::string();
}

// Whether a path may begin behind this character of a message.
bool begins_path_after(char c) { return std::string_view(" \t\n\"'`([{<,;:=|").find(c) != std::string_view::npos; }

}  // namespace

std::vector<InputFile> seen_from(const std::filesystem::path& folder, const std::vector<InputFile>& inputs) {
  const std::string prefix = (folder / "").string();
  std::vector<InputFile> seen = inputs;
  for (InputFile& input : seen) {
    if (input.path.starts_with(prefix)) {
      input.path.erase(0, prefix.size());
    }
  }
  return seen;
}

std::string without_folder(std::string text, const std::filesystem::path& folder) {
  const std::string prefix = (folder / "").string();
  if (!folder.has_relative_path()) {
    return text;  // "/" begins every path
  }
  for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix, at)) {
    if (at == 0 || begins_path_after(text[at - 1])) {
      text.erase(at, prefix.size());
    } else {
      ++at;
    }
  }
  return text;
}

std::string recording_key(const std::vector<InputFile>& inputs, const std::string& name, const BatchOptions& options) {
  constexpr char end = '\0';  // no name holds one
  std::string text = std::string("artcal ") + program_version + end + options.text() + end + name + end;
  for (const InputFile& input : inputs) {
    text += input.sha256 + end;
  }
  return sha256(text).substr(0, 32);
}

std::vector<InputFile> hashed_now(const std::filesystem::path& folder, const std::vector<InputFile>& inputs) {
  std::vector<InputFile> now = inputs;
  for (InputFile& input : now) {
    input.sha256 = content_now(folder / input.path);
    if (input.sha256.empty()) {
      return {};
    }
  }
  return now;
}

std::string first_changed(const std::filesystem::path& folder, const std::vector<InputFile>& inputs) {
  for (const InputFile& input : inputs) {
    if (content_now(folder / input.path) != input.sha256) {
      return input.path;
    }
  }
  return {};
}

}  // namespace artcal
