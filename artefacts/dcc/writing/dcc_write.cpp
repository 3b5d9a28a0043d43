#include "artefacts/dcc/writing/dcc_write.h"

#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "artefacts/dcc/dcc_nodes.h"
#include "artefacts/dcc/writing/dcc_administrative.h"

namespace artcal {
namespace {

using Node = pugi::xml_node;

std::string decimal(double value) { return fmt::format("{}", value); }

void add_uncertainty(Node& real, const DccUncertainty& uncertainty) {
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

void add_entry(Node& data, const DccEntry& entry) {
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

void add_results(Node& root, const DccDocument& document) {
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
