#include "artefacts/dcc/writing/dcc_data_file.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "core/toml/toml_document.h"

namespace artcal {
namespace {

constexpr std::string_view dcc_data_schema = "artcal-dcc-data/1";
constexpr std::array<std::string_view, 5> locations{"laboratory", "customer", "laboratoryBranch", "customerBranch",
                                                    "other"};

// A text of one line with something in it.
std::string filled(TomlTable& table, std::string_view key) {
  std::string text = table.name(key);
  if (text.find_first_not_of(' ') == std::string::npos) {
    table.fail(key, fmt::format("`{}` is empty; a certificate needs it", key));
  }
  return text;
}

std::string country(TomlTable& table) {
  const std::string code = table.name("country");
  if (code.size() != 2 || !std::all_of(code.begin(), code.end(), [](char c) { return c >= 'A' && c <= 'Z'; })) {
    table.fail("country", fmt::format("`country` is {}, expected the two capital letters of ISO 3166-1, such as \"DE\"",
                                      in_quotes(code)));
  }
  return code;
}

DccContact read_contact(TomlTable table) {
  return {filled(table, "name"),          table.name_or("street", ""), table.name_or("street_number", ""),
          table.name_or("post_code", ""), filled(table, "city"),       country(table),
          table.name_or("e_mail", "")};
}

DccItem read_item(TomlTable table) {
  return {filled(table, "name"), table.name_or("manufacturer", ""), table.name_or("model", ""),
          filled(table, "serial_number")};
}

std::vector<std::string> read_persons(TomlTable& root) {
  auto persons = root.texts("responsible");
  const bool bad = std::any_of(persons.begin(), persons.end(), [](const std::string& name) {
    return find_control(name) || name.find_first_not_of(' ') == std::string::npos;
  });
  if (persons.empty() || bad) {
    root.fail("responsible", "expected the responsible persons, such as responsible = [\"A. Person\"]");
  }
  return persons;
}

DccData read_data(TomlTable& root) {
  DccData data;
  data.number = filled(root, "number");
  data.country = country(root);
  data.begin = root.date("begin");
  data.end = root.date("end");
  if (data.end < data.begin) {
    root.fail("end", fmt::format("the measurement ends on {}, before it begins on {}", data.end, data.begin));
  }
  data.location = root.text("location");
  if (std::find(locations.begin(), locations.end(), data.location) == locations.end()) {
    root.fail("location", fmt::format("`location` is {}, expected \"laboratory\", \"customer\", \"laboratoryBranch\", "
                                      "\"customerBranch\" or \"other\"",
                                      in_quotes(data.location)));
  }
  data.responsible = read_persons(root);
  data.laboratory = read_contact(root.table("laboratory"));
  data.customer = read_contact(root.table("customer"));
  data.item = read_item(root.table("item"));
  return data;
}

}  // namespace

Expected<DccDataFile> read_dcc_data(const std::filesystem::path& path) {
  auto document = TomlDocument::read(path, dcc_data_schema);
  if (!document) {
    return tl::unexpected(document.error());
  }
  DccDataFile result{read_data(document->root()), {path.string(), document->sha256()}};
  if (auto finished = document->finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  return result;
}

}  // namespace artcal
