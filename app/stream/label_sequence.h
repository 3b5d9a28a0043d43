#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "artefacts/artefact/artefact.h"
#include "core/error.h"

namespace artcal {

/// What a reading is of: a field for each of LabelSequence::columns(), the first three of them artefact, placement and
/// feature.
using ReadingLabel = std::vector<std::string>;

/// The order in which features are read: that of a plan, or the artefacts' own under a person's hand.
class LabelSequence {
 public:
  /// By hand: the features of the artefacts in their order, placements counted from 1. `more` are columns and the one
  /// value that they have for all readings (the probe's name, a temperature).
  using Constants = std::vector<std::pair<std::string, std::string>>;
  LabelSequence(const std::vector<Artefact>& artefacts, const Constants& constants);

  /// Takes the labels of a table (columns artefact, placement, feature, orientation, repeat, probe; others are not
  /// looked at) for those of the readings to come. Refused: no column of a feature or placement, a feature that the
  /// artefacts do not have.
  Expected<void> follow(const std::filesystem::path& plan);

  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  [[nodiscard]] bool has_ended() const { return is_planned_ && position_ >= plan_.size(); }
  /// REQUIRES: !has_ended().
  [[nodiscard]] const ReadingLabel& current() const { return is_planned_ ? plan_[position_] : by_hand_; }

  /// A reading was taken under the current label.
  void take();
  /// A reading with this label is there from an earlier run; false where the plan has no such reading any more.
  bool take_known(const ReadingLabel& label);
  /// The last reading is to be taken again; false where there is none.
  bool undo();

  /// Goes on to the next feature or placement; with a plan, to the reading where one is planned. False: there is none.
  bool next_feature();
  bool next_placement();
  /// Names the artefact, placement or feature (columns 0 to 2) of what follows. False: nothing has that name.
  bool name(std::size_t column, std::string_view text);

 private:
  [[nodiscard]] bool is_known(std::string_view artefact, std::string_view feature) const;
  template <typename Condition>
  bool skip_to(const Condition& condition);

  std::vector<std::string> columns_{"artefact", "placement", "feature"};
  std::vector<std::pair<std::string, std::string>> features_;  // artefact and feature, in the artefacts' order
  ReadingLabel by_hand_;
  bool is_planned_ = false;
  std::vector<ReadingLabel> plan_;
  std::size_t position_ = 0;
  std::vector<std::pair<std::size_t, ReadingLabel>> taken_;  // position and label of each reading
};

}  // namespace artcal
