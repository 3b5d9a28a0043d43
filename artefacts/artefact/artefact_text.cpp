#include "artefacts/artefact/artefact_text.h"

#include <fmt/format.h>

#include "artefacts/artefact/artefact_type.h"
#include "core/toml/toml_text.h"

namespace artcal {
namespace {

constexpr double written_k = 2.0;

const char* kind_text(FeatureKind kind) {
  switch (kind) {
    case FeatureKind::Sphere: return "sphere";
    case FeatureKind::Plane: return "plane";
    case FeatureKind::Anchor: return "anchor";
    case FeatureKind::Coordinates: return "coordinates";
    case FeatureKind::Point: break;
  }
  return "point";
}

std::string line(const char* key, const std::string& value) { return fmt::format("{} = {}\n", key, value); }
std::string number_line(const char* key, double value) { return line(key, toml_number(value)); }
std::string text_line(const char* key, const std::string& text) {
  return text.empty() ? "" : line(key, toml_text(text));
}
std::string vector_line(const char* key, const Eigen::Vector3d& v) {
  return line(key, fmt::format("[{}, {}, {}]", toml_number(v.x()), toml_number(v.y()), toml_number(v.z())));
}

// "U_at", "k_at"; nothing where there is no uncertainty.
std::string uncertainty_lines(const std::string& of, double u) {
  return u > 0.0 ? number_line(("U" + of).c_str(), written_k * u) + number_line(("k" + of).c_str(), written_k) : "";
}

std::string head_text(const Artefact& artefact) {
  std::string text = text_line("schema", "artcal-artefact/1") + text_line("name", artefact.name);
  if (artefact.type != ArtefactType::Other) {
    text += text_line("type", std::string(name_of(artefact.type)));
  }
  text += text_line("note", artefact.note) + text_line("material", artefact.material) +
          text_line("supports", artefact.supports) + "units = { length = \"mm\" }\n";
  if (artefact.frame == CoordinateFrame::Base) {
    text += text_line("frame", "base");
  }
  if (artefact.expansion_is_known) {
    text += number_line("expansion_per_K", artefact.expansion);
  }
  if (artefact.u_expansion > 0.0) {
    text += number_line("u_expansion_per_K", artefact.u_expansion);
  }
  return text + number_line("reference_temperature_C", artefact.reference_temperature);
}

std::string certificate_text(const Certificate& certificate) {
  std::string text = text_line("number", certificate.number) + text_line("laboratory", certificate.laboratory);
  text += certificate.date.empty() ? "" : line("date", certificate.date);
  text += certificate.valid_until.empty() ? "" : line("valid_until", certificate.valid_until);
  return text.empty() ? "" : "\n[certificate]\n" + text;
}

std::string feature_text(const CertifiedFeature& feature) {
  std::string text = "\n[[feature]]\n" + text_line("name", feature.name) + text_line("kind", kind_text(feature.kind));
  if (feature.at) {
    text += vector_line("at", *feature.at) + uncertainty_lines("_at", feature.u_at);
  }
  if (feature.normal) {
    text += vector_line("normal", *feature.normal);
  }
  if (feature.kind == FeatureKind::Sphere) {
    text += feature.radius ? number_line("diameter", 2.0 * *feature.radius) : text_line("diameter", "unknown");
    text += uncertainty_lines("_diameter", 2.0 * feature.u_radius);
  }
  if (feature.form) {
    text += number_line("form", *feature.form) + uncertainty_lines("_form", feature.u_form);
  }
  return text + uncertainty_lines("", feature.u);
}

std::string distance_text(const Artefact& artefact, const CertifiedDistance& distance) {
  const auto name = [&](int feature) { return toml_text(artefact.features[static_cast<std::size_t>(feature)].name); };
  return "\n[[distance]]\n" + line("between", fmt::format("[{}, {}]", name(distance.first), name(distance.second))) +
         number_line("value", distance.value) + uncertainty_lines("", distance.u);
}

}  // namespace

std::string artefact_file_text(const Artefact& artefact, const std::vector<std::string>& comment) {
  std::string text;
  for (const std::string& words : comment) {
    text += fmt::format("# {}\n", words);
  }
  text += head_text(artefact) + certificate_text(artefact.certificate);
  for (const CertifiedFeature& feature : artefact.features) {
    text += feature_text(feature);
  }
  for (const CertifiedDistance& distance : artefact.distances) {
    text += distance_text(artefact, distance);
  }
  return text;
}

}  // namespace artcal
