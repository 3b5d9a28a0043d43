#include "acquisition/import/dmis_file.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/import/dmis_statement.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using DmisRow = std::vector<std::string>;  // name, x, y, z

/// A reading with what held where it stands.
struct DmisReading {
  DmisRow row;
  std::size_t changes = 0;  // of the coordinate system before it
  std::string compensation;
};

struct FrameChange {
  int line = 0;
  std::string word;
};

/// MEAS … ENDMES.
struct DmisMeasurement {
  std::string feature, kind;
  int line = 0;
  std::size_t promised = 0, found = 0;
};

double dmis_number(const std::string& number) { return std::strtod(number.c_str(), nullptr); }

Eigen::Vector3d dmis_vector(const std::vector<std::string>& numbers, std::size_t first) {
  return {dmis_number(numbers[first]), dmis_number(numbers[first + 1]), dmis_number(numbers[first + 2])};
}

class DmisReader {
 public:
  DmisReader(const TextFile& file, bool points_are_measured)
      : path_(file.path.string()), text_(file.text), takes_points_(points_are_measured) {}

  Expected<ImportedReadings> read() {
    for (const DmisStatement& statement : dmis_statements(text_)) {
      line_ = statement.line;
      if (auto taken = take(statement); !taken) {
        return tl::unexpected(taken.error());
      }
    }
    return finish_measurement().and_then([&] { return result(); });
  }

 private:
  [[nodiscard]] std::string where(int line) const { return fmt::format("{}:{}", path_, line); }
  [[nodiscard]] std::string where() const { return where(line_); }

  Expected<void> take(const DmisStatement& s) {
    const std::string first = s.fields.empty() ? "" : s.fields.front();
    if (s.major == "UNITS") {
      return take_unit(first);
    }
    if (s.major == "PRCOMP") {
      compensation_ = first;
      return {};
    }
    if (is_change(s)) {
      changes_.push_back({s.line, s.major});
      return {};
    }
    if (s.major == "FEAT" && (s.label_kind == "FA" || s.label_kind == "F")) {
      return take_feature(s);
    }
    if (s.major == "MEAS" || s.major == "RMEAS") {
      return finish_measurement().and_then([&] { return begin_measurement(s); });
    }
    if (s.major == "PTMEAS") {
      return take_point(s);
    }
    return s.major == "ENDMES" ? finish_measurement() : Expected<void>{};
  }

  // What moves the coordinate system in which the next coordinates are stated.
  static bool is_change(const DmisStatement& s) {
    static constexpr std::array words{"DATSET", "ROTATE", "TRANS", "LOCATE"};
    const bool is_word = std::find(words.begin(), words.end(), s.major) != words.end();
    const auto is_datum = [](const std::string& field) {
      return !name_in(field, "D").empty() || !name_in(field, "DA").empty();
    };
    return is_word || (s.major == "RECALL" && std::any_of(s.fields.begin(), s.fields.end(), is_datum));
  }

  Expected<void> take_unit(const std::string& word) {
    static const std::map<std::string, std::string> known{{"MM", "mm"}, {"M", "m"}, {"INCH", "in"}};
    const auto found = known.find(word);
    if (found == known.end()) {
      return bad_input(fmt::format("the unit of lengths is {}, expected MM, M or INCH", in_quotes(word)), where());
    }
    if (!unit_.empty() && unit_ != found->second) {
      return bad_input("UNITS states another unit than before, expected one unit of lengths in a file", where());
    }
    unit_ = found->second;
    return {};
  }

  // The numbers behind CART, digits as they stand; at least three.
  Expected<std::vector<std::string>> numbers_of(const DmisStatement& s, const std::string& name) {
    const auto cart = std::find(s.fields.begin(), s.fields.end(), "CART");
    if (cart == s.fields.end()) {
      const bool polar = std::find(s.fields.begin(), s.fields.end(), "POL") != s.fields.end();
      return bad_input(fmt::format("{} {} has {}, expected CART and x, y, z", s.major, in_quotes(name),
                                   polar ? "polar coordinates (POL), which are not read" : "no CART"),
                       where());
    }
    std::vector<std::string> numbers;
    for (auto field = cart + 1; field != s.fields.end(); ++field) {
      bool comma = false, point = false;
      const auto number = number_text(*field, comma, point);
      if (!number && numbers.size() < 3) {
        return bad_input(
            fmt::format("{} of {} is {}, expected a number", "xyz"[numbers.size()], in_quotes(name), in_quotes(*field)),
            where());
      }
      if (!number) {
        break;
      }
      numbers.push_back(*number);
    }
    if (numbers.size() < 3) {
      return bad_input(
          fmt::format("{} has {} numbers behind CART, expected x, y and z", in_quotes(name), numbers.size()), where());
    }
    return numbers;
  }

