#include "core/toml/toml_document.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "core/calendar_date.h"
#include "core/files/size_limits.h"
#include "core/number_range.h"
#include "core/text/decimal_comma.h"
#include "core/text/digits.h"
#include "core/text/in_quotes.h"
#include "core/text/name_list.h"
#include "core/toml/toml_keys.h"

namespace artcal {

struct TomlTable::Shared {
  toml::table document;
  std::string path;
  std::optional<Error> first_error;
  std::set<const toml::node*> read;
  std::map<const void*, std::vector<std::string>> asked;  ///< of each table, the keys that a reader looked for
};

namespace {

const toml::table& as_table(const void* table) { return *static_cast<const toml::table*>(table); }

std::string position(const std::string& path, const toml::source_region& source) {
  if (source.begin.line == 0) {
    return path;
  }
  return fmt::format("{}:{}:{}", path, source.begin.line, source.begin.column);
}

// Whether a text was written for this program. The path of a file of any other kind may be a mistake or an attempt to
// have it shown: no message quotes what is in it.
bool says_artcal(std::string_view text) { return text.find("artcal-") != std::string_view::npos; }

// What a text that is no TOML is, as far as its beginning tells; nothing of it is shown.
std::string_view kind_of_text(std::string_view text) {
  const std::string_view begin = text.substr(0, 2000);
  const std::size_t first = begin.find_first_not_of(" \t\r\n");
  const std::string_view line =
      first == std::string_view::npos ? begin : begin.substr(first, begin.find('\n', first) - first);
  const auto commas = std::count(line.begin(), line.end(), ','), semicolons = std::count(line.begin(), line.end(), ';');
  return begin.find("<robot") != std::string_view::npos          ? "a description of a robot (URDF)"
         : line.starts_with("<")                                 ? "XML or HTML"
         : line.starts_with("{")                                 ? "JSON"
         : line.starts_with("ply") || line.starts_with("# .PCD") ? "a point cloud"
         : std::max(commas, semicolons) > 0 && line.find('=') == std::string_view::npos
             ? "a table of values (CSV), such as a recording names"
             : "not valid TOML";
}

std::string_view line_at(std::string_view text, std::size_t number) {
  for (std::size_t i = 1; i < number && !text.empty(); ++i) {
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  }
  return text.substr(0, text.find('\n'));
}

// Every text that is parsed here passes this first: toml++ takes deep tables apart by recursion.
Expected<toml::table> guarded_parse(const TextFile& file, std::string_view schema) {
  const std::string path = file.path.string();
  if (const int line = line_of_endless_key(file.text); line > 0) {
    return bad_input("a key has more parts than any that is known here", fmt::format("{}:{}", path, line));
  }
  try {
    return toml::parse(file.text, path);
  } catch (const toml::parse_error& error) {
    return bad_input(says_artcal(file.text)
                         ? fmt::format("this is not valid TOML: {}{}", truncated(200, error.description()),
                                       decimal_comma_question_of_line(line_at(file.text, error.source().begin.line)))
                         : fmt::format("this is {}, expected a file that begins with schema = \"{}\"",
                                       kind_of_text(file.text), schema),
                     position(path, error.source()));
  }
}

std::string_view kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "an array";
    case toml::node_type::string: return "text";
    case toml::node_type::integer:
    case toml::node_type::floating_point: return "a number";
    case toml::node_type::boolean: return "true or false";
    default: return "a date or time";
  }
}

std::optional<double> number_of(const toml::node& node) {
  if (!node.is_number()) {
    return std::nullopt;
  }
  const double value = node.value<double>().value_or(std::nan(""));
  return is_in_range(value) ? std::optional(value) : std::nullopt;
}

std::string_view expected_number(const toml::node& node) {
  return std::isfinite(node.value<double>().value_or(std::nan(""))) ? "a number of at most 1e100" : "a finite number";
}

// "artcal-arm/1": what a schema is called, in any program.
bool is_schema_name(std::string_view text) {
  const auto all_of = [](std::string_view part, auto is) {
    return !part.empty() && std::all_of(part.begin(), part.end(), is);
  };
  const std::size_t slash = text.find('/');
  return slash != std::string_view::npos && text.size() <= 40 &&
         all_of(text.substr(0, slash), [](char c) { return (c >= 'a' && c <= 'z') || c == '-'; }) &&
         all_of(text.substr(slash + 1), is_digit);
}

