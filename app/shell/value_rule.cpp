#include "app/shell/value_rule.h"

#include <algorithm>
#include <array>
#include <regex>
#include <utility>

#include <fmt/format.h>

namespace artcal {
namespace {

using Number = ValueRule::Number;

Number number_named(std::string_view type) {
  if (type == "INT" || type == "UINT") {
    return Number::Whole;
  }
  return type == "FLOAT" ? Number::Real : Number::No;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  return parts;
}

std::string with_or(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  }
  return text;
}

// By the last word of a type's name, which may be a list of kinds such as ARM|RECORDING.
struct Kind {
  std::string_view type;
  FileKind kind;
};

const std::vector<Kind>& kinds() {
  using enum FileKind::Kind;
  static const std::vector<std::string> clouds{"pcd", "ply", "xyz", "txt", "csv", "asc", "pts", "ptx", "obj", "stl"};
  static const std::vector<Kind> table{
      {"RECORDING", {Files, {"toml"}}},
      {"ARM", {Files, {"toml"}}},
      {"PLAN", {Files, {"toml"}}},
      {"ARTEFACT", {Files, {"toml"}}},
      {"FILE.toml", {Files, {"toml"}}},
      {"FILE.html", {Files, {"html"}}},
      {"FILE.json", {Files, {"json"}}},
      {"RESULT", {Files, {"json"}}},
      {"CSV", {Files, {"csv"}}},
      {"SVG", {Files, {"svg"}}},
      {"POINTS", {Files, clouds}},
      {"SCAN", {Files, clouds}},
      {"STORE", {Files, {"sqlite"}}},
      {"OUT", {Files, {"sqlite"}}},
      {"FOLDER", {Folders, {}}},
      {"PATH", {Files, {}}},
      {"FILE", {Files, {}}},
      {"N", {}},
      {"X", {}},
      {"TEXT", {}},
      {"NAME", {}},
      {"NAMES", {}},
      {"NUMBER", {}},
      {"WORD", {}},
      {"KIND", {}},
      {"MODEL", {}},
      {"GOAL", {}},
      {"SIZE", {}},
      {"K/N", {}},
      {"HEIGHT", {}},
      {"X,Y,Z", {}},
      {"R,P,Y", {}},
      {"X1,X2,Y1,Y2,TOP", {}},
      {"LENGTH", {}},
      {"COMMAND", {}},
      {"SHELL", {}},
      {"STANDARD", {}},
  };
  return table;
}

}  // namespace

std::string ValueRule::shortly() const {
  if (!choices.empty()) {
    return with_or(choices);
  }
  if (!least.empty() && !greatest.empty()) {
    return fmt::format("{} to {}", least, greatest);
  }
  return least.empty() ? "" : least + " or more";
}

std::string ValueRule::expected() const {
  if (!choices.empty()) {
    return with_or(choices);
  }
  const std::string_view kind = number == Number::Whole ? "a whole number" : number == Number::Real ? "a number" : "";
  if (!kind.empty() && !least.empty()) {
    return greatest.empty() ? fmt::format("{} of {} or more", kind, least)
                            : fmt::format("{} from {} to {}", kind, least, greatest);
  }
  return std::string(kind);
}

ValueRule value_rule(std::string_view type) {
  ValueRule rule;
  const std::string text(type);
  rule.number = number_named(text.substr(0, text.find(':')));
  static const std::regex choices(R"(:\{([^{}]*)\})");
  static const std::regex range(R"(:(INT|UINT|FLOAT) in \[(\S+) - (\S+)\])");
  std::smatch found;
  if (std::regex_search(text, found, choices)) {
    rule.choices = split(found[1]);
  } else if (std::regex_search(text, found, range)) {
    rule.number = number_named(found[1].str());
    rule.least = found[2];
    rule.greatest = found[3];
  } else if (text.ends_with(":NONNEGATIVE")) {
    rule.least = "0";
  } else if (text.ends_with(":POSITIVE")) {
    rule.least = rule.number == Number::Whole ? "1" : "";
  }
  return rule;
}

std::string shown_type(std::string_view type) {
  const std::string_view name = type.substr(0, type.find(':'));
  if (name == "TEXT" && !value_rule(type).choices.empty()) {
    return "WORD";
  }
  switch (number_named(name)) {
    case Number::Whole: return "N";
    case Number::Real: return "X";
    default: return std::string(name);
  }
}

FileKind file_kind(std::string_view shown_type) {
  FileKind all;
  constexpr std::string_view more = "…";
  if (shown_type.ends_with(more)) {
    shown_type.remove_suffix(more.size());
  }
  for (std::size_t at = 0; at <= shown_type.size();) {
    const std::size_t end = std::min(shown_type.find('|', at), shown_type.size());
    const std::string_view one = shown_type.substr(at, end - at);
    const auto known = std::find_if(kinds().begin(), kinds().end(), [&](const Kind& kind) { return kind.type == one; });
    const FileKind kind = known == kinds().end() ? FileKind{FileKind::Kind::Files, {}} : known->kind;
    all.kind = kind.kind == FileKind::Kind::None ? all.kind : kind.kind;
    for (const std::string& ending : kind.endings) {
      if (std::find(all.endings.begin(), all.endings.end(), ending) == all.endings.end()) {
        all.endings.push_back(ending);
      }
    }
    at = end + 1;
  }
  return all;
}

}  // namespace artcal
