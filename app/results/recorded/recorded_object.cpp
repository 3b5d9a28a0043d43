#include "app/results/recorded/recorded_object.h"

#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* a_count = "a whole number, 0 or more";

const char* kind_in_words(const Json& json) {
  switch (json.type()) {
    case Json::value_t::null: return "null";
    case Json::value_t::object: return "an object";
    case Json::value_t::array: return "a list";
    case Json::value_t::string: return "a text";
    case Json::value_t::boolean: return "true or false";
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned:
    case Json::value_t::number_float:
    case Json::value_t::binary:
    case Json::value_t::discarded: break;
  }
  return "a number";
}

// A number is shown, for it may be one, but not of the kind expected.
std::string not_this(const Json& found, const char* expected) {
  return fmt::format("{}, expected {}", found.is_number() ? found.dump() : kind_in_words(found), expected);
}

std::string at_index(const std::string& key, std::size_t index) { return fmt::format("{}[{}]", key, index); }

bool fits_int(const Json& number) {
  return number.is_number_unsigned() ? std::in_range<int>(number.get<std::uint64_t>())
                                     : number.is_number_integer() && std::in_range<int>(number.get<std::int64_t>());
}

bool is_count(const Json& number) {
  return number.is_number_unsigned() || (number.is_number_integer() && number.get<std::int64_t>() >= 0);
}

}  // namespace

RecordedObject::RecordedObject(const Json& json, std::string place) : json_(&json), place_(std::move(place)) {
  if (!json.is_object()) {
    throw NotAsInSchema(fmt::format("{} is {}", place_.empty() ? "the result" : place_, not_this(json, "an object")));
  }
}

std::string RecordedObject::place_of(const std::string& key) const { return place_.empty() ? key : place_ + "." + key; }

void RecordedObject::refuse(const std::string& key, const std::string& what) const {
  throw NotAsInSchema(place_of(key) + " is " + what);
}

const Json& RecordedObject::member(const char* key, bool (Json::*is_kind)() const, const char* expected) const {
  const auto at = json_->find(key);
  if (at == json_->end()) {
    refuse(key, fmt::format("missing, expected {}", expected));
  }
  if (!((*at).*is_kind)()) {
    refuse(key, not_this(*at, expected));
  }
  return *at;
}

const Json& RecordedObject::list_at(const char* key) const { return member(key, &Json::is_array, "a list"); }

RecordedObject RecordedObject::element(const char* key, std::size_t index) const {
  return RecordedObject(list_at(key)[index], place_of(at_index(key, index)));
}

std::string RecordedObject::text(const char* key) const {
  return member(key, &Json::is_string, "a text").get<std::string>();
}

double RecordedObject::number(const char* key) const { return member(key, &Json::is_number, "a number").get<double>(); }

bool RecordedObject::truth(const char* key) const {
  return member(key, &Json::is_boolean, "true or false").get<bool>();
}

int RecordedObject::integer(const char* key) const {
  const Json& found = member(key, &Json::is_number, "a whole number");
  if (!fits_int(found)) {
    refuse(key, not_this(found, "a whole number"));
  }
  return found.get<int>();
}

std::size_t RecordedObject::count(const char* key) const {
  const Json& found = member(key, &Json::is_number, a_count);
  if (!is_count(found)) {
    refuse(key, not_this(found, a_count));
  }
  return found.get<std::size_t>();
}

Eigen::Vector3d RecordedObject::point_in(const Json& list, const std::string& key) const {
  const std::vector<double> found = numbers_in(list, key, Null::IsRefused);
  if (found.size() != 3) {
    refuse(key, fmt::format("a list of {}, expected x, y, z", found.size()));
  }
  return {found[0], found[1], found[2]};
}

Eigen::Vector3d RecordedObject::point(const char* key) const { return point_in(list_at(key), key); }

std::vector<Eigen::Vector3d> RecordedObject::points(const char* key) const {
  std::vector<Eigen::Vector3d> all;
  for (const Json& list : list_at(key)) {
    all.push_back(point_in(list, at_index(key, all.size())));
  }
  return all;
}

