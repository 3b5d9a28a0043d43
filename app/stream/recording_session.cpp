#include "app/stream/recording_session.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/csv/csv.h"
#include "acquisition/csv/csv_text.h"
#include "app/stream/tip_check.h"
#include "artefacts/virtual_probing/postures.h"
#include "core/files/size_limits.h"
#include "core/text/in_quotes.h"
#include "core/text/trimmed.h"
#include "core/text/utf8.h"
#include "core/units.h"

namespace artcal {
namespace {

const std::string no_press = "no button was pressed anew";
const std::string known_reading = "known readings, which are in the table already";
constexpr double same_joint = 1e-9;  // rad or mm
constexpr double rest_time = 0.2;    // s
constexpr std::size_t min_compared = 4;
constexpr std::size_t max_compared = 64;
constexpr std::size_t times_said = 3;     // of one reason
constexpr std::size_t max_reasons = 20;   // told apart; what a broken device sends is endless
constexpr std::size_t max_mistakes = 10;  // repeated at the end

std::string reason_or_other(const std::map<std::string, std::size_t>& known, const std::string& reason) {
  return known.contains(reason) || known.size() < max_reasons ? reason : "other lines that are no events";
}

// A device may send anything, and one label that is no text would make the whole table unreadable.
bool is_name(std::string_view name) {
  return !name.empty() && name.size() <= largest::name && find_not_utf8(name) == std::string_view::npos &&
         !find_control(name);
}

bool is_near(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double within) {
  return a.size() == b.size() && (a - b).cwiseAbs().maxCoeff() <= within;
}

}  // namespace

RecordingSession::RecordingSession(Arm arm, int probe, const std::vector<Artefact>& artefacts, StreamFormat format,
                                   LabelSequence labels)
    : arm_(std::move(arm)),
      probe_(probe),
      format_(std::move(format)),
      labels_(std::move(labels)),
      artefacts_(artefacts),
      touches_(arm_, artefacts) {}

void RecordingSession::predict(SessionInformation before_any_reading, double goal) {
  information_ = before_any_reading;
  before_any_reading_ = std::move(before_any_reading);
  goal_ = goal;
}

// Folds a reading into what all determine, and says what that is.
std::string RecordingSession::count_information(const Touch& touch, const Eigen::VectorXd& joints) {
  const auto artefact = std::find_if(artefacts_.begin(), artefacts_.end(),
                                     [&](const Artefact& known) { return known.name == touch.artefact; });
  if (!information_ || artefact == artefacts_.end()) {
    return "";
  }
  counted_.push_back({static_cast<int>(artefact - artefacts_.begin()), artefact->feature_index(touch.feature),
                      touch.placement, touch.probe, joints});
  information_->add(counted_.back());
  const double u = information_->u_of_length().mean;
  return fmt::format("rank {} of {}, u of a length {}{}", information_->rank(), information_->parameters(),
                     u < 1.0 ? fmt::format("{:.3g} µm", u / units::micrometre) : "above 1 mm",
                     goal_ > 0.0 ? fmt::format(", goal {:.3g} µm", goal_ / units::micrometre) : "");
}

std::string RecordingSession::header() const {
  std::string header = fmt::format("{}", fmt::join(labels_.columns(), ","));
  for (std::size_t j = 1; j <= format_.joints.size(); ++j) {
    header += fmt::format(",q{}", j);
  }
  return header + (format_.temperature.empty() ? "" : ",arm_temperature") + (format_.xyz.empty() ? "" : ",x,y,z");
}

Expected<void> RecordingSession::resume(const std::vector<std::string>& rows) {
  const TextFile table{"readings.csv", fmt::format("{}\n{}\n", header(), fmt::join(rows, "\n")), ""};
  auto csv = CsvReader::open(table);
  if (!csv) {
    return tl::unexpected(csv.error());
  }
  const std::size_t labels = labels_.columns().size();
  for (const std::string& row : rows) {
    const auto read = csv->next();
    if (!read || !*read) {
      return read ? bad_input("the table has blank or commented rows; take them out, or record into another folder")
                  : Expected<void>(tl::unexpected(read.error()));
    }
    ReadingLabel label;
    for (std::size_t i = 0; i < labels; ++i) {
      label.emplace_back(without_guard(csv->field(i)));
    }
    Eigen::VectorXd joints(static_cast<Eigen::Index>(arm_.joints.size()));
    std::size_t values = 0;
    for (std::size_t i = labels; i < csv->header().size(); ++i) {
      const auto number = csv->number(i, "a number");
      if (!number) {
        return tl::unexpected(number.error());
      }
      values += csv->field(i).size() + 1;
      if (i - labels < arm_.joints.size()) {
        joints[static_cast<Eigen::Index>(i - labels)] =
            *number * (arm_.joints[i - labels].is_prismatic() ? 1.0 : units::degree);
      }
    }
    if (!labels_.take_known(label)) {
      return bad_input(
          "the plan does not have this reading after those before it; take the plan that the recording "
          "was begun with, or record into another folder",
          csv->where(0));
    }
    const Touch touch = touch_of(label, joints);
    (void)touches_.add(touch);
    (void)count_information(touch, joints);
    last_ = joints;
    on_disk_.insert(row.substr(row.size() - std::min(row.size(), values)));
  }
  return {};
}

RecordingSession::Step RecordingSession::pass_over(const std::string& reason, bool is_said) {
  const std::size_t count = ++passed_over_[reason];
  Step step;
  if (is_said && count <= times_said) {
    step.message = fmt::format("passed over: {}{}", reason, count == times_said ? " (not said again)" : "");
  }
  return step;
}

RecordingSession::Step RecordingSession::too_long() {
  return pass_over(fmt::format("a line of more than {} bytes", max_event_bytes), true);
}

RecordingSession::Step RecordingSession::cut_off(std::string_view line) {
  // A JSON object that is cut off is none; a number that is cut off is another number.
  return format_.is_json || line.starts_with('!')
             ? feed(line)
             : pass_over("the last line, which has no line end: it may be cut off", true);
}

RecordingSession::Step RecordingSession::feed(std::string_view line, std::optional<double> arrival) {
  if (line.starts_with('!')) {
    return operate(line.substr(1));
  }
  const auto event = parse_event(line, format_);
  if (!event) {
    return pass_over(reason_or_other(passed_over_, event.error().message), true);
  }
  if (!*event) {
    return pass_over("lines that are no events", false);
  }
  const std::optional<double> time = (*event)->time ? (*event)->time : arrival;
  const std::string reason = reason_against(**event, time);
  if (reason == known_reading) {
    last_ = (*event)->joints;  // as when it was taken
    last_time_ = time;
  }
  if (!reason.empty()) {
    return pass_over(reason, reason != known_reading && reason != no_press);
  }
  if (labels_.has_ended()) {
    return pass_over("the plan has ended", true);
  }
  last_time_ = time;
  return take(**event);
}

std::string RecordingSession::reason_against(const StreamEvent& event, std::optional<double> time) {
  const bool is_moving = format_.at_rest_within > 0.0 && moves(event, time);
  const bool is_new_press = event.pressed && (format_.button.empty() || !was_pressed_);
  was_pressed_ = event.pressed;
  if (!is_new_press) {
    return no_press;
  }
  if (!event.referenced) {
    return "an encoder is not referenced";
  }
  if (!event.off_end_stops) {
    return "a joint is at its end stop";
  }
  if (!event.at_rest || is_moving) {
    return "the arm is not at rest";
  }
  if (is_near(last_, event.joints, std::max(same_joint, format_.at_rest_within))) {
    return "the arm stands where it stood at the last reading";
  }
  if (on_disk_.contains(values_of(event))) {
    return known_reading;
  }
  if (last_time_ && time && *time >= *last_time_ && *time - *last_time_ < 1.0 / format_.max_rate) {
    return fmt::format("thinned: more than {:g} readings a second (max_rate of the stream's file)", format_.max_rate);
  }
  return "";
}

bool RecordingSession::moves(const StreamEvent& event, std::optional<double> time) {
  if (!is_near(rests_at_, event.joints, format_.at_rest_within)) {
    rests_at_ = event.joints;
    rests_since_ = time;
    return true;
  }
  return time && rests_since_ && *time - *rests_since_ < rest_time;
}

RecordingSession::Step RecordingSession::operate(std::string_view words) {
  words = trimmed(words);
  const auto blank = std::min(words.find(' '), words.size());
  const std::string_view word = words.substr(0, blank);
  const std::string_view name = trimmed(words.substr(blank));
  Step step;
  const auto say_label = [&](bool done, const std::string& otherwise) {
    step.message = done && !labels_.has_ended() ? fmt::format("next reading: {} {} {}", labels_.current()[0],
                                                              labels_.current()[1], labels_.current()[2])
                                                : otherwise;
  };
  if (words == "next feature") {
    say_label(labels_.next_feature(), "there is no next feature");
  } else if (words == "next placement") {
    say_label(labels_.next_placement(), "there is no next placement");
  } else if (words == "undo") {
    step.removes_last = labels_.undo();
    if (step.removes_last) {
      touches_.undo();
      information_ = before_any_reading_;
      if (!counted_.empty()) {
        counted_.pop_back();
      }
      for (const SessionReading& reading : counted_) {
        information_->add(reading);
      }
      last_.resize(0);
    }
    say_label(step.removes_last, "there is no reading to take back");
  } else if ((word == "artefact" || word == "placement" || word == "feature") && is_name(name)) {
    const std::size_t column = word == "artefact" ? 0 : word == "placement" ? 1 : 2;
    if (!labels_.name(column, name)) {
      step.message = fmt::format("no {} of the readings to come is called {}", word, in_quotes(name));
    }
  } else {
    step = pass_over(
        "lines with ! that are not understood, expected !next feature, !next placement, !artefact NAME, "
        "!placement NAME, !feature NAME or !undo",
        true);
  }
  return step;
}

std::string RecordingSession::values_of(const StreamEvent& event) const {
  std::string values;
  for (std::size_t j = 0; j < arm_.joints.size(); ++j) {
    values += fmt::format(
        ",{:.12f}", event.joints[static_cast<Eigen::Index>(j)] / (arm_.joints[j].is_prismatic() ? 1.0 : units::degree));
  }
  if (event.temperature) {
    values += fmt::format(",{:.4f}", *event.temperature);
  }
  if (event.tip_in_base) {
    const Eigen::Vector3d& tip = *event.tip_in_base;
    values += fmt::format(",{:.9f},{:.9f},{:.9f}", tip.x(), tip.y(), tip.z());
  }
  return values;
}

Touch RecordingSession::touch_of(const ReadingLabel& label, const Eigen::VectorXd& joints) const {
  const auto& columns = labels_.columns();
  const auto column = static_cast<std::size_t>(std::find(columns.begin(), columns.end(), "probe") - columns.begin());
  const int named = column < label.size() && !label[column].empty() ? probe_index(arm_, label[column]) : probe_;
  const int probe = named < 0 ? probe_ : named;
  return {label[0], label[1], label[2], probe, tip_at(arm_, probe, joints)};
}

RecordingSession::Step RecordingSession::take(const StreamEvent& event) {
  const ReadingLabel label = labels_.current();
  Step step;
  for (const std::string& field : label) {
    step.row += (step.row.empty() ? "" : ",") + csv_field(field);
  }
  step.row += values_of(event);
  step.label = fmt::format("{} {} {}", label[0], label[1], label[2]);
  const Touch touch = touch_of(label, event.joints);
  const TouchCheck::Said said = touches_.add(touch);
  const std::string information = count_information(touch, event.joints);
  step.note = said.note + (said.note.empty() || information.empty() ? "" : "; ") + information;
  const std::size_t before = mistakes_.size();
  if (!said.warning.empty()) {
    mistakes_.push_back(step.label + ": " + said.warning);
  }
  compare_tips(event);
  for (std::size_t i = before; i < mistakes_.size(); ++i) {
    step.message += (step.message.empty() ? "" : "\n") + mistakes_[i];
  }
  mistakes_.resize(std::min(mistakes_.size(), max_mistakes));
  labels_.take();
  last_ = event.joints;
  return step;
}

void RecordingSession::compare_tips(const StreamEvent& event) {
  if (!event.tip_in_base || compared_.size() >= max_compared) {
    return;
  }
  compared_.push_back(event);
  if (compared_.size() < min_compared || !std::has_single_bit(compared_.size())) {
    return;
  }
  if (std::string said = check_tips(arm_, probe_, compared_); !said.empty()) {
    mistakes_.push_back(std::move(said));
    compared_.resize(max_compared);  // once is enough
  }
}

}  // namespace artcal
