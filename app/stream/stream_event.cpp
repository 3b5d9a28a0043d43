#include "app/stream/stream_event.h"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/number_range.h"
#include "core/text/decimal_number.h"
#include "core/text/in_quotes.h"
#include "core/text/trimmed.h"

namespace artcal {
namespace {

using Value = std::function<Expected<double>(const StreamField&)>;
using Json = nlohmann::json;

constexpr int max_depth = 8;

Expected<double> number_of(std::string_view text, const StreamField& field) {
  text = trimmed(text);
  const auto value = decimal_number(text);
  if (!value || !is_in_range(*value)) {
    return bad_input(fmt::format("the field {} is {}, expected a finite number", in_quotes(field),
                                 in_quotes(std::string(text.substr(0, 40)))));
  }
  return *value;
}

Expected<double> number_in(const Json& event, const StreamField& field) {
  const Json* at = &event;
  for (std::size_t begin = 0; begin <= field.size();) {
    const std::size_t dot = std::min(field.find('.', begin), field.size());
    const auto found = at->is_object() ? at->find(field.substr(begin, dot - begin)) : at->end();
    if (!at->is_object() || found == at->end()) {
      return bad_input(fmt::format("the event has no field {}", in_quotes(field)));
    }
    at = &*found;
    begin = dot + 1;
  }
  if (at->is_boolean()) {
    return at->get<bool>() ? 1.0 : 0.0;
  }
  if (at->is_string()) {
    return number_of(at->get_ref<const std::string&>(), field);
  }
  if (!at->is_number() || !is_in_range(at->get<double>())) {
    return bad_input(fmt::format("the field {} is no finite number", in_quotes(field)));
  }
  return at->get<double>();
}

Expected<StreamEvent> read_fields(const StreamFormat& format, const Value& value) {
  StreamEvent event;
  std::optional<Error> wrong;
  const auto number = [&](const StreamField& field) {
    const auto read = value(field);
    if (!read && !wrong) {
      wrong = read.error();
    }
    return read.value_or(0.0);
  };
  event.joints.resize(static_cast<Eigen::Index>(format.joints.size()));
  for (std::size_t j = 0; j < format.joints.size(); ++j) {
    event.joints[static_cast<Eigen::Index>(j)] = format.joint_scale[j] * number(format.joints[j]);
  }
  if (!format.xyz.empty()) {
    event.tip_in_base =
        format.length_scale * Eigen::Vector3d(number(format.xyz[0]), number(format.xyz[1]), number(format.xyz[2]));
  }
  if (!format.time.empty()) {
    event.time = format.time_scale * number(format.time);
  }
  if (!format.temperature.empty()) {
    event.temperature = number(format.temperature);
  }
  event.pressed = format.button.empty() || number(format.button) != 0.0;
  const auto holds = [&](const std::optional<StreamCondition>& condition) {
    return !condition || number(condition->field) == condition->value;
  };
  event.at_rest = holds(format.at_rest);
  event.referenced = holds(format.referenced);
  event.off_end_stops = holds(format.end_stop);
  if (wrong) {
    return tl::unexpected(*wrong);
  }
  return event;
}

// Objects in objects, so deep that no driver makes them.
bool is_deep(std::string_view text) {
  int depth = 0;
  for (const char c : text) {
    depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
    if (depth > max_depth) {
      return true;
    }
  }
  return false;
}

}  // namespace

Expected<std::optional<StreamEvent>> parse_event(std::string_view line, const StreamFormat& format) {
  line = trimmed(line);
  if (line.empty() || (!format.is_json && !line.starts_with(format.prefix))) {
    return std::optional<StreamEvent>();
  }
  if (line.size() > max_event_bytes) {
    return bad_input(fmt::format("the line has more than {} bytes", max_event_bytes));
  }
  if (format.is_json) {
    const Json json = is_deep(line) ? Json(Json::value_t::discarded) : Json::parse(line, nullptr, false);
    if (!json.is_object()) {
      return bad_input("the line is no JSON object");
    }
    return read_fields(format, [&](const StreamField& field) { return number_in(json, field); })
        .map([](StreamEvent&& event) { return std::optional(std::move(event)); });
  }
  line.remove_prefix(format.prefix.size());
  if (!format.prefix.empty() && line.starts_with(format.delimiter)) {
    line.remove_prefix(1);
  }
  std::vector<std::string_view> columns;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(format.delimiter, begin), line.size());
    columns.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return read_fields(
             format,
             [&](const StreamField& field) -> Expected<double> {
               const auto column = static_cast<std::size_t>(std::stoul(field));
               if (column > columns.size()) {
                 return bad_input(fmt::format("the line has {} columns, expected a column {}", columns.size(), field));
               }
               return number_of(columns[column - 1], field);
             })
      .map([](StreamEvent&& event) { return std::optional(std::move(event)); });
}

}  // namespace artcal
