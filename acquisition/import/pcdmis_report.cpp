#include "acquisition/import/pcdmis_report.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text/in_quotes.h"
#include "core/text/trimmed.h"

namespace artcal {
namespace {

std::vector<std::string> words_of_line(std::string_view line) {
  std::istringstream stream{std::string(line)};
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(std::move(word));
  }
  return words;
}

/// One location as far as it has been read.
struct Location {
  std::string feature;
  int line = 0;
  std::array<std::string, 3> measured;
};

class ReportReader {
 public:
  explicit ReportReader(const TextFile& file) : path_(file.path.string()), text_(file.text) {}

  Expected<ImportedReadings> read() {
    for (std::size_t begin = 0; begin < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      ++line_;
      if (auto taken = take(words_of_line(text_.substr(begin, end - begin))); !taken) {
        return tl::unexpected(taken.error());
      }
      begin = end + 1;
    }
    if (auto done = finish(); !done) {
      return tl::unexpected(done.error());
    }
    if (readings_.rows.empty()) {
      return bad_input("the report holds no LOCATION with X, Y and Z", path_);
    }
    readings_.format = "PC-DMIS report";
    readings_.columns = {"feature", "x", "y", "z"};
    readings_.length_unit = unit_;
    readings_.understood = {"feature = the name behind LOCATION OF …, x, y, z = the values under MEAS"};
    if (!passed_.empty()) {
      readings_.understood.push_back(fmt::format("passed over: {}", fmt::join(counted(passed_), ", ")));
    }
    return std::move(readings_);
  }

 private:
  [[nodiscard]] std::string where() const { return fmt::format("{}:{}", path_, line_); }

  static std::vector<std::string> counted(const std::map<std::string, int>& counts) {
    std::vector<std::string> texts;
    for (const auto& [what, count] : counts) {
      texts.push_back(fmt::format("{} x {}", count, truncated(20, what)));
    }
    texts.resize(std::min<std::size_t>(texts.size(), 12));
    return texts;
  }

  Expected<void> take(const std::vector<std::string>& words) {
    if (words.empty()) {
      return {};
    }
    if (words[0] == "DIM") {
      return finish().and_then([&] { return begin(words); });
    }
    if (words[0] == "END") {
      return finish();
    }
    if (!location_) {
      return {};
    }
    if (words[0] == "AX") {
      const auto found = std::find(words.begin(), words.end(), "MEAS");
      if (found == words.end()) {
        return bad_input("the heading of the table has no MEAS, expected the column of measured values", where());
      }
      measured_column_ = static_cast<std::size_t>(found - words.begin());
      return {};
    }
    const std::size_t axis = std::string_view("XYZ").find(words[0]);
    if (words[0].size() == 1 && axis != std::string_view::npos) {
      return take_axis(axis, words);
    }
    if (measured_column_ != 0 && words[0].size() <= 2) {
      ++passed_[words[0]];
    }
    return {};
  }

  // DIM LOC1= LOCATION OF CIRCLE CIR1 UNITS=MM ,$
  Expected<void> begin(const std::vector<std::string>& words) {
    const auto at = std::find(words.begin(), words.end(), "LOCATION");
    if (at == words.end()) {
      const auto what = std::find_if(words.begin(), words.end(), [](const auto& word) { return word.ends_with('='); });
      ++passed_[what == words.end() || what + 1 == words.end() ? "DIM" : *(what + 1)];
      return {};
    }
    if (words.end() - at < 4 || *(at + 1) != "OF") {
      return bad_input("expected LOCATION OF, the kind of the feature and its name", where());
    }
    location_ = Location{*(at + 3), line_, {}};
    measured_column_ = 0;
    for (const std::string& word : words) {
      if (word.starts_with("UNITS=")) {
        return take_unit(word.substr(6, word.find(',') - 6));
      }
    }
    return {};
  }

  Expected<void> take_unit(const std::string& word) {
    const std::string unit = word == "MM" ? "mm" : word == "IN" || word == "INCH" ? "in" : "";
    if (unit.empty()) {
      return bad_input(fmt::format("the unit is {}, expected MM or IN", in_quotes(word)), where());
    }
    if (!unit_.empty() && unit_ != unit) {
      return bad_input("the report states some locations in mm and some in inches, expected one unit", where());
    }
    unit_ = unit;
    return {};
  }

  Expected<void> take_axis(std::size_t axis, const std::vector<std::string>& words) {
    if (measured_column_ == 0) {
      return bad_input(
          fmt::format(
              "the value of {} stands above no heading AX … MEAS, and which number is the measured one is not known",
              words[0]),
          where());
    }
    const auto number =
        measured_column_ < words.size() ? number_text(words[measured_column_], comma_, point_) : std::nullopt;
    if (!number) {
      return bad_input(
          fmt::format("{} of {} is {} under MEAS, expected a number", words[0], in_quotes(location_->feature),
                      measured_column_ < words.size() ? in_quotes(words[measured_column_]) : "not there"),
          where());
    }
    if (comma_ && point_) {
      return bad_input("decimal commas and decimal points in one file", where());
    }
    if (!location_->measured[axis].empty()) {
      return bad_input(fmt::format("{} of {} is there twice", words[0], in_quotes(location_->feature)), where());
    }
    location_->measured[axis] = *number;
    return {};
  }

  Expected<void> finish() {
    if (!location_) {
      return {};
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (location_->measured[axis].empty()) {
        return bad_input(fmt::format("the location of {} has no {}, expected X, Y and Z", in_quotes(location_->feature),
                                     "XYZ"[axis]),
                         fmt::format("{}:{}", path_, location_->line));
      }
    }
    if (find_control(location_->feature)) {
      return bad_input("the feature's name has a control character", fmt::format("{}:{}", path_, location_->line));
    }
    readings_.rows.push_back(
        {location_->feature, location_->measured[0], location_->measured[1], location_->measured[2]});
    location_.reset();
    return {};
  }

  std::string path_;
  std::string_view text_;
  int line_ = 0;
  std::optional<Location> location_;
  std::size_t measured_column_ = 0;
  bool comma_ = false, point_ = false;
  std::string unit_;
  std::map<std::string, int> passed_;
  ImportedReadings readings_;
};

}  // namespace

bool is_pcdmis_report(const TextFile& file) {
  const std::string_view text = file.text;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trimmed(text.substr(begin, end - begin));
    if (line.starts_with("DIM ") && line.find(" LOCATION OF ") != std::string_view::npos) {
      return true;
    }
    begin = end + 1;
  }
  return false;
}

Expected<ImportedReadings> import_pcdmis_report(const TextFile& file) { return ReportReader(file).read(); }

}  // namespace artcal
