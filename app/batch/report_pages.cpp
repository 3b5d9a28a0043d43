#include "app/batch/report_pages.h"

#include <filesystem>

#include "app/output/output.h"
#include "app/report/page.h"
#include "core/files/hash.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 60;
constexpr std::size_t digits = 16;

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
}

// What a person knows a recording by, in characters that mean nothing else anywhere.
std::string plain_name(const std::string& path) {
  const fs::path file(path);
  const std::string name = file.stem() == "recording" ? file.parent_path().filename().string() : file.stem().string();
  std::string plain;
  for (const char c : name) {
    if (is_plain(c) && !(plain.empty() && c == '.')) {
      plain += c;
    } else if (!plain.empty() && plain.back() != '-') {
      plain += '-';
    }
  }
  return plain.empty() ? "recording" : plain.substr(0, longest_name);
}

}  // namespace

ReportPages::ReportPages(const std::string& index, Kind kind)
    : folder_((fs::path(index).parent_path() / (fs::path(index).stem().string() + "-reports")).string()), kind_(kind) {}

void ReportPages::begin() {
  std::error_code error;
  fs::create_directory(folder_, error);
  if (error) {
    cannot_begin_ = Error{ErrorCode::BadInput, "the folder of the reports cannot be made: " + error.message(), folder_};
    return;
  }
  const std::string shared = (fs::path(folder_) / shared_scripts().name).string();
  if (kind_ == Kind::Shared && !fs::exists(shared, error)) {
    if (auto written = write_file(shared, shared_scripts().text); !written) {
      cannot_begin_ = written.error();
    }
  }
}

Expected<void> ReportPages::write(const std::string& path, const std::string& recording,
                                  const std::vector<ReportedResult>& results) const {
  if (cannot_begin_) {
    return tl::unexpected(*cannot_begin_);
  }
  return report_html(results, kind_ == Kind::Shared ? Scripts::SharedPlots : Scripts::Plots)
      .and_then([&](const std::string& page) { return write_file(file(path, recording), page); });
}

bool ReportPages::has(const std::string& path, const std::string& recording) const {
  std::error_code ignored;
  return !recording.empty() && fs::is_regular_file(file(path, recording), ignored);
}

std::string ReportPages::link(const std::string& path, const std::string& recording) const {
  return (fs::path(folder_).filename() / fs::path(file(path, recording)).filename()).string();
}

std::string ReportPages::file(const std::string& path, const std::string& recording) const {
  const std::string content = sha256(recording + (kind_ == Kind::Shared ? " shared" : " self-contained"));
  return (fs::path(folder_) / (plain_name(path) + "-" + content.substr(0, digits) + ".html")).string();
}

}  // namespace artcal