/// A key that no reader asked for, what it holds and the table that it stands in.
struct UnreadKey {
  const toml::key* key = nullptr;
  const toml::node* node = nullptr;
  const toml::table* table = nullptr;
};

// The first in the file.
UnreadKey first_unread(const toml::table& table, const std::set<const toml::node*>& read) {
  UnreadKey first;
  const auto earlier = [&](const UnreadKey& found) {
    if (found.key != nullptr && (first.key == nullptr || found.key->source().begin < first.key->source().begin)) {
      first = found;
    }
  };
  for (const auto& [key, node] : table) {
    if (!read.contains(&node)) {
      earlier({&key, &node, &table});
    } else if (const auto* inner = node.as_table()) {
      earlier(first_unread(*inner, read));
    } else if (const auto* array = node.as_array()) {
      for (const auto& element : *array) {
        if (const auto* row = element.as_table()) {
          earlier(first_unread(*row, read));
        }
      }
    }
  }
  return first;
}

// "[[placements]]" or "[errors]" as it stands in the file; empty of what is no table.
std::string heading_of(const UnreadKey& unread) {
  const std::string name = truncated(40, unread.key->str());
  return unread.node->is_array_of_tables() ? "[[" + name + "]]" : unread.node->is_table() ? "[" + name + "]" : "";
}

std::string unread_in_words(const UnreadKey& unread, const std::vector<std::string>& asked) {
  const std::string heading = heading_of(unread);
  std::vector<std::string> known;
  std::copy_if(asked.begin(), asked.end(), std::back_inserter(known),
               [&](const std::string& key) { return unread.table->get(key) == nullptr; });
  const std::string nearest = nearest_name(unread.key->str(), known);
  return fmt::format(
      "{} is not a key that is known here{}; is it misspelt, or in the wrong table?{}{}", in_quotes(unread.key->str()),
      heading.empty() ? "" : " (of the table " + heading + ")",
      nearest.empty() ? "" : fmt::format(" The nearest that is known is {}", in_quotes(nearest)),
      known.empty() ? "" : fmt::format("{} There could be: {}", nearest.empty() ? "" : ".", listed_names(known)));
}

// A key that is nearly one that was looked for in vain: it says more of the case than what is missed without it.
UnreadKey misspelt_key(const toml::table& root, const std::vector<std::string>& asked) {
  UnreadKey first;
  for (const auto& [key, node] : root) {
    if (std::find(asked.begin(), asked.end(), key.str()) != asked.end()) {
      continue;
    }
    const std::string nearest = nearest_name(key.str(), asked);
    const bool is_first = first.key == nullptr || key.source().begin < first.key->source().begin;
    if (!nearest.empty() && root.get(nearest) == nullptr && is_first) {
      first = {&key, &node, &root};
    }
  }
  return first;
}

}  // namespace

bool TomlTable::has(std::string_view key) const {
  if (table_ == nullptr) {
    return false;
  }
  auto& asked = shared_->asked[table_];
  if (std::find(asked.begin(), asked.end(), key) == asked.end()) {
    asked.emplace_back(key);
  }
  return as_table(table_).get(key) != nullptr;
}

bool TomlTable::is_text(std::string_view key) const { return has(key) && as_table(table_).get(key)->is_string(); }

bool TomlTable::is_table(std::string_view key) const { return has(key) && as_table(table_).get(key)->is_table(); }

std::string TomlTable::where(std::string_view key) const {
  if (table_ == nullptr) {
    return shared_->path;
  }
  const auto* node = as_table(table_).get(key);
  return position(shared_->path, node != nullptr ? node->source() : as_table(table_).source());
}

void TomlTable::fail(std::string_view key, std::string message) {
  if (!shared_->first_error) {
    shared_->first_error = Error{ErrorCode::BadInput, std::move(message), where(key)};
  }
}

void TomlTable::expected(std::string_view key, std::string_view what) {
  const auto* node = table_ == nullptr ? nullptr : as_table(table_).get(key);
  const std::string in = name_.empty() ? "" : fmt::format(" in [{}]", name_);
  if (node == nullptr) {
    fail(key, fmt::format("`{}` is missing{}, expected {}", key, in, what));
  } else {
    fail(key, fmt::format("`{}`{} is {}, expected {}", key, in, kind_of(*node), what));
  }
}

