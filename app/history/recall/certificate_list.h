#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/history/recall/certificate_use.h"

namespace artcal {

/// The results that rest on a certificate, for a person.
std::string to_text(const std::string& certificate, const std::vector<CertificateUse>& uses);

/// The same as JSON. Schema: docs/result-schema.md, "certificate_uses". `store`: its name.
nlohmann::ordered_json to_json(const std::string& certificate, const std::vector<CertificateUse>& uses,
                               const std::string& store);

/// The same as a page that needs nothing beside itself.
std::string certificate_page(const nlohmann::ordered_json& list);

}  // namespace artcal
