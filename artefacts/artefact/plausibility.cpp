#include "artefacts/artefact/plausibility.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// Of expanded uncertainties (k = 2), mm: the best ball bars and balls are known to 20 nm, and what is not known to
// 0.1 mm calibrates no arm.
constexpr double min_expanded = 5e-6;
constexpr double max_expanded = 0.1;
constexpr double max_form = 0.02;         // mm; balls and faces of artefacts have a few um at most
constexpr double min_diameter = 0.5;      // mm
constexpr double max_diameter = 500.0;    // mm
constexpr double max_expansion = 5e-5;    // 1/K; aluminium has 2.4e-5
constexpr double max_u_expansion = 1e-5;  // 1/K
constexpr double min_radius = 0.05;       // mm, of a tip that is no point
constexpr double max_radius = 50.0;       // mm

bool is_plausible_u(double u) { return u == 0.0 || (2.0 * u >= min_expanded && 2.0 * u <= max_expanded); }

/// Collects sentences about one artefact, one of a kind of value.
class Sentences {
 public:
  explicit Sentences(const Artefact& artefact) : name_(in_quotes(artefact.name)) {}

  void check_u(double u, const std::string& of) {
    if (!is_plausible_u(u) && !said_u_) {
      said_u_ = true;
      add(fmt::format("the expanded uncertainty (k = 2) of {} is {}, expected {} to {}; is its unit right?", of,
                      length_text(2.0 * u), length_text(min_expanded), length_text(max_expanded)));
    }
  }
  void add(const std::string& text) { all_.push_back(fmt::format("artefact {}: {}", name_, text)); }
  std::vector<std::string> take() { return std::move(all_); }

 private:
  std::string name_;
  bool said_u_ = false;
  std::vector<std::string> all_;
};

void check_feature(const CertifiedFeature& feature, Sentences& sentences) {
  const std::string name = in_quotes(feature.name);
  sentences.check_u(feature.u_at, "the coordinates of " + name);
  sentences.check_u(2.0 * feature.u_radius, "the diameter of " + name);
  if (feature.kind == FeatureKind::Sphere && feature.radius &&
      (2.0 * *feature.radius < min_diameter || 2.0 * *feature.radius > max_diameter)) {
    sentences.add(fmt::format("the diameter of {} is {}, expected {} to {}; is its unit right?", name,
                              length_text(2.0 * *feature.radius), length_text(min_diameter),
                              length_text(max_diameter)));
  }
  if (feature.form.value_or(0.0) > max_form || 2.0 * feature.u_form > max_form) {
    sentences.add(fmt::format("the form deviation of {} is {} with u = {}, expected {} at most; is its unit right?",
                              name, length_text(feature.form.value_or(0.0)), length_text(feature.u_form),
                              length_text(max_form)));
  }
}

}  // namespace

std::string length_text(double length) {
  const double size = std::abs(length);
  return size >= 0.1 || size == 0.0 ? fmt::format("{:.4g} mm", length)
         : size >= 1e-4             ? fmt::format("{:.4g} um", 1e3 * length)
                                    : fmt::format("{:.3g} nm", 1e6 * length);
}

bool is_room_temperature(double temperature) { return temperature >= 0.0 && temperature <= 50.0; }

std::string unit_of_temperature(double temperature) {
  const double fahrenheit = (temperature - 32.0) / 1.8;
  const double kelvin = temperature - 273.15;
  return is_room_temperature(fahrenheit) ? fmt::format(" (degrees Fahrenheit? {:.1f} degC)", fahrenheit)
         : is_room_temperature(kelvin)   ? fmt::format(" (kelvin? {:.1f} degC)", kelvin)
                                         : "";
}

std::vector<std::string> implausible_values(const Artefact& artefact) {
  Sentences sentences(artefact);
  for (const CertifiedDistance& distance : artefact.distances) {
    sentences.check_u(
        distance.u, fmt::format("the length {} - {}", artefact.features[static_cast<std::size_t>(distance.first)].name,
                                artefact.features[static_cast<std::size_t>(distance.second)].name));
  }
  for (const CertifiedFeature& feature : artefact.features) {
    check_feature(feature, sentences);
  }
  if (!is_room_temperature(artefact.reference_temperature)) {
    sentences.add(fmt::format("its values hold at {:.2f} degC{}, expected a temperature of a laboratory, 0 to 50 degC",
                              artefact.reference_temperature, unit_of_temperature(artefact.reference_temperature)));
  }
  if (std::abs(artefact.expansion) > max_expansion || artefact.u_expansion > max_u_expansion) {
    sentences.add(
        fmt::format("it expands by {} per kelvin with u = {}, expected {} with u = {} at most (steel has "
                    "11.5e-6)",
                    artefact.expansion, artefact.u_expansion, max_expansion, max_u_expansion));
  }
  return sentences.take();
}

std::vector<std::string> implausible_values(const Recording& recording) {
  std::vector<std::string> sentences;
  const auto check_temperatures = [&](double Reading::*temperature, const char* of) {
    const auto& readings = recording.readings;
    const auto is_none = [&](const Reading& reading) {
      return std::isfinite(reading.*temperature) && !is_room_temperature(reading.*temperature);
    };
    const auto found = std::find_if(readings.begin(), readings.end(), is_none);
    if (found != readings.end()) {
      const double value = *found.*temperature;
      sentences.push_back(fmt::format(
          "{}: the temperature of the {} is {:.2f} degC{}, expected one of a laboratory, 0 to 50 degC ({} of {} "
          "readings)",
          recording.where(static_cast<int>(found - readings.begin())), of, value, unit_of_temperature(value),
          std::count_if(readings.begin(), readings.end(), is_none), readings.size()));
    }
  };
  check_temperatures(&Reading::temperature, "artefact");
  check_temperatures(&Reading::arm_temperature, "arm");
  for (const Probe& probe : recording.arm.probes) {
    if (probe.radius != 0.0 && (probe.radius < min_radius || probe.radius > max_radius)) {
      sentences.push_back(fmt::format("the radius of the probe {} is {}, expected {} to {}; is its unit right?",
                                      in_quotes(probe.name), length_text(probe.radius), length_text(min_radius),
                                      length_text(max_radius)));
    }
  }
  return sentences;
}

}  // namespace artcal
