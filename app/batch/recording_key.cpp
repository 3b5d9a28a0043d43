#include "app/batch/recording_key.h"

#include "app/version.h"
#include "core/file_bytes.h"
#include "core/hash.h"

namespace artcal {
namespace {

constexpr std::size_t most_bytes = std::size_t{4} << 30;

std::string content_now(const std::filesystem::path& path) {
  const auto file = read_file_bytes(path, most_bytes);
  return file ? file->sha256 : std::string();
}

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

std::string recording_key(const std::vector<InputFile>& inputs, const BatchOptions& options) {
  constexpr char end = '\0';  // no path holds one
  std::string text = std::string("artcal ") + program_version + end + options.text() + end;
  for (const InputFile& input : inputs) {
    text += input.path + end + input.sha256 + end;
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
