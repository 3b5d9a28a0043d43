#pragma once

#include <string>
#include <vector>

namespace artcal {

/// What the residuals were searched for. All but Expansion are a change of one joint's reading q.
enum class Effect {
  OncePerTurn,        ///< A·sin(q + φ): an eccentric grating
  TwicePerTurn,       ///< A·sin(2q + φ)
  Gain,               ///< A·q
  Gravity,            ///< in proportion to torques of weights about the joint's axis, the base's z axis pointing up
  Drift,              ///< A·(place in the recording, −1 … 1): the zero moved while readings were taken
  TemperatureOffset,  ///< A·(temperature − its mean): the zero moves with temperature
  Expansion,          ///< all lengths of the arm grow with temperature
};

/// One question to the residuals, asked beside the fitted model: a score test of `columns` more coefficients, whose
/// variance is taken from the readings themselves (heteroscedasticity-consistent).
struct ModelTest {
  Effect effect = Effect::OncePerTurn;
  int joint = 0;  ///< from 0
  int columns = 0;
  double chi_squared = 0.0;  ///< of `columns` degrees of freedom where the model is right
  double p = 1.0;            ///< probability of such a value, or a larger one, where the model is right
};

/// What the residuals hold that the model lacks.
struct ModelFinding {
  Effect effect = Effect::OncePerTurn;
  int joint = 0;
  double p = 1.0;             ///< beside what was found before it
  double amplitude = 0.0;     ///< A, rad (Gain: 1; Warmth: rad/K; Expansion: 1/K); of Gravity the rms turning, rad
  double u_amplitude = 0.0;   ///< standard uncertainty; 0: none (Gravity)
  double phase = 0.0;         ///< φ, rad, of the first two
  double rms_at_tip = 0.0;    ///< how far it moves the readings' tips, mm rms
  double rms_rotation = 0.0;  ///< how far it turns its joint, their mean taken off, rad rms; of Expansion 0
};

/// Whether an arm's model explains its readings.
struct ModelStudy {
  bool done = false;           ///< false: the readings leave nothing to judge by, or agree to the last digits
  double false_alarms = 0.01;  ///< share of recordings of a sound model in which anything is found (at most)
  int readings = 0;            ///< that were looked at
  std::vector<ModelTest> tests;
  std::vector<ModelFinding> findings;  ///< the strongest first; only what a joint that works can have
  double remaining_variance = 1.0;     ///< of the residuals beside the findings, as a share of that of the fit
  /// Effects that explain more of what is left than chance does, but only with values that no joint that works has (a
  /// compliance below zero, an encoder off by degrees): they are no causes.
  int implausible = 0;
};

/// "joint 3: once per turn, 12.3 arcsec · sin(q3 + 41 deg)".
std::string in_words(const ModelFinding& finding);

/// What a person is to know of it; empty where nothing was found.
std::string warning_of(const ModelStudy& study);

}  // namespace artcal