std::vector<std::string> RecordedObject::texts(const char* key) const {
  std::vector<std::string> all;
  for (const Json& found : list_at(key)) {
    if (!found.is_string()) {
      refuse(at_index(key, all.size()), not_this(found, "a text"));
    }
    all.push_back(found.get<std::string>());
  }
  return all;
}

std::vector<double> RecordedObject::numbers_in(const Json& list, const std::string& key, Null null) const {
  if (!list.is_array()) {
    refuse(key, not_this(list, "a list"));
  }
  std::vector<double> all;
  all.reserve(list.size());
  for (const Json& found : list) {
    if (found.is_null() && null == Null::IsNan) {
      all.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    if (!found.is_number()) {
      refuse(at_index(key, all.size()), not_this(found, "a number"));
    }
    all.push_back(found.get<double>());
  }
  return all;
}

std::vector<double> RecordedObject::numbers(const char* key) const {
  return numbers_in(list_at(key), key, Null::IsRefused);
}

std::vector<std::size_t> RecordedObject::counts(const char* key) const {
  std::vector<std::size_t> all;
  const Json& list = list_at(key);
  all.reserve(list.size());
  for (const Json& found : list) {
    if (!is_count(found)) {
      refuse(at_index(key, all.size()), not_this(found, a_count));
    }
    all.push_back(found.get<std::size_t>());
  }
  return all;
}

std::vector<double> RecordedObject::numbers_or_nan(const char* key) const {
  return numbers_in(list_at(key), key, Null::IsNan);
}

std::vector<std::vector<double>> RecordedObject::columns_or_nan(const char* key) const {
  std::vector<std::vector<double>> all;
  for (const Json& column : list_at(key)) {
    all.push_back(numbers_in(column, at_index(key, all.size()), Null::IsNan));
  }
  return all;
}

Eigen::MatrixXd RecordedObject::square_matrix(const char* key, std::size_t size) const {
  const Json& rows = list_at(key);
  if (rows.size() != size) {
    refuse(key, fmt::format("of {} rows, expected {}", rows.size(), size));
  }
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
  for (std::size_t i = 0; i < size; ++i) {
    const std::vector<double> row = numbers_in(rows[i], at_index(key, i), Null::IsRefused);
    if (row.size() != size) {
      refuse(at_index(key, i), fmt::format("of {} numbers, expected {}", row.size(), size));
    }
    matrix.row(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), matrix.cols());
  }
  return matrix;
}

std::vector<std::pair<std::string, double>> RecordedObject::numbers_by_name(const char* key) const {
  std::vector<std::pair<std::string, double>> all;
  for (const auto& [name, found] : member(key, &Json::is_object, "an object").items()) {
    if (!found.is_number()) {
      refuse(fmt::format("{}[{}]", key, in_quotes(name)), not_this(found, "a number"));
    }
    all.emplace_back(name, found.get<double>());
  }
  return all;
}

double RecordedObject::number_or_nan(const char* key) const {
  const auto at = json_->find(key);
  return at != json_->end() && at->is_null() ? std::numeric_limits<double>::quiet_NaN() : number(key);
}

bool RecordedObject::has(const char* key) const {
  const auto at = json_->find(key);
  return at != json_->end() && !at->is_null();
}

std::string RecordedObject::text_or(const char* key, const char* otherwise) const {
  return has(key) ? text(key) : otherwise;
}

bool RecordedObject::truth_or(const char* key, bool otherwise) const { return has(key) ? truth(key) : otherwise; }

std::optional<double> RecordedObject::optional_number(const char* key) const {
  return has(key) ? std::optional(number(key)) : std::nullopt;
}

RecordedObject RecordedObject::object(const char* key) const {
  return RecordedObject(member(key, &Json::is_object, "an object"), place_of(key));
}

std::size_t RecordedObject::size_of(const char* key) const { return list_at(key).size(); }

}  // namespace artcal