  Expected<void> take_feature(const DmisStatement& s) {
    const std::string kind = s.fields.empty() ? "" : s.fields.front();
    const bool is_actual = s.label_kind == "FA";
    nominal_ += is_actual ? 0 : 1;
    const bool has_place = kind == "POINT" || kind == "EDGEPT" || kind == "SPHERE" || kind == "CIRCLE";
    if (!(is_actual ? has_place || kind == "CYLNDR" : kind == "POINT")) {
      if (is_actual) {
        ++passed_[kind];
      }
      return {};
    }
    auto numbers = numbers_of(s, s.label);
    if (!numbers) {
      // A program may state a nominal place by an expression.
      return is_actual ? Expected<void>(tl::unexpected(numbers.error())) : Expected<void>{};
    }
    if (!is_actual) {
      nominal_places_[s.label] = dmis_vector(*numbers, 0);
      return {};
    }
    report(kind, s.label, *numbers);
    if (!has_place) {
      ++passed_[kind];
      return {};
    }
    return add(features_, s.label, *numbers);
  }

  // SPHERE: x, y, z, diameter. CIRCLE and CYLNDR: x, y, z, i, j, k, diameter.
  void report(const std::string& kind, const std::string& name, const std::vector<std::string>& numbers) {
    using Kind = ReportedFeature::Kind;
    if (kind == "SPHERE" && numbers.size() >= 4) {
      reported_.push_back(
          {name, Kind::Sphere, dmis_vector(numbers, 0), Eigen::Vector3d::Zero(), dmis_number(numbers[3])});
    }
    if ((kind == "CIRCLE" || kind == "CYLNDR") && numbers.size() >= 7) {
      reported_.push_back({name, kind == "CIRCLE" ? Kind::Circle : Kind::Cylinder, dmis_vector(numbers, 0),
                           dmis_vector(numbers, 3), dmis_number(numbers[6])});
    }
  }

  Expected<void> add(std::vector<DmisReading>& readings, const std::string& name,
                     const std::vector<std::string>& numbers) {
    if (name.empty() || find_control(name)) {
      return bad_input("the feature's name is empty or has a control character", where());
    }
    readings.push_back({{name, numbers[0], numbers[1], numbers[2]}, changes_.size(), compensation_});
    return {};
  }

  Expected<void> begin_measurement(const DmisStatement& s) {
    DmisMeasurement measurement;
    measurement.line = s.line;
    measurement.kind = s.fields.empty() ? "" : s.fields.front();
    for (std::size_t i = 0; i < s.fields.size() && measurement.feature.empty(); ++i) {
      measurement.feature = name_in(s.fields[i], "F");
      if (!measurement.feature.empty() && i + 1 < s.fields.size()) {
        const std::string& count = s.fields[i + 1];
        const bool is_count =
            !count.empty() && count.size() < 10 && count.find_first_not_of("0123456789") == std::string::npos;
        measurement.promised = is_count ? std::stoul(count) : 0;
      }
    }
    if (measurement.feature.empty()) {
      return bad_input("MEAS names no feature, expected MEAS/kind,F(name),n", where());
    }
    measurement_ = std::move(measurement);
    return {};
  }

  Expected<void> take_point(const DmisStatement& s) {
    if (!measurement_) {
      return bad_input("PTMEAS stands outside MEAS and ENDMES, and which feature it measures is not known", where());
    }
    ++measurement_->found;
    if (!takes_points_) {
      ++passed_["PTMEAS"];
      return {};
    }
    auto numbers = numbers_of(s, measurement_->feature);
    if (!numbers) {
      return tl::unexpected(numbers.error());
    }
    const auto nominal = nominal_places_.find(measurement_->feature);
    if (measurement_->kind == "POINT" && nominal != nominal_places_.end()) {
      (nominal->second == dmis_vector(*numbers, 0) ? equal_nominal_ : off_nominal_) += 1;
    }
    return add(points_, measurement_->feature, *numbers);
  }

  Expected<void> finish_measurement() {
    if (!measurement_) {
      return {};
    }
    const DmisMeasurement done = std::move(*measurement_);
    measurement_.reset();
    if (done.found > 0 && done.promised > 0 && done.found != done.promised) {
      return bad_input(fmt::format("MEAS of {} states {} points, {} PTMEAS follow", in_quotes(done.feature),
                                   done.promised, done.found),
                       where(done.line));
    }
    return {};
  }

