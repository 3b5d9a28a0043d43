#include "app/stream/label_sequence.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/csv/csv.h"
#include "acquisition/csv/csv_text.h"
#include "core/files/size_limits.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t artefact_column = 0;
constexpr std::size_t placement_column = 1;
constexpr std::size_t feature_column = 2;

// "1" → "2", "back" → "back 2", "back 2" → "back 3".
std::string name_after(const std::string& placement) {
  std::size_t digits = placement.size();
  while (digits > 0 && placement[digits - 1] >= '0' && placement[digits - 1] <= '9') {
    --digits;
  }
  long number = 0;
  const auto [end, error] = std::from_chars(placement.data() + digits, placement.data() + placement.size(), number);
  return error == std::errc() ? fmt::format("{}{}", placement.substr(0, digits), number + 1) : placement + " 2";
}

// What a label of the plan names that no artefact has, and what it could have named.
tl::unexpected<Error> unknown_label(const std::vector<std::pair<std::string, std::string>>& features,
                                    const ReadingLabel& label, const CsvReader& plan) {
  std::vector<std::string> artefacts, own;
  for (const auto& [artefact, feature] : features) {
    if (artefacts.empty() || artefacts.back() != artefact) {
      artefacts.push_back(artefact);
    }
    if (artefact == label[artefact_column]) {
      own.push_back(feature);
    }
  }
  const auto listed = [](const std::vector<std::string>& names) {
    return truncated(200, fmt::format("{}", fmt::join(names, ", ")));
  };
  return own.empty()
             ? bad_input(fmt::format("the plan names the artefact {}, expected one of --artefact: {}",
                                     in_quotes(label[artefact_column]), listed(artefacts)),
                         plan.where(plan.column("artefact").value_or(0)))
             : bad_input(fmt::format("the plan names the feature {}, expected one of the artefact {}: {}",
                                     in_quotes(label[feature_column]), in_quotes(label[artefact_column]), listed(own)),
                         plan.where(plan.column("feature").value_or(0)));
}

}  // namespace

LabelSequence::LabelSequence(const std::vector<Artefact>& artefacts, const Constants& constants) {
  for (const Artefact& artefact : artefacts) {
    for (const CertifiedFeature& feature : artefact.features) {
      features_.emplace_back(artefact.name, feature.name);
    }
  }
  by_hand_ = features_.empty() ? ReadingLabel{"", "1", ""}
                               : ReadingLabel{features_.front().first, "1", features_.front().second};
  for (const auto& [column, value] : constants) {
    columns_.push_back(column);
    by_hand_.push_back(value);
  }
}

Expected<void> LabelSequence::follow(const std::filesystem::path& plan) {
  const auto file = read_text_file(plan, largest::readings);
  if (!file) {
    return tl::unexpected(file.error());
  }
  auto csv = CsvReader::open(*file);
  if (!csv) {
    return tl::unexpected(csv.error());
  }
  for (const char* more : {"orientation", "repeat", "probe"}) {
    if (csv->column(more) && std::find(columns_.begin(), columns_.end(), more) == columns_.end()) {
      columns_.emplace_back(more);
      by_hand_.emplace_back();
    }
  }
  if (!csv->column("placement") && !csv->column("feature")) {
    return bad_input("the plan has no column placement and none feature: it says of no reading what it is of",
                     plan.string());
  }
  while (true) {
    const auto row = csv->next();
    if (!row) {
      return tl::unexpected(row.error());
    }
    if (!*row) {
      break;
    }
    ReadingLabel label = by_hand_;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (const auto column = csv->column(columns_[i])) {
        label[i] = without_guard(csv->field(*column));
      }
    }
    // An empty name means the only artefact or feature, where there is only one.
    if (label[artefact_column].empty() && !features_.empty() && features_.front().first == features_.back().first) {
      label[artefact_column] = features_.front().first;
    }
    if (label[feature_column].empty() && features_.size() == 1) {
      label[feature_column] = features_.front().second;
    }
    if (!is_known(label[artefact_column], label[feature_column])) {
      return unknown_label(features_, label, *csv);
    }
    plan_.push_back(std::move(label));
  }
  if (plan_.empty()) {
    return bad_input("the plan has no readings", plan.string());
  }
  is_planned_ = true;
  return {};
}

bool LabelSequence::is_known(std::string_view artefact, std::string_view feature) const {
  return std::any_of(features_.begin(), features_.end(),
                     [&](const auto& known) { return known.first == artefact && known.second == feature; });
}

void LabelSequence::take() {
  taken_.emplace_back(position_, current());
  position_ += is_planned_ ? 1 : 0;
}

bool LabelSequence::take_known(const ReadingLabel& label) {
  if (!is_planned_) {
    by_hand_ = label;
  } else if (has_ended() || (current() != label && !skip_to([&](const ReadingLabel& l) { return l == label; }))) {
    return false;
  }
  take();
  return true;
}

bool LabelSequence::undo() {
  if (taken_.empty()) {
    return false;
  }
  position_ = taken_.back().first;
  by_hand_ = taken_.back().second;
  taken_.pop_back();
  return true;
}

template <typename Condition>
bool LabelSequence::skip_to(const Condition& condition) {
  const auto begin = plan_.begin() + static_cast<std::ptrdiff_t>(std::min(position_, plan_.size()));
  const auto found = std::find_if(begin, plan_.end(), condition);
  if (found == plan_.end()) {
    return false;
  }
  position_ = static_cast<std::size_t>(found - plan_.begin());
  return true;
}

bool LabelSequence::next_feature() {
  if (is_planned_) {
    const auto here = has_ended() ? ReadingLabel{} : current();
    return !here.empty() && skip_to([&](const ReadingLabel& label) {
      return !std::equal(here.begin(), here.begin() + feature_column + 1, label.begin());
    });
  }
  const auto here =
      std::find(features_.begin(), features_.end(), std::pair(by_hand_[artefact_column], by_hand_[feature_column]));
  if (features_.empty()) {
    return false;
  }
  const auto& next = here == features_.end() || here + 1 == features_.end() ? features_.front() : *(here + 1);
  by_hand_[artefact_column] = next.first;
  by_hand_[feature_column] = next.second;
  return true;
}

bool LabelSequence::next_placement() {
  if (is_planned_) {
    const auto here = has_ended() ? ReadingLabel{} : current();
    return !here.empty() && skip_to([&](const ReadingLabel& label) {
      return label[artefact_column] != here[artefact_column] || label[placement_column] != here[placement_column];
    });
  }
  by_hand_[placement_column] = name_after(by_hand_[placement_column]);
  const auto first = std::find_if(features_.begin(), features_.end(),
                                  [&](const auto& known) { return known.first == by_hand_[artefact_column]; });
  if (first != features_.end()) {
    by_hand_[feature_column] = first->second;
  }
  return true;
}

bool LabelSequence::name(std::size_t column, std::string_view text) {
  if (is_planned_) {
    return (!has_ended() && current()[column] == text) ||
           skip_to([&](const ReadingLabel& label) { return label[column] == text; });
  }
  if (column == placement_column) {
    by_hand_[column] = text;
    return true;
  }
  const bool is_here = column == feature_column && is_known(by_hand_[artefact_column], text);
  const auto found = std::find_if(features_.begin(), features_.end(), [&](const auto& known) {
    return column == artefact_column ? known.first == text
                                     : known.second == text && (!is_here || known.first == by_hand_[artefact_column]);
  });
  if (found == features_.end()) {
    return false;
  }
  by_hand_[artefact_column] = found->first;
  by_hand_[feature_column] = found->second;
  return true;
}

}  // namespace artcal
