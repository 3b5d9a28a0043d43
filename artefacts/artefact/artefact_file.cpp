#include "artefacts/artefact/artefact_file.h"

#include <cmath>

#include <fmt/format.h>

#include "artefacts/artefact/artefact_type.h"
#include "artefacts/artefact/artefact_values.h"
#include "artefacts/artefact/geometry_tables.h"
#include "artefacts/certificate/certificate.h"
#include "artefacts/dcc/dcc_read.h"
#include "artefacts/dcc/dcc_select.h"
#include "core/files/size_limits.h"
#include "core/files/text_file.h"
#include "core/text/in_quotes.h"
#include "core/toml/toml_document.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr std::string_view artefact_schema = "artcal-artefact/1";

ArtefactType read_type(TomlTable& root) {
  if (!root.has("type")) {
    return ArtefactType::Other;
  }
  const std::string name = root.text("type");
  const auto type = artefact_type(name);
  if (!type) {
    root.fail("type", fmt::format("the type is {}, expected one of {}", in_quotes(name), artefact_type_names()));
  }
  return type.value_or(ArtefactType::Other);
}

CoordinateFrame read_frame(TomlTable& root) {
  const std::string frame = root.text_or("frame", "artefact");
  if (frame != "artefact" && frame != "base") {
    root.fail("frame", fmt::format("frame is {}, expected \"artefact\" (pose unknown) or \"base\" (the arm's)",
                                   in_quotes(frame)));
  }
  return frame == "base" ? CoordinateFrame::Base : CoordinateFrame::Artefact;
}

// Stated as U with its k, or as a standard uncertainty; 1/K.
double read_u_expansion(TomlTable& root) {
  const bool expanded = root.has("U_expansion_per_K");
  const char* key = expanded ? "U_expansion_per_K" : "u_expansion_per_K";
  if (!root.has(key)) {
    return 0.0;
  }
  if (expanded && root.has("u_expansion_per_K")) {
    root.fail("u_expansion_per_K", "state U_expansion_per_K with k_expansion, or u_expansion_per_K, not both");
  }
  if (!root.has("expansion_per_K")) {
    root.fail(key, "the uncertainty of an expansion is stated, but not the expansion itself (expansion_per_K)");
  }
  const double u = root.number(key) / (expanded ? root.number("k_expansion") : 1.0);
  if (!(u > 0.0) || u > 1e-4) {
    root.fail(key, fmt::format("a standard uncertainty of {} per kelvin is none, expected some 1e-6", u));
  }
  return u;
}

void read_expansion(TomlTable& root, Artefact& artefact) {
  artefact.expansion_is_known = root.has("expansion_per_K");
  artefact.expansion = root.number_or("expansion_per_K", 0.0);
  if (std::abs(artefact.expansion) > 1e-3) {
    root.fail("expansion_per_K",
              fmt::format("an expansion of {} per kelvin is no solid's; steel is 11.5e-6", artefact.expansion));
  }
  artefact.u_expansion = read_u_expansion(root);
  artefact.reference_temperature = root.number_or("reference_temperature_C", 20.0);
}

ArtefactValues read_values(TomlTable& root, const Artefact& artefact) {
  TomlTable units = root.table("units");
  ArtefactValues values;
  values.length = length_unit(units, "length");
  values.reference_temperature = artefact.reference_temperature;
  if (artefact.expansion_is_known) {
    values.expansion = artefact.expansion;
  }
  values.u_expansion = artefact.u_expansion;
  read_rules(root.table("uncertainty"), values);
  return values;
}

Artefact read_artefact(TomlTable& root, const std::filesystem::path& path, const DccCertificate* dcc) {
  Artefact artefact;
  artefact.name = root.name_or("name", truncated(80, path.stem().string()));
  artefact.type = read_type(root);
  artefact.note = root.text_or("note", "");
  artefact.material = root.name_or("material", "");
  artefact.supports = root.name_or("supports", "");
  artefact.certificate = read_certificate(root.table("certificate"), dcc != nullptr ? dcc->certificate : Certificate{});
  artefact.frame = read_frame(root);
  read_expansion(root, artefact);
  ArtefactValues values = read_values(root, artefact);
  values.dcc = dcc;
  read_geometry(root, values, artefact);
  return artefact;
}

// A certificate says what was measured, not which feature of the artefact each number is.
tl::unexpected<Error> wants_an_artefact_file(const TextFile& file) {
  const auto certificate = read_dcc(file);
  if (!certificate) {
    return tl::unexpected(certificate.error());
  }
  return bad_input(fmt::format("this is a digital certificate; write an artefact file with dcc = {} that says which "
                               "feature each number belongs to (docs/files.md). It has: {}",
                               in_quotes(file.path.filename().string()), list_of_quantities(*certificate)),
                   file.path.string());
}

}  // namespace

Expected<ArtefactFile> read_artefact_file(const std::filesystem::path& path) {
  return read_artefact_file(path, FileAccess::anywhere());
}

Expected<ArtefactFile> read_artefact_file(const std::filesystem::path& path, const FileAccess& access) {
  const auto file = read_text_file(path, largest::toml);
  if (!file) {
    return tl::unexpected(file.error());
  }
  if (looks_like_xml(*file)) {
    return wants_an_artefact_file(*file);
  }
  auto document = TomlDocument::parse(*file, artefact_schema);
  if (!document) {
    return tl::unexpected(document.error());
  }
  TomlTable& root = document->root();
  std::optional<DccCertificate> dcc;
  if (root.is_text("dcc")) {
    auto read = access.resolve(path.parent_path(), root.text("dcc"), root.where("dcc")).and_then([](const auto& found) {
      return read_dcc_file(found);
    });
    if (!read) {
      return tl::unexpected(read.error());
    }
    dcc = std::move(*read);
  }
  ArtefactFile result{read_artefact(root, path, dcc ? &*dcc : nullptr),
                      {path.string(), document->sha256()},
                      dcc ? std::optional(dcc->input) : std::nullopt,
                      root.is_text("dcc") ? root.text("dcc") : ""};
  if (auto finished = document->finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  return result;
}

}  // namespace artcal
