#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/point_cloud/point_cloud.h"
#include "core/files/file_bytes.h"

namespace artcal {

/// Which columns of a record are read: x, y, z, then q1 … qn.
using CloudColumns = std::vector<std::size_t>;

/// Finds them by name, whatever their case. Refused: x, y or z missing; one of them or a joint there twice;
/// q1 … qn with a gap. Joints are left out where `units` has no angle, with a warning.
Expected<CloudColumns> find_cloud_columns(const std::vector<std::string>& names, const CloudUnits& units,
                                          const std::string& where, std::vector<std::string>& warnings);

/// Takes records one by one and makes the cloud of them; what every format ends with.
class CloudBuilder {
 public:
  /// Room for `most_records`, which the size of the file must have been seen to allow.
  CloudBuilder(const CloudUnits& units, std::size_t columns, std::size_t max_records);

  /// One record, `columns` numbers in the file's units; left out and counted if one is not finite.
  /// REQUIRES: no more than most_records calls.
  void add(const double* record) {
    bool finite = true;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double value = record[i] * units_.length;
      points_(i, size_) = value;
      finite = finite && std::isfinite(value);
    }
    for (Eigen::Index i = 0; i < joints_.rows(); ++i) {
      const double value = record[3 + i] * *units_.angle;
      joints_(i, size_) = value;
      finite = finite && std::isfinite(value);
    }
    if (finite) {
      for (int i = 0; i < 3; ++i) {
        low_[i] = std::min(low_[i], points_(i, size_));
        high_[i] = std::max(high_[i], points_(i, size_));
      }
      rows_[static_cast<std::size_t>(size_)] = records_;
      ++size_;
    }
    ++records_;
  }

  /// `count` records one behind the other, as one by one.
  void add(const double* records, std::size_t count);

  /// One record at which the instrument measured nothing, as its format says so: left out and counted apart.
  void add_missing() {
    ++missing_;
    ++records_;
  }

  /// Notes that the file has coordinates in single precision.
  void note_single_precision() { single_precision_ = true; }

  /// Refused: no record, none that is a number, all points the same.
  Expected<PointCloud> finish(const FileBytes& file, std::vector<std::string> warnings) &&;

 private:
  CloudUnits units_;
  Eigen::Matrix3Xd points_;
  Eigen::MatrixXd joints_;
  std::vector<int> rows_;
  Eigen::Index size_ = 0;
  std::array<double, 3> low_, high_;  // of the coordinates, mm
  int records_ = 0;
  int missing_ = 0;
  bool single_precision_ = false;
};

}  // namespace artcal
