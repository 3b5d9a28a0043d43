#include "app/results/artefact_summary.h"

#include <fmt/format.h>

#include "app/output/text_or_null.h"
#include "artefacts/artefact/artefact_type.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t widest = 60;

bool has_certificate(const Artefact& artefact) {
  const Certificate& c = artefact.certificate;
  return !(c.number.empty() && c.laboratory.empty() && c.date.empty() && c.valid_until.empty());
}

Json certificate_json(const Artefact& artefact) {
  if (!has_certificate(artefact)) {
    return nullptr;
  }
  return {{"number", text_or_null(artefact.certificate.number)},
          {"laboratory", text_or_null(artefact.certificate.laboratory)},
          {"date", text_or_null(artefact.certificate.date)},
          {"valid_until", text_or_null(artefact.certificate.valid_until)}};
}

}  // namespace

Json artefacts_json(const std::vector<Artefact>& artefacts) {
  Json json = Json::array();
  for (const Artefact& artefact : artefacts) {
    json.push_back({{"name", artefact.name},
                    {"type", artefact.type == ArtefactType::Other ? Json(nullptr) : Json(name_of(artefact.type))},
                    {"certificate", certificate_json(artefact)}});
  }
  return json;
}

std::string artefact_in_words(const Artefact& artefact) {
  const Certificate& certificate = artefact.certificate;
  std::string text = fmt::format("{} {}", name_of(artefact.type), in_quotes(artefact.name));
  if (has_certificate(artefact)) {
    text += ", certificate";
  }
  if (!certificate.number.empty()) {
    text += " " + truncated(widest, certificate.number);
  }
  if (!certificate.laboratory.empty()) {
    text += " of " + truncated(widest, certificate.laboratory);
  }
  if (!certificate.date.empty()) {
    text += ", " + certificate.date;
  }
  if (!certificate.valid_until.empty()) {
    text += ", valid until " + certificate.valid_until;
  }
  return text;
}

std::string artefacts_text(const std::vector<Artefact>& artefacts) {
  std::string text;
  for (const Artefact& artefact : artefacts) {
    if (has_certificate(artefact)) {
      text += artefact_in_words(artefact) + "\n";
    }
  }
  return text;
}

}  // namespace artcal
