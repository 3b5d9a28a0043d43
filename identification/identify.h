#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "core/error.h"
#include "identification/evaluation/evaluation.h"
#include "identification/identifiability/coupling.h"
#include "identification/initial/alignment.h"
#include "identification/models/model.h"
#include "identification/models/model_study.h"
#include "identification/problem/loss.h"
#include "identification/progress.h"

namespace artcal {

struct IdentifyOptions {
  std::vector<std::string> hold;  ///< parameters to keep at their nominal value
  std::vector<std::string> free;  ///< parameters to identify although they are fixed by default (a6, d6, …)
  Model model;                    ///< what is identified beside the chain and the tips
  bool automatic = false;         ///< groups are to be added: identify_automatically()
  Loss loss = Loss::None;
  Noise noise;                 ///< given, or else estimated from the residuals
  bool accept_misfit = false;  ///< return a fit that is no solution too, with its misfits
  bool leave_out = true;       ///< identify once more without each placement
  /// An arm near the solution, such as the one that a narrower model led to; tried before the initial alignments.
  std::optional<Arm> start = {};
  int max_iterations = 100;
  int threads = 0;  ///< for leaving out; 0 takes all. The result does not depend on it
  IdentifyProgressCallback progress = {};
};

/// What became of a parameter.
enum class ParameterState {
  Identified,      ///< found from the readings, with a standard uncertainty
  Fixed,           ///< kept at its nominal value: asked for, or the last joint's a and d
  Weak,            ///< found with a weak prior about its nominal value, which the readings alone determine worse
  Unidentifiable,  ///< kept at its nominal value: the readings cannot determine it
};

struct IdentifiedParameter {
  Parameter parameter;
  double nominal = 0.0;  ///< in the parameter's unit
  double identified = 0.0;
  double u = 0.0;  ///< standard uncertainty; 0 and without meaning unless Identified or Weak
  ParameterState state = ParameterState::Identified;
  /// Effective ones of u (Welch, Satterthwaite): of the noise where it was estimated; what certificates bring is known.
  double degrees_of_freedom = std::numeric_limits<double>::infinity();

