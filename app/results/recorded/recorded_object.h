#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace artcal {

/// What a result lacks or has of another kind than docs/result-schema.md says, with its place:
/// "parameters[3].unit is 5, expected a text".
class NotAsInSchema : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An object of a result and its place in it. A member is read as what the schema says that it is; one that is missing
/// or of another kind throws NotAsInSchema. Refers to the JSON, which must stay.
class RecordedObject {
 public:
  /// `place` is empty for the result itself.
  explicit RecordedObject(const nlohmann::ordered_json& json, std::string place = {});

  [[nodiscard]] std::string text(const char* key) const;
  [[nodiscard]] double number(const char* key) const;
  [[nodiscard]] bool truth(const char* key) const;
  [[nodiscard]] int integer(const char* key) const;
  [[nodiscard]] std::size_t count(const char* key) const;  ///< 0 or more, also beyond an int
  [[nodiscard]] Eigen::Vector3d point(const char* key) const;
  [[nodiscard]] std::vector<Eigen::Vector3d> points(const char* key) const;
  [[nodiscard]] std::vector<std::string> texts(const char* key) const;
  [[nodiscard]] std::vector<double> numbers(const char* key) const;
  [[nodiscard]] std::vector<std::size_t> counts(const char* key) const;
  /// Rows of numbers, `size` of them with as many each.
  [[nodiscard]] Eigen::MatrixXd square_matrix(const char* key, std::size_t size) const;
  /// Members of an object whose keys are names.
  [[nodiscard]] std::vector<std::pair<std::string, double>> numbers_by_name(const char* key) const;

  /// NaN for null, which is how JSON holds what is not a number.
  [[nodiscard]] double number_or_nan(const char* key) const;
  [[nodiscard]] std::vector<double> numbers_or_nan(const char* key) const;
  [[nodiscard]] std::vector<std::vector<double>> columns_or_nan(const char* key) const;

  /// Whether there is such a member, other than null. What is null or absent reads as nothing, or as `otherwise`.
  [[nodiscard]] bool has(const char* key) const;
  [[nodiscard]] std::string text_or(const char* key, const char* otherwise = "") const;
  [[nodiscard]] bool truth_or(const char* key, bool otherwise) const;
  [[nodiscard]] std::optional<double> optional_number(const char* key) const;

  [[nodiscard]] RecordedObject object(const char* key) const;
  [[nodiscard]] std::size_t size_of(const char* key) const;  ///< of a list

  /// What `read` makes of each object in a list.
  template <typename Read>
  [[nodiscard]] auto list(const char* key, Read&& read) const {
    std::vector<decltype(read(std::declval<const RecordedObject&>()))> all;
    const std::size_t size = size_of(key);
    all.reserve(size);
    for (std::size_t i = 0; i < size; ++i) {
      all.push_back(read(element(key, i)));
    }
    return all;
  }

  /// Throws NotAsInSchema: "`key` is `what`", with the place of `key`.
  [[noreturn]] void refuse(const std::string& key, const std::string& what) const;

 private:
  using Json = nlohmann::ordered_json;
  enum class Null { IsRefused, IsNan };

  [[nodiscard]] std::string place_of(const std::string& key) const;
  [[nodiscard]] const Json& member(const char* key, bool (Json::*is_kind)() const, const char* expected) const;
  [[nodiscard]] const Json& list_at(const char* key) const;
  [[nodiscard]] std::vector<double> numbers_in(const Json& list, const std::string& key, Null null) const;
  [[nodiscard]] Eigen::Vector3d point_in(const Json& list, const std::string& key) const;
  [[nodiscard]] RecordedObject element(const char* key, std::size_t index) const;

  const Json* json_;
  std::string place_;
};

}  // namespace artcal
