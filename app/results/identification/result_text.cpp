#include "app/results/identification/result_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/output/table.h"
#include "app/results/artefact_summary.h"
#include "app/results/hayati_angles.h"
#include "app/results/identification/coupling_text.h"
#include "app/results/shown_text.h"
#include "app/results/shown_unit.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr std::size_t max_outliers = 10;
constexpr std::size_t max_lengths = 12;

const LengthDeviation* worst(const std::vector<LengthDeviation>& lengths) {
  const auto found = std::max_element(lengths.begin(), lengths.end(), [](const auto& a, const auto& b) {
    return std::abs(a.error) < std::abs(b.error);
  });
  return found == lengths.end() ? nullptr : &*found;
}

/// All that was left out, put together.
struct Unseen {
  FeatureDeviation overall;
  std::vector<LengthDeviation> lengths;
};

Unseen unseen_of(const std::vector<LeftOut>& left_out) {
  Unseen unseen;
  double squares = 0.0;
  for (const LeftOut& left : left_out) {
    unseen.overall.readings += left.deviation.readings;
    squares += left.deviation.readings * left.deviation.rms * left.deviation.rms;
    unseen.overall.maximum = std::max(unseen.overall.maximum, left.deviation.maximum);
    unseen.lengths.insert(unseen.lengths.end(), left.lengths.begin(), left.lengths.end());
  }
  unseen.overall.rms = unseen.overall.readings > 0 ? std::sqrt(squares / unseen.overall.readings) : 0.0;
  return unseen;
}

std::string title_text(const Recording& recording, const Constraints& constraints, const Identification& result) {
  return fmt::format("{}\narm {}: {}, {}, {}\n{}\n", shown_name(recording.name), in_quotes(recording.arm.name),
                     plural(recording.readings.size(), "reading"), plural(constraints.features.size(), "feature"),
                     plural(result.after.placements.size(), "placement"), artefacts_text(constraints.artefacts));
}

std::string summary_text(const Identification& result) {
  const Unseen unseen = unseen_of(result.left_out);
  const bool left_out = unseen.overall.readings > 0;
  Table table({"deviation of the readings, mm", "before", "after", left_out ? "cross-val." : ""});
  const auto row = [&](const std::string& name, double before, double after, double left) {
    table.add({name, mm_text(before), mm_text(after), left_out ? mm_text(left) : ""});
  };
  row("rms", result.before.overall.rms, result.after.overall.rms, unseen.overall.rms);
  row("largest", result.before.overall.maximum, result.after.overall.maximum, unseen.overall.maximum);
  if (const auto* before = worst(result.before.lengths)) {
    const auto* after = worst(result.after.lengths);
    const auto* left = worst(unseen.lengths);
    table.add({"worst certified length, error", signed_mm_text(before->error), signed_mm_text(after->error),
               left != nullptr ? signed_mm_text(left->error) : ""});
  }
  std::string text = table.text();
  if (left_out) {
    text +=
        result.left_out_chose_the_model
            ? "  cross-val.: each placement evaluated with an arm identified without it. These placements also chose "
              "the model:\n  new readings may deviate by more\n"
            : "  cross-val.: each placement evaluated with an arm identified without it; expect this of new readings\n";
  } else if (result.after.placements.size() < 2) {
    text +=
        "  nothing could be left out for cross-validation: there is one placement; errors elsewhere are not known\n";
  }
  return text + "\n";
}

// Members of the model's groups that keep their nominal values.
std::string fixed_members_text(const Identification& result) {
  std::string text;
  for (const FixedMember& member : result.fixed_members) {
    text += fmt::format("  {} of the group {} is fixed: {}\n", member.name, name_of(member.group), member.why);
  }
  return text;
}

std::string model_tried_text(const Identification& result) {
  if (result.trials.empty()) {
    return result.model.empty() ? ""
                                : fmt::format("  model {}\n{}\n", model_text(result.model), fixed_members_text(result));
  }
  std::string text = fmt::format(
      "Model {}: a group is taken where it improves the placements left out by more than chance allows (Student, 95 %, "
      "all groups of a step together)\n{}",
      model_text(result.model), fixed_members_text(result));
  Table table({"model tried", "parameters", "left out, mm", "better by", "standard error", "needed", ""});
  std::string refusals;
  const auto percent = [](double share) { return fmt::format("{:.1f} %", 100.0 * share); };
  for (const ModelTrial& trial : result.trials) {
    using Verdict = ModelTrial::Verdict;
    const std::string name = model_text(trial.model);
    if (trial.verdict == Verdict::Refused) {
      refusals += fmt::format("  {} refused: {}\n", name, trial.refusal);
      continue;
    }
    const bool start = trial.verdict == Verdict::Start;
    table.add({name, fmt::format("{}", trial.parameters), mm_text(trial.left_out_rms),
               start ? "" : percent(trial.improvement), start ? "" : percent(trial.improvement_noise),
               start ? "" : percent(trial.limit * trial.improvement_noise),
               trial.verdict == Verdict::Taken   ? "taken"
               : trial.verdict == Verdict::Worth ? "worth it, not the best"
               : start                           ? ""
                                                 : "not worth it"});
  }
  return text + table.text() + refusals + "\n";
}