std::string TomlTable::text(std::string_view key) {
  const auto* node = has(key) ? as_table(table_).get(key) : nullptr;
  if (node == nullptr || !node->is_string()) {
    expected(key, "text in quotes");
    return {};
  }
  shared_->read.insert(node);
  return node->ref<std::string>();
}

std::string TomlTable::text_or(std::string_view key, std::string fallback) {
  return has(key) ? text(key) : std::move(fallback);
}

std::string TomlTable::name(std::string_view key) {
  std::string found = text(key);
  if (find_control(found)) {
    fail(key, fmt::format("`{}` is {}, which holds a line end or another control character, expected plain text", key,
                          in_quotes(found)));
  }
  if (character_count(found) > largest::name) {
    fail(key, fmt::format("`{}` has {} characters, expected a name of at most {}", key, character_count(found),
                          largest::name));
  }
  return found;
}

std::string TomlTable::name_or(std::string_view key, std::string fallback) {
  return has(key) ? name(key) : std::move(fallback);
}

double TomlTable::number(std::string_view key) {
  const auto* node = has(key) ? as_table(table_).get(key) : nullptr;
  const auto value = node == nullptr ? std::nullopt : number_of(*node);
  if (!value) {
    expected(key, node == nullptr ? "a finite number" : expected_number(*node));
    return 0.0;
  }
  shared_->read.insert(node);
  return *value;
}

double TomlTable::number_or(std::string_view key, double fallback) { return has(key) ? number(key) : fallback; }

std::optional<double> TomlTable::optional_number(std::string_view key) {
  return has(key) ? std::optional(number(key)) : std::nullopt;
}

std::string TomlTable::date(std::string_view key) {
  const auto* node = has(key) ? as_table(table_).get(key) : nullptr;
  if (node != nullptr && node->is_date()) {
    shared_->read.insert(node);
    const toml::date day = node->ref<toml::date>();
    return fmt::format("{:04}-{:02}-{:02}", day.year, day.month, day.day);
  }
  if (node == nullptr || !node->is_string()) {
    expected(key, "a date such as 2026-03-02");
    return {};
  }
  std::string found = text(key);
  if (!is_calendar_date(found)) {
    fail(key, fmt::format("`{}` is {}, expected a day of the calendar written as 2026-03-02 (year, month, day)", key,
                          in_quotes(found)));
  }
  return found;
}

std::string TomlTable::date_or(std::string_view key, std::string fallback) {
  return has(key) ? date(key) : std::move(fallback);
}

bool TomlTable::truth_or(std::string_view key, bool fallback) {
  if (!has(key)) {
    return fallback;
  }
  const auto* node = as_table(table_).get(key);
  if (!node->is_boolean()) {
    expected(key, "true or false");
    return fallback;
  }
  shared_->read.insert(node);
  return node->ref<bool>();
}

std::vector<double> TomlTable::numbers(std::string_view key) {
  const auto* node = has(key) ? as_table(table_).get(key) : nullptr;
  if (node == nullptr || !node->is_array()) {
    expected(key, "an array of numbers");
    return {};
  }
  shared_->read.insert(node);
  std::vector<double> values;
  for (const auto& element : *node->as_array()) {
    const auto value = number_of(element);
    if (!value) {
      expected(key, "an array of finite numbers and nothing else, none beyond 1e100");
      return {};
    }
    values.push_back(*value);
  }
  return values;
}

std::vector<std::string> TomlTable::texts(std::string_view key) {
  if (!has(key)) {
    return {};
  }
  const auto* node = as_table(table_).get(key);
  std::vector<std::string> values;
  shared_->read.insert(node);
  if (node->is_array()) {
    for (const auto& element : *node->as_array()) {
      if (element.is_string()) {
        values.push_back(element.ref<std::string>());
      }
    }
  }
  if (!node->is_array() || values.size() != node->as_array()->size()) {
    expected(key, "an array of texts, such as [\"a\", \"b\"]");
    return {};
  }
  return values;
}