  [[nodiscard]] Expected<void> check_one_frame(const std::vector<DmisReading>& readings) const {
    for (const DmisReading& each : readings) {
      if (each.changes != readings.front().changes) {
        const FrameChange& change = changes_[each.changes - 1];
        return bad_input(
            fmt::format("{} changes the coordinate system between {} and {}, whose coordinates then do not belong "
                        "together; export the features in one coordinate system",
                        change.word, in_quotes(readings.front().row.front()), in_quotes(each.row.front())),
            where(change.line));
      }
      if (each.compensation != readings.front().compensation) {
        return bad_input(
            fmt::format("PRCOMP changes between {} and {}: some coordinates are compensated for the tip, some are not",
                        in_quotes(readings.front().row.front()), in_quotes(each.row.front())),
            path_);
      }
    }
    return {};
  }

  Expected<ImportedReadings> result() {
    const std::vector<DmisReading>& readings = takes_points_ ? points_ : features_;
    if (readings.empty()) {
      return nothing_measured();
    }
    if (takes_points_ && equal_nominal_ > 0 && off_nominal_ == 0) {
      return bad_input(
          fmt::format(
              "the PTMEAS of all {} points are their nominal features F(…) digit by digit: they are the targets "
              "of a program, not measured points",
              equal_nominal_),
          path_);
    }
    if (auto one = check_one_frame(readings); !one) {
      return tl::unexpected(one.error());
    }
    ImportedReadings imported;
    imported.format = "DMIS";
    imported.columns = {"feature", "x", "y", "z"};
    for (const DmisReading& each : readings) {
      imported.rows.push_back(each.row);
    }
    imported.length_unit = unit_;
    imported.understood = {
        takes_points_ ? "feature = the name in MEAS, x, y, z = PTMEAS, taken as measured as --measured-points says"
                      : "feature = the name in FA(…), x, y, z = the place of POINT, EDGEPT, SPHERE and CIRCLE"};
    if (takes_points_) {
      imported.reported = std::move(reported_);
    }
    const std::string& compensation = readings.front().compensation;
    if (takes_points_ && compensation == "ON") {
      imported.probe_radius = "0";
      imported.understood.emplace_back("PRCOMP/ON: the points are compensated for the tip, whose radius is 0 then");
    } else if (compensation == "OFF") {
      imported.understood.emplace_back("PRCOMP/OFF: points are centres of the tip");
    }
    if (const std::string passed = passed_text(); !passed.empty()) {
      imported.understood.push_back(fmt::format("passed over: {}", passed));
    }
    return imported;
  }

  [[nodiscard]] std::string passed_text() const {
    std::vector<std::string> texts;
    for (const auto& [what, count] : passed_) {
      texts.push_back(fmt::format("{} x {}", count, truncated(20, what)));
    }
    if (nominal_ > 0) {
      texts.push_back(fmt::format("{} nominal features F(…)", nominal_));
    }
    texts.resize(std::min<std::size_t>(texts.size(), 12));
    return fmt::format("{}", fmt::join(texts, ", "));
  }

  [[nodiscard]] tl::unexpected<Error> nothing_measured() const {
    if (takes_points_) {
      return bad_input("the file has no PTMEAS between MEAS and ENDMES", path_);
    }
    const auto points = passed_.find("PTMEAS");
    return bad_input(
        points == passed_.end()
            ? fmt::format("the file has {} nominal features F(…) and no actual one FA(…) with a place (POINT, EDGEPT, "
                          "SPHERE, CIRCLE), which a file of results has",
                          nominal_)
            : fmt::format("the file has no actual feature FA(…), and its {} PTMEAS may be the targets of a program; if "
                          "they are measured points, say so with --measured-points",
                          points->second),
        path_);
  }

  std::string path_;
  std::string_view text_;
  bool takes_points_;
  int line_ = 0;
  std::string unit_, compensation_;
  std::vector<FrameChange> changes_;
  std::optional<DmisMeasurement> measurement_;
  std::vector<DmisReading> features_, points_;
  std::vector<ReportedFeature> reported_;
  std::map<std::string, Eigen::Vector3d> nominal_places_;
  std::map<std::string, int> passed_;
  int nominal_ = 0, equal_nominal_ = 0, off_nominal_ = 0;
};

}  // namespace

bool is_dmis_file(const TextFile& file) {
  const auto statements = dmis_statements(file.text);
  return std::any_of(statements.begin(), statements.end(), [](const DmisStatement& s) {
    return s.major == "DMISMN" || s.major == "DMISMD" || s.major == "PTMEAS" ||
           (s.major == "FEAT" && !s.label_kind.empty());
  });
}

Expected<ImportedReadings> import_dmis(const TextFile& file, bool points_are_measured) {
  return DmisReader(file, points_are_measured).read();
}

}  // namespace artcal
