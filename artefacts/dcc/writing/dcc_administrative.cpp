#include "artefacts/dcc/writing/dcc_administrative.h"

#include <pugixml.hpp>

#include "artefacts/dcc/dcc_nodes.h"

namespace artcal {
namespace {

using Node = pugi::xml_node;

constexpr const char* unsigned_data =
    "These are unsigned data, written by the program artcal. They are not a calibration certificate: no person has "
    "checked or signed them. They become one only where a calibration laboratory takes responsibility for them.";

void add_software(Node& administrative, const std::string& version) {
  Node software = administrative.append_child("dcc:dccSoftware").append_child("dcc:software");
  add_text(software, "dcc:name", "artcal");
  add(software, "dcc:release", version);
  add(software, "dcc:type", "application");
}

void add_core(Node& administrative, const DccData& data) {
  Node core = administrative.append_child("dcc:coreData");
  add(core, "dcc:countryCodeISO3166_1", data.country);
  add(core, "dcc:usedLangCodeISO639_1", "en");
  add(core, "dcc:mandatoryLangCodeISO639_1", "en");
  add(core, "dcc:uniqueIdentifier", data.number);
  add(core, "dcc:beginPerformanceDate", data.begin);
  add(core, "dcc:endPerformanceDate", data.end);
  add(core, "dcc:performanceLocation", data.location);
}

void add_item(Node& administrative, const DccItem& item) {
  Node node = administrative.append_child("dcc:items").append_child("dcc:item");
  add_text(node, "dcc:name", item.name);
  if (!plain(item.manufacturer).empty()) {
    Node manufacturer = node.append_child("dcc:manufacturer");
    add_text(manufacturer, "dcc:name", item.manufacturer);
  }
  add_unless_empty(node, "dcc:model", item.model);
  Node identification = node.append_child("dcc:identifications").append_child("dcc:identification");
  add(identification, "dcc:issuer", "manufacturer");
  add(identification, "dcc:value", item.serial_number);
  add_text(identification, "dcc:name", "Serial number");
}

void add_contact(Node& node, const DccContact& contact) {
  add_text(node, "dcc:name", contact.name);
  add_unless_empty(node, "dcc:eMail", contact.e_mail);
  Node location = node.append_child("dcc:location");
  add_unless_empty(location, "dcc:city", contact.city);
  add(location, "dcc:countryCode", contact.country);
  add_unless_empty(location, "dcc:postCode", contact.post_code);
  add_unless_empty(location, "dcc:street", contact.street);
  add_unless_empty(location, "dcc:streetNo", contact.street_number);
}

void add_persons(Node& administrative, const std::vector<std::string>& names) {
  Node persons = administrative.append_child("dcc:respPersons");
  for (std::size_t i = 0; i < names.size(); ++i) {
    Node person = persons.append_child("dcc:respPerson");
    Node contact = person.append_child("dcc:person");
    add_text(contact, "dcc:name", names[i]);
    add(person, "dcc:mainSigner", i == 0 ? "true" : "false");
  }
}

void add_statement(Node& list, const std::string& text) {
  Node statement = list.append_child("dcc:statement");
  add_text(statement, "dcc:declaration", text);
}

void add_statements(Node& administrative, const std::vector<std::string>& statements) {
  Node list = administrative.append_child("dcc:statements");
  add_statement(list, unsigned_data);
  for (const auto& statement : statements) {
    add_statement(list, statement);
  }
}

}  // namespace

void add_administrative(pugi::xml_node& root, const DccDocument& document) {
  Node administrative = root.append_child("dcc:administrativeData");
  add_software(administrative, document.program_version);
  add_core(administrative, document.data);
  add_item(administrative, document.data.item);
  Node laboratory = administrative.append_child("dcc:calibrationLaboratory").append_child("dcc:contact");
  add_contact(laboratory, document.data.laboratory);
  add_persons(administrative, document.data.responsible);
  Node customer = administrative.append_child("dcc:customer");
  add_contact(customer, document.data.customer);
  add_statements(administrative, document.statements);
}

}  // namespace artcal