std::string placements_text(const Identification& result) {
  if (result.after.placements.size() < 2) {
    return {};
  }
  const bool several_artefacts = result.after.artefacts.size() > 1;
  Table table({"placement", "readings", "rms before", "after", result.left_out.empty() ? "" : "cross-val."});
  for (std::size_t i = 0; i < result.after.placements.size(); ++i) {
    const FeatureDeviation& after = result.after.placements[i];
    const auto left = std::find_if(result.left_out.begin(), result.left_out.end(), [&](const LeftOut& out) {
      return out.deviation.name.artefact == after.name.artefact && out.deviation.name.placement == after.name.placement;
    });
    const std::string left_rms = left == result.left_out.end() ? ""
                                 : left->refusal.empty()       ? mm_text(left->deviation.rms)
                                                               : "not possible";
    table.add({several_artefacts ? shown_name(after.name.artefact) + ", " + shown_name(after.name.placement)
                                 : shown_name(after.name.placement),
               fmt::format("{}", after.readings), mm_text(result.before.placements[i].rms), mm_text(after.rms),
               left_rms});
  }
  std::string text = table.text() + "\n";
  for (const LeftOut& left : result.left_out) {
    if (!left.refusal.empty()) {
      text += fmt::format("  without placement {}: {}\n\n", shown_name(left.deviation.name.placement), left.refusal);
    }
  }
  return text;
}

std::string lengths_text(const Identification& result) {
  if (result.after.lengths.empty() || result.after.lengths.size() > max_lengths) {
    return {};
  }
  const auto left = unseen_of(result.left_out).lengths;
  Table table({"length", "certified, mm", "at, degC", "at temperature, mm", "error before", "after",
               left.empty() ? "" : "cross-val."});
  for (std::size_t i = 0; i < result.after.lengths.size(); ++i) {
    const LengthDeviation& length = result.after.lengths[i];
    const auto same = std::find_if(left.begin(), left.end(), [&](const LengthDeviation& other) {
      return other.first.artefact == length.first.artefact && other.first.placement == length.first.placement &&
             other.first.feature == length.first.feature && other.second == length.second;
    });
    table.add({fmt::format("{} {} - {}", shown_name(length.first.placement), shown_name(length.first.feature),
                           shown_name(length.second)),
               mm_text(length.certified.value), fmt::format("{:.4g}", length.certified.temperature),
               mm_text(length.at_temperature), signed_mm_text(result.before.lengths[i].error),
               signed_mm_text(length.error), same == left.end() ? "" : signed_mm_text(same->error)});
  }
  return table.text() + "\n";
}

std::string parameters_text(const Identification& result) {
  Table table({"parameter", "unit", "nominal", "identified", "change", "u (k = 1)"});
  for (const IdentifiedParameter& p : result.parameters) {
    const ShownUnit unit = shown_unit(p.parameter.name, p.parameter.unit());
    const auto number = [&](double value) { return fmt::format("{:.{}f}", value / unit.size, unit.decimals); };
    const bool identified = p.state == ParameterState::Identified || p.state == ParameterState::Weak;
    table.add({p.parameter.name, unit.name, number(p.nominal), number(p.identified),
               identified ? fmt::format("{:+.{}f}", (p.identified - p.nominal) / unit.size, unit.decimals) : "",
               identified ? fmt::format("{:.2g}{}", p.u / unit.size, p.state == ParameterState::Weak ? " (prior)" : "")
               : p.state == ParameterState::Unidentifiable ? "not identifiable"
                                                           : "fixed"});
  }
  return table.text() + "\n";
}

// Radii that nobody certified, and certified values that the readings contradict.
std::string artefacts_text(const Identification& result) {
  Table table({"artefact, feature", "quantity", "certified, mm", "found, mm", "u (k = 1)"});
  std::size_t rows = 0;
  for (const ArtefactValue& value : result.artefact_values) {
    const char* quantity = value.quantity == ArtefactParameter::Quantity::ErrorX   ? "x"
                           : value.quantity == ArtefactParameter::Quantity::ErrorY ? "y"
                           : value.quantity == ArtefactParameter::Quantity::ErrorZ ? "z"
                                                                                   : "radius";
    const bool contradicted = value.certified && std::abs(value.found - *value.certified) > 3.0 * value.u_certified;
    if ((value.certified && !contradicted) || rows++ >= max_lengths) {
      continue;
    }
    table.add({fmt::format("{}, {}", shown_name(value.artefact), shown_name(value.feature)), quantity,
               value.certified ? mm_text(*value.certified) : "not", mm_text(value.found),
               fmt::format("{:.2g}", value.u)});
  }
  if (rows == 0) {
    return {};
  }
  const std::string more = rows > max_lengths ? fmt::format("  and {} more\n", rows - max_lengths) : std::string();
  return table.text() + more + "\n";
}

