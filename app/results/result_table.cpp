#include "app/results/result_table.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/csv/csv_text.h"
#include "app/results/evaluation/recorded_evaluation.h"
#include "app/results/table_check.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

std::string field(const Json& value) {
  return value.is_null() ? "" : value.is_string() ? csv_field(value.get<std::string>()) : value.dump();
}

void flatten(const std::string& name, const Json& value, std::vector<std::pair<std::string, std::string>>& fields) {
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) {
      flatten(name.empty() ? key : name + "." + key, inner, fields);
    }
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      flatten(fmt::format("{}.{}", name, i + 1), value[i], fields);
    }
  } else {
    fields.emplace_back(name, field(value));
  }
}

const Json* found(const Json& at, std::initializer_list<const char*> path) {
  const Json* inner = &at;
  for (const char* key : path) {
    const auto next = inner->find(key);
    if (!inner->is_object() || next == inner->end()) {
      return nullptr;
    }
    inner = &*next;
  }
  return inner;
}

const Json& empty_list() {
  static const Json none = Json::array();
  return none;
}

const Json& list_at(const Json& result, std::initializer_list<const char*> path) {
  const Json* list = found(result, path);
  return list != nullptr && list->is_array() ? *list : empty_list();
}

// The residuals stand column by column: what is a list of as many numbers as there are readings is a column, what is a
// list of such lists one a component. REQUIRES: check_table() lets them pass.
Json reading_rows(const Json& result) {
  const Json& residuals = result.at("residuals");
  const std::size_t count = residuals.at("reading").size();
  const auto features = recorded_features(RecordedObject(result).object("after"));
  Json rows = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    Json row = Json::object();
    for (const auto& [key, column] : residuals.items()) {
      if (column.is_array() && column.size() == count && !column.empty() && !column.front().is_array()) {
        row[key] = column[i];
      } else if (column.is_array() && !column.empty() && column.front().is_array()) {
        Json& parts = row[key] = Json::array();
        for (const Json& component : column) {
          parts.push_back(i < component.size() ? component[i] : Json());
        }
      }
    }
    const RecordedFeature& feature = features[row.at("feature").get<std::size_t>()];
    row["artefact"] = feature.artefact;
    row["placement"] = feature.placement;
    row["feature"] = feature.feature;
    rows.push_back(std::move(row));
  }
  return rows;
}

Json length_rows(const Json& result) {
  Json rows = list_at(result, {"after", "lengths"});
  const auto is_length = [](const Json& value) { return found(value, {"second"}) && !value.at("second").is_null(); };
  for (const Json& value : list_at(result, {"values"})) {
    if (is_length(value)) {
      rows.push_back(value);
    }
  }
  return rows;
}

Json rows_of(const Json& result, std::string_view part) {
  if (part == "parameters") {
    return list_at(result, {"parameters"});
  }
  if (part == "readings") {
    return reading_rows(result);
  }
  return part == "lengths" ? length_rows(result) : list_at(result, {"values"});
}

}  // namespace

std::string csv_of_rows(const Json& rows) {
  std::vector<std::string> columns;
  std::map<std::string, std::size_t> places;
  std::vector<std::vector<std::pair<std::string, std::string>>> flat;
  for (const Json& row : rows) {
    flatten("", row, flat.emplace_back());
    for (const auto& [name, value] : flat.back()) {
      if (places.emplace(name, columns.size()).second) {
        columns.push_back(name);
      }
    }
  }
  std::string text;
  const auto add_line = [&](const std::vector<std::string>& fields) {
    text += fmt::format("{}\n", fmt::join(fields, ","));
  };
  std::vector<std::string> header;
  std::transform(columns.begin(), columns.end(), std::back_inserter(header),
                 [](const std::string& name) { return csv_field(name); });
  add_line(header);
  for (const auto& row : flat) {
    std::vector<std::string> line(columns.size());
    for (const auto& [name, value] : row) {
      line[places.at(name)] = value;
    }
    add_line(line);
  }
  return text;
}

std::vector<std::string> table_parts(const Json& result) {
  std::vector<std::string> parts;
  if (!list_at(result, {"parameters"}).empty()) {
    parts.emplace_back("parameters");
  }
  if (const Json* readings = found(result, {"residuals", "reading"}); readings != nullptr && readings->is_array()) {
    parts.emplace_back("readings");
  }
  const bool is_verification = found(result, {"values"}) && found(result, {"decision_rule"});
  if (is_verification) {
    parts.emplace_back("verdicts");
  }
  if (!length_rows(result).empty()) {
    parts.emplace_back("lengths");
  }
  if (!is_verification && !list_at(result, {"values"}).empty()) {
    parts.emplace_back("values");
  }
  return parts;
}

Expected<std::string> result_csv(const Json& result, std::string_view part) {
  const auto parts = table_parts(result);
  if (parts.empty()) {
    return bad_input("the result has no table: expected one of identify, verify or fit");
  }
  if (!part.empty() && std::find(parts.begin(), parts.end(), part) == parts.end()) {
    return bad_input(fmt::format("the result has no {}, but {}{}", in_quotes(part), fmt::join(parts, ", "),
                                 part == "readings" ? "; identify --no-residuals leaves the readings out" : ""));
  }
  const std::string_view asked = part.empty() ? std::string_view(parts.front()) : part;
  return check_table(result, asked).map([&] { return csv_of_rows(rows_of(result, asked)); });
}

}  // namespace artcal
