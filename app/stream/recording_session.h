#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "acquisition/arm/arm.h"
#include "app/stream/label_sequence.h"
#include "app/stream/stream_event.h"
#include "app/stream/touch_check.h"
#include "identification/planning/session_information.h"

namespace artcal {

/// Events of an arm, one after the other, and the readings that they become. Knows no terminal, network or file: who
/// holds a session feeds it lines and writes down the rows that it gives back.
class RecordingSession {
 public:
  /// `format` is that of the arm (for_arm()). `probe` is into Arm::probes, for labels without a probe.
  RecordingSession(Arm arm, int probe, const std::vector<Artefact>& artefacts, StreamFormat format,
                   LabelSequence labels);

  /// "artefact,placement,feature,q1,…", angles in deg, prismatic joints in mm; x, y, z in mm where the stream has them.
  [[nodiscard]] std::string header() const;
  /// From now on the note of each reading has what all readings determine: "u of a length 34 µm, goal 20 µm". To be
  /// called before resume(). `goal` in mm; none where it is not positive.
  void predict(SessionInformation before_any_reading, double goal);
  /// Goes on after these rows of an earlier run. An event that is one of them is passed over, so that a file of events
  /// that is read again from its beginning goes on where it was. Refused: rows that are none of this session, labels
  /// that the plan does not have in this order.
  Expected<void> resume(const std::vector<std::string>& rows);

  /// What became of a line.
  struct Step {
    std::string row = {};       ///< to be appended, without its end; empty: the line is no reading
    bool removes_last = false;  ///< the last row is to be taken away
    std::string label = {};     ///< of the row: "bar 1 A"
    std::string note = {};      ///< what is known of the reading; may be empty
    std::string message = {};   ///< for a person; empty: nothing to say
  };
  /// `arrival` is when the line came, s, by any clock; nothing where that says nothing (a file). A line that begins
  /// with ! is a person's: !next feature, !next placement, !artefact NAME, !placement NAME, !feature NAME, !undo.
  Step feed(std::string_view line, std::optional<double> arrival = {});
  /// A line that was too long to be kept.
  Step too_long();
  /// A last line without a line end.
  Step cut_off(std::string_view line);
  /// A person's words, without the !.
  Step operate(std::string_view words);

  [[nodiscard]] const LabelSequence& labels() const { return labels_; }
  /// Events that became no reading, by reason.
  [[nodiscard]] const std::map<std::string, std::size_t>& passed_over() const { return passed_over_; }
  /// What cannot be the arm's error: said at once, and again at the end.
  [[nodiscard]] const std::vector<std::string>& mistakes() const { return mistakes_; }

 private:
  [[nodiscard]] std::string values_of(const StreamEvent& event) const;
  [[nodiscard]] std::string reason_against(const StreamEvent& event, std::optional<double> time);
  [[nodiscard]] bool moves(const StreamEvent& event, std::optional<double> time);
  Step pass_over(const std::string& reason, bool is_said);
  Step take(const StreamEvent& event);
  void compare_tips(const StreamEvent& event);
  [[nodiscard]] std::string count_information(const Touch& touch, const Eigen::VectorXd& joints);
  [[nodiscard]] Touch touch_of(const ReadingLabel& label, const Eigen::VectorXd& joints) const;

  Arm arm_;
  int probe_;
  StreamFormat format_;
  LabelSequence labels_;
  std::vector<Artefact> artefacts_;
  TouchCheck touches_;
  std::optional<SessionInformation> before_any_reading_, information_;
  std::vector<SessionReading> counted_;  // for undo
  double goal_ = 0.0;
  std::set<std::string, std::less<>> on_disk_;  // what was measured, without labels
  std::map<std::string, std::size_t> passed_over_;
  std::vector<std::string> mistakes_;
  bool was_pressed_ = false;
  Eigen::VectorXd last_;      // joints of the last reading
  Eigen::VectorXd rests_at_;  // joints since when none moved, at_rest_within
  std::optional<double> rests_since_, last_time_;
  std::vector<StreamEvent> compared_;  // readings with coordinates, until enough were compared
};

}  // namespace artcal