  [[nodiscard]] double coverage_factor() const;  ///< k of the expanded uncertainty
};

/// What the readings say of a number of an artefact itself (Constraints::shared): a ball's radius, or one of the
/// coordinates that its certificate states with an uncertainty.
struct ArtefactValue {
  std::string artefact, feature;
  ArtefactParameter::Quantity quantity = ArtefactParameter::Quantity::Radius;
  std::optional<double> certified;  ///< mm at the reference temperature
  double u_certified = 0.0;         ///< standard uncertainty, mm; 0 where nothing is certified
  double found = 0.0;               ///< mm at the reference temperature, from certificate and readings together
  double u = 0.0;                   ///< standard uncertainty, mm
};

/// A reading whose standardised residual is larger than chance allows among so many.
struct Outlier {
  int reading = 0;  ///< into Recording::readings
  FeatureName name;
  double standardised = 0.0;  ///< length of the residual in standard deviations
  double limit = 0.0;         ///< what chance allows of it
  double deviation = 0.0;     ///< mm
  bool is_signed = true;      ///< the deviation has a sign; a distance from a point has none
  double weight = 1.0;        ///< by which the loss made it count, 0 to 1
};

/// A certified value that the readings contradict by more than chance allows.
struct CertificateOutlier {
  FeatureName name;    ///< of a distance the first feature; otherwise without a placement
  std::string second;  ///< of a distance the other feature
  std::optional<ArtefactParameter::Quantity> quantity;  ///< nothing: a distance
  double certified = 0.0;                               ///< mm
  double u = 0.0;                                       ///< standard uncertainty, mm
  double deviation = 0.0;                               ///< of what all the rest determines from what is certified, mm
  double standardised = 0.0;  ///< that in its standard deviations, those of the readings included
  double limit = 0.0;         ///< what chance allows of it
  double weight = 1.0;        ///< by which the loss made it count, 0 to 1
};

/// "distance "A" to "B"", "x of "A"".
std::string quantity_text(const CertificateOutlier& outlier);

/// How much an artefact counts in an identification.
struct ArtefactInfluence {
  std::string artefact;
  int readings = 0;
  double readings_weight = 0.0;      ///< mean weight that the loss gave them; 1 without a loss
  int certificates = 0;              ///< certified values: distances by placement, coordinates and radii once
  double certificates_weight = 0.0;  ///< mean weight that the loss gave them
  double share = 0.0;  ///< of what determines the arm: its part of the trace of the parameters' hat matrix, 0 to 1
};

/// A length or coordinate of a placement left out, as the arm identified without it measures it, mm.
struct CheckedPrediction {
  double error = 0.0;    ///< measured less certified
  double u_arm = 0.0;    ///< its standard uncertainty by the parameters of that arm
  double u_other = 0.0;  ///< by the noise of the readings and by the certificate
  /// The certificate's part of that, an error that all predictions of the same certified value have in common:
  /// `certified` is the artefact and its two features (-1: each prediction has its own).
  double u_certificate = 0.0;
  std::array<int, 3> certified{-1, -1, -1};
};

/// One placement judged by an arm that was identified without it.
struct LeftOut {
  FeatureDeviation deviation;  ///< overall of the placement
  std::vector<LengthDeviation> lengths;
  std::vector<CheckedPrediction> predictions;  ///< of lengths, patterns and coordinates
  double squares = 0.0;                        ///< of the deviations of its readings, mm²
  int degrees_of_freedom = 0;                  ///< of these, a coordinate each, its own unknowns taken off
  std::string refusal;                         ///< why it could not be left out; empty if it could
  ErrorKind refusal_kind = ErrorKind::Other;   ///< of that error
};

/// Whether placements left out are where the arms identified without them say, within their uncertainty.
struct CrossValidation {
  int placements = 0;                 ///< that were left out and hold something to check; 0: nothing was checked
  int predictions = 0;                ///< in all
  double effective_placements = 0.0;  ///< that are independent of one another: fewer where certificates dominate
  double ratio = 0.0;                 ///< of the errors to their standard uncertainties, rms over placements
  double limit = 0.0;                 ///< what chance stays below in 99 of 100 cases, where the model is right
  double point_error = 0.0;  ///< unmodelled error of a coordinate of the tip at one posture, mm: beyond the noise
  /// Factor on the covariance's standard uncertainties, so that points and lengths have the unmodelled error; 1 where
  /// the model explains what placements left out show.
  double scale = 1.0;
};

/// A model that identify_automatically() tried.
struct ModelTrial {
  enum class Verdict {
    Start,     ///< what the search began with
    Taken,     ///< its last group was taken into the model
    Worth,     ///< it would have been worth it, but another group was better
    NotWorth,  ///< placements left out are not better by more than chance allows
    Refused,   ///< the readings cannot determine the group, or it makes no sense here
  };
  int step = 0;  ///< groups taken before
  Model model;   ///< with the group on trial last
  Verdict verdict = Verdict::Start;
  std::string refusal;             ///< why it was refused; nothing below is known then
  int parameters = 0;              ///< identified ones
  double left_out_rms = 0.0;       ///< of readings and lengths of the placements left out, mm
  double improvement = 0.0;        ///< share by which their mean square fell
  double improvement_noise = 0.0;  ///< standard error of that share, from the scatter of the placements
  double limit = 0.0;              ///< of improvement/improvement_noise: above it the group is worth it
};

/// A parameter of a model's group that keeps its nominal value although the group is in the model.
struct FixedMember {
  enum class Reason {
    NotIdentifiable,  ///< the readings do not see it, alone or apart from others
    Undetermined,     ///< its standard uncertainty is beyond what a joint that works can have
    Implausible,      ///< its estimate is
    BelowZero,        ///< a compliance, whose estimate is below zero
  };
  std::string name;
  ParameterGroup group = ParameterGroup::Eccentricity;
  Reason reason = Reason::NotIdentifiable;
  double estimate = 0.0;  ///< before it was fixed, in the parameter's unit; 0 where there was none
  double u = 0.0;         ///< its standard uncertainty; 0 where there was none
  std::string why;        ///< the same in words
};

struct Identification {
  Arm arm;
  Alignment alignment = Alignment::None;  ///< the initial alignment that led to it
  int attempts = 1;                       ///< initial alignments tried until then
  std::vector<std::string> weak;          ///< parameters in the state Weak
  std::vector<std::string>
      misfits;  ///< why it is no solution (accept_misfit only), see identification/evaluation/misfit.h
  Model model;
  std::vector<FixedMember> fixed_members;
  std::vector<ModelTrial> trials;  ///< of identify_automatically(), in the order they were made
  std::vector<IdentifiedParameter> parameters;
  std::vector<int> free;       ///< indices into parameters, in the order of the covariance
  Eigen::MatrixXd covariance;  ///< of these, in their units; with scale factor and cross_validation.scale
  Coupling coupling;
  std::vector<ArtefactValue> artefact_values;  ///< as Constraints::shared
  Evaluation before, after;
  std::vector<LeftOut> left_out;
  bool left_out_chose_the_model = false;  ///< the same placements were what identify_automatically() chose groups by
  CrossValidation cross_validation;       ///< by left_out
  std::vector<Outlier> outliers;
  std::vector<CertificateOutlier> certificate_outliers;
  std::vector<ArtefactInfluence> influences;  ///< of each artefact that was read
  ModelStudy model_study;                     ///< whether the residuals hold something that the model lacks

  bool noise_is_given = false;
  double noise = 0.0;        ///< mm a coordinate: given, estimated, or the median over the postures
  double chi_squared = 0.0;  ///< of the fit against the noise in use, by the loss in use (goodness_of_fit())
  int degrees_of_freedom = 0;
  double chi_squared_low = 0.0;  ///< 95 % of sound fits lie between these two
  double chi_squared_high = 0.0;
  double scale_factor = 1.0;  ///< factor on all u, because the readings are noisier than was stated

  int iterations = 0;
  int noise_rounds = 0;
  double cost = 0.0;  ///< half the weighted sum of squares
  std::string termination;
  std::vector<std::string> warnings;
};

/// Finds the arm's parameters from readings on artefacts.
/// Usage: an unknown name in hold or free, both members of a wrist pair asked to be free, a group of the model that
/// makes no sense for this arm and recording.
/// Bad input: a reading without joint angles, or without the arm's temperature where the arm expands.
/// No solution: no calibrated length (scale is unidentifiable), fewer residuals than unknowns, a parameter asked to
/// be free or a group asked for that the readings cannot determine, no convergence.
Expected<Identification> identify(const Recording& recording, const Constraints& constraints,
                                  const IdentifyOptions& options = {});

}  // namespace artcal