// What several artefacts count against each other, or what a loss made of one.
std::string influences_text(const Identification& result) {
  const bool reweighted =
      std::any_of(result.influences.begin(), result.influences.end(), [](const ArtefactInfluence& influence) {
        return influence.readings_weight < 1.0 || (influence.certificates > 0 && influence.certificates_weight < 1.0);
      });
  if (result.influences.size() < 2 && !reweighted) {
    return {};
  }
  Table table({"artefact", "share in the arm", "readings", "mean weight", "certified values", "mean weight"});
  for (const ArtefactInfluence& influence : result.influences) {
    table.add({shown_name(influence.artefact), fmt::format("{:.1f} %", 100.0 * influence.share),
               fmt::format("{}", influence.readings), fmt::format("{:.2f}", influence.readings_weight),
               fmt::format("{}", influence.certificates),
               influence.certificates > 0 ? fmt::format("{:.2f}", influence.certificates_weight) : ""});
  }
  return table.text() + "\n";
}

std::string noise_text(const Identification& result) {
  return fmt::format(
      "  noise of a reading {:.4g} mm a coordinate ({}), chi-squared {:.1f} with {} degrees of freedom\n\n{}",
      result.noise, result.noise_is_given ? "as stated" : "estimated from the residuals", result.chi_squared,
      result.degrees_of_freedom, influences_text(result));
}

std::string alignment_text(const Identification& result) {
  if (result.alignment == Alignment::None) {
    return {};
  }
  return fmt::format("  initial alignment: {} (attempt {})\n\n", name_of(result.alignment), result.attempts);
}

std::string model_study_text(const ModelStudy& study) {
  if (!study.done || !study.findings.empty()) {
    return {};  // what was found is a warning
  }
  return fmt::format("  residual diagnostics: {} effects tested (periodic, bending, drift, …), none found\n\n",
                     study.tests.size());
}

// How much of an observation a loss left; nothing without a loss.
std::string weight_text(double weight) { return weight < 1.0 ? fmt::format(", weight {:.2g}", weight) : ""; }

template <typename Item, typename Line>
std::string outlier_lines(const std::vector<Item>& outliers, const char* noun, Line&& line) {
  if (outliers.empty()) {
    return {};
  }
  const bool reweighted =
      std::any_of(outliers.begin(), outliers.end(), [](const Item& outlier) { return outlier.weight < 1.0; });
  std::string text = fmt::format("Outliers: {} ({}); check them:\n", plural(outliers.size(), noun),
                                 reweighted ? "given less weight" : "kept");
  for (std::size_t i = 0; i < std::min(max_outliers, outliers.size()); ++i) {
    text += fmt::format("  {}, {:.1f} standard deviations (limit {:.1f}){}\n", line(outliers[i]),
                        outliers[i].standardised, outliers[i].limit, weight_text(outliers[i].weight));
  }
  if (outliers.size() > max_outliers) {
    text += fmt::format("  and {} more, all in the JSON result\n", outliers.size() - max_outliers);
  }
  return text + "\n";
}

std::string outliers_text(const Recording& recording, const Identification& result) {
  return outlier_lines(result.certificate_outliers, "certified value",
                       [](const CertificateOutlier& outlier) {
                         return fmt::format(
                             "{}{}: {} {} mm, {} mm off", shown_name(outlier.name.artefact),
                             outlier.quantity ? "" : fmt::format(", placement {}", shown_name(outlier.name.placement)),
                             truncated(140, quantity_text(outlier)), mm_text(outlier.certified),
                             signed_mm_text(-outlier.deviation));
                       }) +
         outlier_lines(result.outliers, "reading", [&](const Outlier& outlier) {
           return fmt::format("{}: placement {}, feature {}, {} mm", truncated(200, recording.where(outlier.reading)),
                              shown_name(outlier.name.placement), shown_name(outlier.name.feature),
                              deviation_text(outlier.deviation, outlier.is_signed));
         });
}

}  // namespace

std::string to_text(const Recording& recording, const Constraints& constraints, const Identification& result) {
  const std::string warnings = result.warnings.empty() ? "" : warning_lines(result.warnings) + "\n";
  return title_text(recording, constraints, result) + summary_text(result) + warnings + model_tried_text(result) +
         hayati_angles_text(recording, result) + placements_text(result) + lengths_text(result) +
         parameters_text(result) + artefacts_text(result) + noise_text(result) + alignment_text(result) +
         model_study_text(result.model_study) + cannot_text(result.coupling) + outliers_text(recording, result);
}

}  // namespace artcal
