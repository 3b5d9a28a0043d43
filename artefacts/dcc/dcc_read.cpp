#include "artefacts/dcc/dcc_read.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include "artefacts/dcc/dcc_quantity.h"
#include "core/calendar_date.h"
#include "core/files/size_limits.h"
#include "core/files/text_file.h"
#include "core/text/in_quotes.h"
#include "core/xml/xml.h"

namespace artcal {
namespace {

constexpr std::string_view dcc_namespace = "https://ptb.de/dcc";

// The namespace that an element's prefix is bound to, where it is bound on the element itself.
std::string_view namespace_of(const pugi::xml_node& node) {
  const std::string name = node.name();
  const auto colon = name.find(':');
  const std::string attribute = colon == std::string::npos ? "xmlns" : "xmlns:" + name.substr(0, colon);
  return node.attribute(attribute.c_str()).value();
}

Expected<void> check_root(const XmlSource& source, const pugi::xml_node& root) {
  if (local_name(root) != "digitalCalibrationCertificate" || namespace_of(root) != dcc_namespace) {
    return bad_input(fmt::format("this is no digital calibration certificate: its root is {}, expected "
                                 "digitalCalibrationCertificate of {}",
                                 in_quotes(root.name()), dcc_namespace),
                     source.file().path.string());
  }
  const std::string version = root.attribute("schemaVersion").value();
  if (!version.starts_with("2.") && !version.starts_with("3.")) {
    return bad_input(fmt::format("the certificate's schemaVersion is {}, expected 2.x or 3.x", in_quotes(version)),
                     source.place_of(root));
  }
  return {};
}

// A name in English, or else in the first language.
std::string name_of(const pugi::xml_node& named) {
  std::string first;
  for (const pugi::xml_node& content : child_of(named, "name").children()) {
    if (local_name(content) != "content") {
      continue;
    }
    if (first.empty() || std::string_view(content.attribute("lang").value()) == "en") {
      first = in_one_line_of_words(text_of(content));
    }
  }
  return truncated(200, first);
}

Expected<Certificate> read_certificate(const XmlSource& source, const pugi::xml_node& administrative) {
  const pugi::xml_node core = child_of(administrative, "coreData");
  Certificate certificate;
  certificate.number = truncated(200, in_one_line_of_words(text_of(child_of(core, "uniqueIdentifier"))));
  certificate.laboratory = name_of(child_of(child_of(administrative, "calibrationLaboratory"), "contact"));
  const pugi::xml_node end = child_of(core, "endPerformanceDate");
  certificate.date = text_of(end).substr(0, 10);  // xs:date may carry a time zone
  if (!is_calendar_date(certificate.date)) {
    return bad_input(fmt::format("endPerformanceDate is {}, expected a day of the calendar such as 2026-03-02",
                                 in_quotes(text_of(end))),
                     source.place_of(end ? end : administrative));
  }
  return certificate;
}

// Quantities of dcc:data and dcc:list. Recursion ends: parse_xml() bounds the nesting.
void collect(const XmlSource& source, const pugi::xml_node& parent,
             std::vector<std::shared_ptr<const DccLabels>> within, std::vector<DccQuantity>& found) {
  within.push_back(std::make_shared<const DccLabels>(dcc_labels(parent)));
  for (const pugi::xml_node& node : parent.children()) {
    const std::string_view name = local_name(node);
    if (name == "list" || name == "data") {
      collect(source, node, within, found);
    } else if (name == "quantity") {
      if (auto quantity = read_quantity(source, node)) {
        quantity->within = within;
        found.push_back(std::move(*quantity));
      }
    }
  }
}

}  // namespace

bool looks_like_xml(const TextFile& file) {
  const auto first = file.text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && file.text[first] == '<';
}

Expected<DccCertificate> read_dcc(const TextFile& file) {
  const XmlSource source(file);
  pugi::xml_document document;
  if (auto parsed = parse_xml(source, document); !parsed) {
    return tl::unexpected(parsed.error());
  }
  const pugi::xml_node root = document.document_element();
  if (auto checked = check_root(source, root); !checked) {
    return tl::unexpected(checked.error());
  }
  const pugi::xml_node administrative = child_of(root, "administrativeData");
  auto certificate = read_certificate(source, administrative);
  if (!certificate) {
    return tl::unexpected(certificate.error());
  }
  DccCertificate result{{file.path.string(), file.sha256},
                        root.attribute("schemaVersion").value(),
                        std::move(*certificate),
                        name_of(child_of(child_of(administrative, "items"), "item")),
                        static_cast<bool>(child_of(root, "Signature")),
                        {}};
  for (const pugi::xml_node& measurement : child_of(root, "measurementResults").children()) {
    const auto labels = std::make_shared<const DccLabels>(dcc_labels(measurement));
    for (const pugi::xml_node& node : child_of(measurement, "results").children()) {
      collect(source, node, {labels}, result.quantities);
    }
  }
  return result;
}

Expected<DccCertificate> read_dcc_file(const std::filesystem::path& path) {
  return read_text_file(path, largest::certificate).and_then([](const TextFile& file) { return read_dcc(file); });
}

}  // namespace artcal
