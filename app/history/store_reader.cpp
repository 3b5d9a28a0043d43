#include "app/history/store_reader.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "acquisition/arm/covariance_matrix.h"
#include "app/output/json_file.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// More parameters than any arm has; a decomposition of more would take hours.
constexpr std::size_t max_parameters = 2000;

// Row i holds i + 1 finite numbers.
bool is_lower_triangle(const nlohmann::ordered_json& rows, std::size_t size) {
  if (!rows.is_array() || rows.size() != size) {
    return false;
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (!rows[i].is_array() || rows[i].size() != i + 1) {
      return false;
    }
    for (const auto& element : rows[i]) {
      if (!element.is_number()) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

std::vector<StoreRow> StoreReader::rows(const std::string& sql, const StoreRow& values) {
  if (error_) {
    return {};
  }
  auto rows = store_.rows(sql, values);
  if (!rows) {
    error_ = rows.error();
    return {};
  }
  return std::move(*rows);
}

std::string StoreReader::text(const StoreValue& value, const char* column) {
  if (!std::holds_alternative<std::string>(value)) {
    fail(fmt::format("its {} is no text", column));
  }
  return text_or_empty(value);
}

double StoreReader::number(const StoreValue& value, const char* column) {
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr || !std::isfinite(*number)) {
    fail(fmt::format("its {} is no finite number", column));
    return 0.0;
  }
  return *number;
}

std::optional<double> StoreReader::optional_number(const StoreValue& value, const char* column) {
  return std::holds_alternative<std::monostate>(value) ? std::nullopt : std::optional(number(value, column));
}

bool StoreReader::truth(const StoreValue& value, const char* column) {
  const auto* whole = std::get_if<long long>(&value);
  if (whole == nullptr || *whole < 0 || *whole > 1) {
    fail(fmt::format("its {} is neither 0 nor 1", column));
  }
  return whole != nullptr && *whole != 0;
}

Eigen::MatrixXd StoreReader::covariance(const StoreValue& value, std::size_t parameters) {
  const auto rows = parse_json(text(value, "covariance"), "covariance", store_.name());
  if (parameters > max_parameters || !rows || !is_lower_triangle(*rows, parameters)) {
    fail(fmt::format("its covariance is not one of its {} identified parameters", parameters));
    return {};
  }
  const auto size = static_cast<Eigen::Index>(parameters);
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      matrix(i, j) = matrix(j, i) = (*rows)[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get<double>();
    }
  }
  if (!is_covariance(matrix)) {
    fail("its covariance matrix is not positive semi-definite, or has a variance of zero");
  }
  return matrix;
}

Eigen::MatrixXd StoreReader::combinations(const StoreValue& value, const std::vector<std::string>& names) {
  const auto size = static_cast<Eigen::Index>(names.size());
  if (std::holds_alternative<std::monostate>(value)) {
    return Eigen::MatrixXd::Zero(size, 0);
  }
  const auto all = parse_json(text(value, "unidentifiable combinations"), "unidentifiable combinations", store_.name());
  if (!all || !all->is_array() || all->size() > names.size()) {
    fail("its unidentifiable combinations are none of its parameters");
    return Eigen::MatrixXd::Zero(size, 0);
  }
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, static_cast<Eigen::Index>(all->size()));
  for (std::size_t k = 0; k < all->size(); ++k) {
    for (const auto& [name, coefficient] : (*all)[k].items()) {
      const auto at = std::find(names.begin(), names.end(), name);
      if (at == names.end() || !coefficient.is_number()) {
        fail("its unidentifiable combinations are none of its parameters");
        return Eigen::MatrixXd::Zero(size, 0);
      }
      matrix(at - names.begin(), static_cast<Eigen::Index>(k)) = coefficient.get<double>();
    }
  }
  return matrix;
}

void StoreReader::fail(const std::string& message) {
  if (!error_) {
    error_ = Error{ErrorCode::BadInput,
                   fmt::format("the store is damaged: of the result {}, {}; `artcal batch` on its recordings, "
                               "without --resume, computes it anew",
                               in_quotes(recording_), message),
                   store_.name()};
  }
}

}  // namespace artcal
