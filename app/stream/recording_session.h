#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "acquisition/arm/arm.h"
#include "app/stream/stream_event.h"

namespace artcal {

/// What a reading is of.
struct ReadingLabel {
  std::string artefact, placement, feature;
  [[nodiscard]] bool operator==(const ReadingLabel&) const = default;
};

/// Events of an arm, one after the other, and the readings that they become. Knows no terminal, network or file: who
/// holds a session feeds it lines and writes down the rows that it gives back.
class RecordingSession {
 public:
  /// `plan`: the label of each reading in order; where it ends, readings go on under the last label, or under the one
  /// that next_feature() and next_placement() set. `rows`: those that are on disk already; an event that is one of them
  /// is passed over, so that a file of events that is read again from its beginning goes on where it was.
  RecordingSession(Arm arm, StreamFormat format, std::vector<ReadingLabel> plan,
                   const std::vector<std::string>& rows = {});

  /// What became of a line.
  struct Step {
    std::string row;      ///< of readings.csv, without its end; empty: the line is no reading
    std::string message;  ///< for a person; empty: nothing to say
  };
  Step feed(std::string_view line);
  /// A line that was too long to be kept.
  Step too_long();

  void next_feature(const std::string& feature);
  void next_placement(const std::string& placement);
  /// The last reading is to be taken again; false where there is none.
  bool undo();

  /// "artefact,placement,feature,q1,…", angles in deg; x, y, z where the stream has them.
  [[nodiscard]] std::string header() const;
  [[nodiscard]] std::size_t readings() const { return taken_; }
  [[nodiscard]] bool plan_is_done() const { return !plan_.empty() && taken_ >= plan_.size(); }
  [[nodiscard]] const ReadingLabel& label() const;
  /// Events that became no reading, by reason.
  [[nodiscard]] const std::map<std::string, std::size_t>& passed_over() const { return passed_over_; }

 private:
  [[nodiscard]] std::string values_of(const StreamEvent& event) const;
  Step pass_over(const std::string& reason, bool say);
  Step take(const StreamEvent& event);
  std::string compare(const StreamEvent& event);

  Arm arm_;
  StreamFormat format_;
  std::vector<ReadingLabel> plan_;
  std::optional<ReadingLabel> by_hand_;
  std::size_t taken_;
  std::set<std::string, std::less<>> on_disk_;  // what was measured, without labels
  std::map<std::string, std::size_t> passed_over_;
  bool was_pressed_ = false;
  Eigen::VectorXd last_;
  std::vector<StreamEvent> first_;  // the first readings with coordinates, until both were compared
};

}  // namespace artcal
