#include "identification/reported_coordinates/reported_model.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "acquisition/recording/tip_centres.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t identified_with = 8;
constexpr Eigen::Index screened_readings = 80;
constexpr double clearly_better = 0.5;  // rms

// Each reading on a feature of known coordinates: what the software reported.
Expected<Recording> with_references(Recording recording) {
  recording.artefacts = {};
  recording.features = {};
  recording.placements = {};
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    Reading& reading = recording.readings[i];
    reading.artefact = recording.artefacts.index_of("reported coordinates");
    reading.feature = recording.features.index_of("tip");
    reading.placement = recording.placements.index_of("");
    if (reading.tip.allFinite()) {
      reading.reference = reading.tip;
    } else if (!reading.reference.allFinite()) {
      return bad_input(
          "the reading has no coordinates, expected x, y, z as the arm's software reported them beside the joint "
          "angles",
          recording.where(static_cast<int>(i)));
    }
  }
  return recording;
}

Artefact reported_coordinates(bool base_frame_is_known) {
  Artefact artefact;
  artefact.name = "reported coordinates";
  artefact.frame = base_frame_is_known ? CoordinateFrame::Base : CoordinateFrame::Artefact;
  CertifiedFeature tip;
  tip.name = "tip";
  tip.kind = FeatureKind::Coordinates;
  artefact.features.push_back(std::move(tip));
  return artefact;
}

// Readings spread over the recording, enough to tell which assignment is right.
Recording screened_part(const Recording& recording) {
  const Eigen::Index count = std::min(screened_readings, recording.joints.cols());
  Recording part = recording;
  part.readings.clear();
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index i = 0; i < count; ++i) {
    chosen.push_back(i * recording.joints.cols() / count);
    part.readings.push_back(recording.readings[static_cast<std::size_t>(chosen.back())]);
  }
  part.joints = Eigen::MatrixXd(recording.joints(Eigen::all, chosen));
  return part;
}

/// The search for the assignment that leads to the best arm.
class ReportedSearch {
 public:
  ReportedSearch(const Recording& recording, const ReportedModelOptions& options)
      : recording_(recording), part_(screened_part(recording)), options_(options) {
    options_.identify.leave_out = false;
  }

  void try_likely(bool permuted) {
    Eigen::Matrix3Xd coordinates(3, recording_.joints.cols());
    std::vector<int> probes;
    for (std::size_t i = 0; i < recording_.readings.size(); ++i) {
      coordinates.col(static_cast<Eigen::Index>(i)) = recording_.readings[i].reference;
      probes.push_back(recording_.readings[i].probe);
    }
    for (const JointAssignment& assignment :
         likely_assignments(recording_.arm, recording_.joints, coordinates, probes, options_.base_frame_is_known,
                            permuted, identified_with)) {
      screen(assignment);
    }
  }

  [[nodiscard]] bool found() const { return best_.has_value(); }

  Expected<ReportedModel> result() && {
    if (!best_ && first_error_ && first_error_->code != ErrorCode::NoSolution) {
      return tl::unexpected(*first_error_);
    }
    if (!best_) {
      return no_solution(fmt::format(
          "no order, signs and unit of the joints lead to an arm that fits the coordinates ({} tried). Is the arm's "
          "file of this kind of arm, within some 10 mm and 5 deg, are the coordinates in the unit that the recording "
          "states and in the arm's base frame (--frame unknown, if not), and do row for row coordinates and joint "
          "angles belong together?",
          tried_));
    }
    auto model = identified(recording_, *best_);
    if (model) {
      model->tried = tried_;
      model->next_best = next_best_;
    }
    return model;
  }

 private:
  [[nodiscard]] Expected<ReportedModel> identified(const Recording& recording,
                                                   const JointAssignment& assignment) const {
    Recording of_joints = recording;
    of_joints.joints = assigned(assignment, recording.arm, recording.joints);
    auto constraints = build_constraints(of_joints, {reported_coordinates(options_.base_frame_is_known)});
    if (!constraints) {
      return tl::unexpected(constraints.error());
    }
    IdentifyOptions of_one_model = options_.identify;
    of_one_model.automatic = false;
    auto identification = identify(of_joints, *constraints, of_one_model);
    if (!identification) {
      return tl::unexpected(identification.error());
    }
    return ReportedModel{assignment, std::move(of_joints), std::move(*constraints), std::move(*identification)};
  }

  // Of assignments that fit alike the one that was likelier stays.
  void screen(const JointAssignment& assignment) {
    ++tried_;
    const auto model = identified(part_, assignment);
    if (!model) {
      first_error_ = first_error_ ? first_error_ : model.error();
      return;
    }
    const double rms = model->identification.after.overall.rms;
    const bool better = !best_ || rms < clearly_better * best_rms_;
    if (best_) {
      const double other = better ? best_rms_ : rms;
      next_best_ = std::min(next_best_.value_or(other), other);
    }
    if (better) {
      best_ = assignment;
      best_rms_ = rms;
    }
  }

  const Recording& recording_;
  Recording part_;
  ReportedModelOptions options_;
  std::optional<JointAssignment> best_;
  double best_rms_ = 0.0;
  std::optional<Error> first_error_;
  std::optional<double> next_best_;
  int tried_ = 0;
};

// Signs of the readings become signs of the joints, whose angles then are what the columns say.
void put_signs_into_arms(ReportedModel& model) {
  const std::vector<double>& sign = model.assignment.sign;
  for (std::size_t i = 1; i < sign.size(); ++i) {
    for (Arm* arm : {&model.recording.arm, &model.identification.arm}) {
      arm->joints[i].mechanical_coupling *= sign[i] * sign[i - 1];
    }
  }
  for (std::size_t i = 0; i < sign.size(); ++i) {
    if (sign[i] > 0.0) {
      continue;
    }
    for (Arm* arm : {&model.recording.arm, &model.identification.arm}) {
      arm->joints[i].sign = -arm->joints[i].sign;
      std::swap(arm->joints[i].lowest, arm->joints[i].highest);
      for (auto* end : {&arm->joints[i].lowest, &arm->joints[i].highest}) {
        *end = *end ? std::optional(-**end) : std::nullopt;
      }
    }
    model.recording.joints.row(static_cast<Eigen::Index>(i)) *= -1.0;
  }
}

}  // namespace

Expected<ReportedModel> identify_reported_model(const Recording& recording, const ReportedModelOptions& options) {
  if (auto there = require_joints(recording); !there) {
    return tl::unexpected(there.error());
  }
  const auto referenced = with_references(recording);
  if (!referenced) {
    return tl::unexpected(referenced.error());
  }
  ReportedSearch search(*referenced, options);
  search.try_likely(false);
  if (!search.found()) {
    search.try_likely(true);
  }
  return std::move(search).result().map([](ReportedModel&& model) {
    put_signs_into_arms(model);
    return std::move(model);
  });
}

}  // namespace artcal
