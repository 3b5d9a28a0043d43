#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "artefacts/dcc_document.h"
#include "core/in_quotes.h"

namespace artcal {
namespace {

using Node = pugi::xml_node;

constexpr const char* unsigned_data =
    "These are unsigned data, written by the program artcal. They are not a calibration certificate: no person has "
    "checked or signed them. They become one only where a calibration laboratory takes responsibility for them.";

// One line without control characters, and without the white space that the schema refuses at the ends.
std::string plain(const std::string& text) {
  std::string clean = text;
  for (auto control = find_control(clean); control; control = find_control(clean)) {
    clean.replace(control->offset, control->length, " ");
  }
  std::istringstream words(clean);
  std::string line;
  for (std::string word; words >> word;) {
    line += (line.empty() ? "" : " ") + word;
  }
  return line;
}

void add(Node parent, const char* name, const std::string& text) {
  parent.append_child(name).text().set(plain(text).c_str());
}

void add_unless_empty(Node parent, const char* name, const std::string& text) {
  if (!plain(text).empty()) {
    add(parent, name, text);
  }
}

Node add_text(Node parent, const char* name, const std::string& text) {
  Node named = parent.append_child(name);
  Node content = named.append_child("dcc:content");
  content.append_attribute("lang") = "en";
  content.text().set(plain(text).c_str());
  return named;
}

void add_software(Node administrative, const std::string& version) {
  Node software = administrative.append_child("dcc:dccSoftware").append_child("dcc:software");
  add_text(software, "dcc:name", "artcal");
  add(software, "dcc:release", version);
  add(software, "dcc:type", "application");
}

void add_core(Node administrative, const DccData& data) {
  Node core = administrative.append_child("dcc:coreData");
  add(core, "dcc:countryCodeISO3166_1", data.country);
  add(core, "dcc:usedLangCodeISO639_1", "en");
  add(core, "dcc:mandatoryLangCodeISO639_1", "en");
  add(core, "dcc:uniqueIdentifier", data.number);
  add(core, "dcc:beginPerformanceDate", data.begin);
  add(core, "dcc:endPerformanceDate", data.end);
  add(core, "dcc:performanceLocation", data.location);
}

void add_item(Node administrative, const DccItem& item) {
  Node node = administrative.append_child("dcc:items").append_child("dcc:item");
  add_text(node, "dcc:name", item.name);
  if (!plain(item.manufacturer).empty()) {
    add_text(node.append_child("dcc:manufacturer"), "dcc:name", item.manufacturer);
  }
  add_unless_empty(node, "dcc:model", item.model);
  Node identification = node.append_child("dcc:identifications").append_child("dcc:identification");
  add(identification, "dcc:issuer", "manufacturer");
  add(identification, "dcc:value", item.serial_number);
  add_text(identification, "dcc:name", "Serial number");
}

void add_contact(Node node, const DccContact& contact) {
  add_text(node, "dcc:name", contact.name);
  add_unless_empty(node, "dcc:eMail", contact.e_mail);
  Node location = node.append_child("dcc:location");
  add_unless_empty(location, "dcc:city", contact.city);
  add(location, "dcc:countryCode", contact.country);
  add_unless_empty(location, "dcc:postCode", contact.post_code);
  add_unless_empty(location, "dcc:street", contact.street);
  add_unless_empty(location, "dcc:streetNo", contact.street_number);
}

void add_persons(Node administrative, const std::vector<std::string>& names) {
  Node persons = administrative.append_child("dcc:respPersons");
  for (std::size_t i = 0; i < names.size(); ++i) {
    Node person = persons.append_child("dcc:respPerson");
    add_text(person.append_child("dcc:person"), "dcc:name", names[i]);
    add(person, "dcc:mainSigner", i == 0 ? "true" : "false");
  }
}

void add_statements(Node administrative, const std::vector<std::string>& statements) {
  Node list = administrative.append_child("dcc:statements");
  add_text(list.append_child("dcc:statement"), "dcc:declaration", unsigned_data);
  for (const auto& statement : statements) {
    add_text(list.append_child("dcc:statement"), "dcc:declaration", statement);
  }
}

void add_administrative(Node root, const DccDocument& document) {
  Node administrative = root.append_child("dcc:administrativeData");
  add_software(administrative, document.program_version);
  add_core(administrative, document.data);
  add_item(administrative, document.data.item);
  add_contact(administrative.append_child("dcc:calibrationLaboratory").append_child("dcc:contact"),
              document.data.laboratory);
  add_persons(administrative, document.data.responsible);
  add_contact(administrative.append_child("dcc:customer"), document.data.customer);
  add_statements(administrative, document.statements);
}

std::string decimal(double value) { return fmt::format("{}", value); }

void add_uncertainty(Node real, const DccUncertainty& uncertainty) {
  Node expanded = real.append_child("si:measurementUncertaintyUnivariate").append_child("si:expandedMU");
  add(expanded, "si:valueExpandedMU", decimal(uncertainty.U));
  add(expanded, "si:coverageFactor", decimal(uncertainty.k));
  add(expanded, "si:coverageProbability", decimal(uncertainty.probability.value_or(0.95)));
  add(expanded, "si:distribution", "normal");
}

const char* name_of(DccConformity conformity) {
  switch (conformity) {
    case DccConformity::Pass: return "pass";
    case DccConformity::Fail: return "fail";
    case DccConformity::NotShown: break;
  }
  return "noPass";
}

void add_entry(Node data, const DccEntry& entry) {
  Node quantity = data.append_child("dcc:quantity");
  if (!plain(entry.ref_type).empty()) {
    quantity.append_attribute("refType") = plain(entry.ref_type).c_str();
  }
  add_text(quantity, "dcc:name", entry.name);
  Node real = quantity.append_child("si:real");
  add(real, "si:value", decimal(entry.value));
  add(real, "si:unit", entry.unit);
  if (entry.uncertainty) {
    add_uncertainty(real, *entry.uncertainty);
  }
  if (entry.conformity) {
    Node meta = quantity.append_child("dcc:measurementMetaData").append_child("dcc:metaData");
    if (!plain(entry.limit).empty()) {
      add_text(meta, "dcc:declaration", entry.limit);
    }
    add(meta, "dcc:conformity", name_of(*entry.conformity));
  }
}

void add_results(Node root, const DccDocument& document) {
  Node measurement = root.append_child("dcc:measurementResults").append_child("dcc:measurementResult");
  add_text(measurement, "dcc:name", document.data.item.name);
  if (!document.methods.empty()) {
    Node methods = measurement.append_child("dcc:usedMethods");
    for (const DccMethod& method : document.methods) {
      Node node = methods.append_child("dcc:usedMethod");
      add_text(node, "dcc:name", method.name);
      add_text(node, "dcc:description", method.description);
    }
  }
  Node results = measurement.append_child("dcc:results");
  for (const DccResult& result : document.results) {
    Node node = results.append_child("dcc:result");
    add_text(node, "dcc:name", result.name);
    if (!plain(result.description).empty()) {
      add_text(node, "dcc:description", result.description);
    }
    Node data = node.append_child("dcc:data");
    for (const DccEntry& entry : result.entries) {
      add_entry(data, entry);
    }
  }
}

}  // namespace

std::string dcc_xml(const DccDocument& document) {
  pugi::xml_document xml;
  Node declaration = xml.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  Node root = xml.append_child("dcc:digitalCalibrationCertificate");
  for (const auto& [name, value] : {std::pair{"xmlns:dcc", "https://ptb.de/dcc"},
                                    {"xmlns:si", "https://ptb.de/si"},
                                    {"xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance"},
                                    {"xsi:schemaLocation", "https://ptb.de/dcc https://ptb.de/dcc/v3.3.0/dcc.xsd"},
                                    {"schemaVersion", "3.3.0"}}) {
    root.append_attribute(name) = value;
  }
  add_administrative(root, document);
  add_results(root, document);
  std::ostringstream text;
  xml.save(text, "  ", pugi::format_indent, pugi::encoding_utf8);
  return text.str();
}

}  // namespace artcal
