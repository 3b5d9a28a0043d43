#include "app/stream/recording_session.h"

#include <fmt/format.h>

#include "acquisition/csv/csv_text.h"
#include "app/stream/tip_check.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr double same_angle = 1e-9;  // rad
constexpr std::size_t readings_compared = 4;
constexpr std::size_t times_said = 3;  // of one reason

}  // namespace

RecordingSession::RecordingSession(Arm arm, StreamFormat format, std::vector<ReadingLabel> plan,
                                   const std::vector<std::string>& rows)
    : arm_(std::move(arm)), format_(std::move(format)), plan_(std::move(plan)), taken_(rows.size()) {
  const std::size_t values =
      format_.joints.size() + format_.xyz.size() + static_cast<std::size_t>(format_.temperature.empty() ? 0 : 1);
  for (const std::string& row : rows) {
    std::size_t at = row.size();
    for (std::size_t i = 0; i < values && at != std::string::npos; ++i) {
      at = at == 0 ? std::string::npos : row.rfind(',', at - 1);
    }
    on_disk_.insert(at == std::string::npos ? row : row.substr(at));
  }
}

const ReadingLabel& RecordingSession::label() const {
  static const ReadingLabel none{"", "1", "1"};
  if (by_hand_) {
    return *by_hand_;
  }
  return plan_.empty() ? none : plan_[std::min(taken_, plan_.size() - 1)];
}

void RecordingSession::next_feature(const std::string& feature) {
  by_hand_ = label();
  by_hand_->feature = feature;
}

void RecordingSession::next_placement(const std::string& placement) {
  by_hand_ = label();
  by_hand_->placement = placement;
}

bool RecordingSession::undo() {
  last_.resize(0);
  return taken_ > 0 && (--taken_, true);
}

std::string RecordingSession::header() const {
  std::string header = "artefact,placement,feature";
  for (std::size_t j = 1; j <= format_.joints.size(); ++j) {
    header += fmt::format(",q{}", j);
  }
  return header + (format_.temperature.empty() ? "" : ",arm_temperature") + (format_.xyz.empty() ? "" : ",x,y,z");
}

RecordingSession::Step RecordingSession::pass_over(const std::string& reason, bool say) {
  const std::size_t count = ++passed_over_[reason];
  return {"", say && count <= times_said
                  ? fmt::format("passed over: {}{}", reason, count == times_said ? " (not said again)" : "")
                  : ""};
}

RecordingSession::Step RecordingSession::too_long() {
  return pass_over(fmt::format("a line of more than {} bytes", max_event_bytes), true);
}

RecordingSession::Step RecordingSession::feed(std::string_view line) {
  const auto event = parse_event(line, format_);
  if (!event) {
    const std::string& reason = event.error().message;
    return pass_over(
        passed_over_.contains(reason) || passed_over_.size() < 20 ? reason : "other lines that are no events", true);
  }
  if (!*event) {
    return pass_over("a line that is no event", false);
  }
  const StreamEvent& at = **event;
  const bool is_new_press = at.pressed && (format_.button.empty() || !was_pressed_);
  was_pressed_ = at.pressed;
  if (!is_new_press) {
    return pass_over("no button was pressed anew", false);
  }
  if (static_cast<std::size_t>(at.joints.size()) != arm_.joints.size()) {
    return pass_over(fmt::format("{} joint angles, the arm has {} joints", at.joints.size(), arm_.joints.size()), true);
  }
  if (!at.referenced) {
    return pass_over("an encoder is not referenced", true);
  }
  if (!at.off_end_stops) {
    return pass_over("a joint is at its end stop", true);
  }
  if (!at.at_rest) {
    return pass_over("the arm is not at rest", true);
  }
  if (last_.size() == at.joints.size() && (last_ - at.joints).cwiseAbs().maxCoeff() <= same_angle) {
    return pass_over("the arm stands where it stood at the last reading", true);
  }
  if (on_disk_.contains(values_of(at))) {
    return pass_over("the reading is in the table already", false);
  }
  return take(at);
}

std::string RecordingSession::values_of(const StreamEvent& event) const {
  std::string values;
  for (const double q : event.joints) {
    values += fmt::format(",{:.12f}", q / units::degree);
  }
  if (event.temperature) {
    values += fmt::format(",{:.4f}", *event.temperature);
  }
  if (event.tip_in_base) {
    values +=
        fmt::format(",{:.9f},{:.9f},{:.9f}", event.tip_in_base->x(), event.tip_in_base->y(), event.tip_in_base->z());
  }
  return values;
}

RecordingSession::Step RecordingSession::take(const StreamEvent& event) {
  const ReadingLabel& by = label();
  Step step{fmt::format("{},{},{}", csv_field(by.artefact), csv_field(by.placement), csv_field(by.feature)), ""};
  step.row += values_of(event);
  step.message = compare(event);
  last_ = event.joints;
  ++taken_;
  return step;
}

std::string RecordingSession::compare(const StreamEvent& event) {
  if (!event.tip_in_base || first_.size() >= readings_compared) {
    return "";
  }
  first_.push_back(event);
  return first_.size() == readings_compared ? check_tips(arm_, first_) : "";
}

}  // namespace artcal
