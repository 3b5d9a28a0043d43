#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "artefacts/artefact/artefact.h"

namespace artcal {

/// The artefacts of a result as JSON: what they are, by which certificate (docs/result-schema.md, "artefact").
nlohmann::ordered_json artefacts_json(const std::vector<Artefact>& artefacts);

/// A line for each artefact that has a certificate; empty where none has.
std::string artefacts_text(const std::vector<Artefact>& artefacts);

/// "ball bar, certificate 4711 of Laboratory, 2026-03-02, valid until 2028-03-01": what is known of it.
std::string artefact_in_words(const Artefact& artefact);

}  // namespace artcal