std::vector<std::vector<double>> TomlTable::rows(std::string_view key) {
  if (!has(key)) {
    return {};
  }
  const auto* node = as_table(table_).get(key);
  shared_->read.insert(node);
  std::vector<std::vector<double>> all;
  const auto* outer = node->as_array();
  if (outer == nullptr) {
    expected(key, "an array of arrays of numbers");
    return {};
  }
  for (const auto& inner : *outer) {
    auto& row = all.emplace_back();
    if (const auto* numbers = inner.as_array()) {
      for (const auto& element : *numbers) {
        row.push_back(number_of(element).value_or(std::nan("")));
      }
    }
    if (inner.as_array() == nullptr || std::any_of(row.begin(), row.end(), [](double v) { return std::isnan(v); })) {
      expected(key, "an array of arrays of finite numbers, none beyond 1e100");
      return {};
    }
  }
  return all;
}

TomlTable TomlTable::table(std::string_view key) {
  if (!has(key)) {
    return {shared_, nullptr, std::string(key)};
  }
  const auto* node = as_table(table_).get(key);
  shared_->read.insert(node);
  if (!node->is_table()) {
    expected(key, "a table");
    return {shared_, nullptr, std::string(key)};
  }
  return {shared_, node->as_table(), std::string(key)};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
  if (!has(key)) {
    return {};
  }
  const auto* node = as_table(table_).get(key);
  shared_->read.insert(node);
  std::vector<TomlTable> all;
  if (const auto* array = node->as_array()) {
    for (const auto& element : *array) {
      if (element.is_table()) {
        all.push_back({shared_, element.as_table(), std::string(key)});
      }
    }
  }
  if (!node->is_array() || all.size() != node->as_array()->size()) {
    expected(key, fmt::format("tables headed [[{}]]", key));
    return {};
  }
  return all;
}

Expected<TomlDocument> TomlDocument::parse(const TextFile& file, std::string_view schema) {
  auto shared = std::make_shared<TomlTable::Shared>();
  shared->path = file.path.string();
  auto parsed = guarded_parse(file, schema);
  if (!parsed) {
    return tl::unexpected(parsed.error());
  }
  shared->document = std::move(*parsed);
  const void* table = &shared->document;
  TomlDocument document{TomlTable{std::move(shared), table, ""}, file.sha256};
  TomlTable& root = document.root();
  if (!root.has("schema")) {
    return bad_input(fmt::format("the file does not say what it is; write schema = \"{}\" at its top", schema),
                     file.path.string());
  }
  if (const std::string found = root.text("schema"); found != schema) {
    root.fail("schema",
              is_schema_name(found)
                  ? fmt::format("schema is {}, expected \"{}\"", in_quotes(found), schema)
                  : fmt::format("the file has a schema of another program, expected schema = \"{}\"", schema));
    return tl::unexpected(*root.shared_->first_error);
  }
  return document;
}

Expected<TomlDocument> TomlDocument::read(const std::filesystem::path& path, std::string_view schema) {
  return read_text_file(path, largest::toml).and_then([&](const TextFile& file) { return parse(file, schema); });
}

Expected<void> TomlDocument::so_far() const {
  const auto& shared = *root_.shared_;
  if (!shared.first_error) {
    return {};
  }
  const auto asked = shared.asked.find(&shared.document);
  if (asked != shared.asked.end()) {
    if (const UnreadKey misspelt = misspelt_key(shared.document, asked->second); misspelt.key != nullptr) {
      return bad_input(unread_in_words(misspelt, asked->second), position(shared.path, misspelt.key->source()));
    }
  }
  return tl::unexpected(*shared.first_error);
}

Expected<void> TomlDocument::finish() {
  if (auto noted = so_far(); !noted) {
    return noted;
  }
  const auto& shared = *root_.shared_;
  if (const UnreadKey unread = first_unread(shared.document, shared.read); unread.key != nullptr) {
    const auto asked = shared.asked.find(unread.table);
    return bad_input(unread_in_words(unread, asked == shared.asked.end() ? std::vector<std::string>{} : asked->second),
                     position(shared.path, unread.key->source()));
  }
  return {};
}

std::string schema_of(const TextFile& file) {
  const auto parsed = guarded_parse(file, "artcal-…");
  return parsed ? (*parsed)["schema"].value_or(std::string{}) : std::string{};
}

}  // namespace artcal
