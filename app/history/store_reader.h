#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "app/store/store.h"

namespace artcal {

/// Reads results of a store as a file that anybody may have changed: what no batch writes there is noted as an error,
/// and a harmless value is returned. What was read is used only where there is no error.
class StoreReader {
 public:
  explicit StoreReader(Store& store) : store_(store) {}

  /// No rows after an error.
  std::vector<StoreRow> rows(const std::string& sql, const StoreRow& values = {});
  /// Messages name the result that values are of.
  void set_recording(const std::string& recording) { recording_ = recording; }

  std::string text(const StoreValue& value, const char* column);
  double number(const StoreValue& value, const char* column);  ///< finite
  std::optional<double> optional_number(const StoreValue& value, const char* column);
  bool truth(const StoreValue& value, const char* column);
  /// The covariance of so many parameters from its rows up to the diagonal as JSON.
  Eigen::MatrixXd covariance(const StoreValue& value, std::size_t parameters);
  /// Combinations of parameters, a column each by `names`, from JSON such as [{"a6":1,"theta6":-0.005}]; none for NULL.
  Eigen::MatrixXd combinations(const StoreValue& value, const std::vector<std::string>& names);

  void fail(const std::string& message);
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  Store& store_;
  std::string recording_;
  std::optional<Error> error_;
};

}  // namespace artcal
