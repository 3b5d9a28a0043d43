#include "acquisition/point_cloud/cloud_builder.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "core/large_pages.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr int max_joints = 24;  // as many as an arm may have

std::string lower(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return name;
}

// Where a name stands; nothing if it is not there, an error if it is there twice.
Expected<std::optional<std::size_t>> find_once(const std::vector<std::string>& names, const std::string& name,
                                               const std::string& where) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (lower(names[i]) != name) {
      continue;
    }
    if (found) {
      return bad_input(fmt::format("the field {} is there twice, expected it once", name), where);
    }
    found = i;
  }
  return found;
}

std::string list_of(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return truncated(100, text);
}

// A unit that is wrong by 1000 or 25.4 shows in how much room the points take.
std::optional<std::string> unlikely_size(double span) {
  if (span >= 0.1 && span <= 1e6) {
    return std::nullopt;
  }
  return fmt::format("the points span {:.3g} mm; is the unit right?", span);
}

// A float has 24 bits: half of the last one is what a coordinate may be off.
std::optional<std::string> coarse_storage(double largest) {
  const double rounding = largest * 0x1p-24;
  if (rounding <= 1e-3) {
    return std::nullopt;
  }
  return fmt::format("the file has single precision, which rounds coordinates of {:.4g} mm by up to {:.2g} mm", largest,
                     rounding);
}

}  // namespace

Expected<CloudColumns> find_cloud_columns(const std::vector<std::string>& names, const CloudUnits& units,
                                          const std::string& where, std::vector<std::string>& warnings) {
  CloudColumns columns;
  for (const char* name : {"x", "y", "z"}) {
    const auto found = find_once(names, name, where);
    if (!found) {
      return tl::unexpected(found.error());
    }
    if (!*found) {
      return bad_input(fmt::format("there is no field {} among {}; expected x, y and z", name, list_of(names)), where);
    }
    columns.push_back(**found);
  }
  bool ended = false;
  for (int joint = 1; joint <= max_joints; ++joint) {
    const auto found = find_once(names, fmt::format("q{}", joint), where);
    if (!found) {
      return tl::unexpected(found.error());
    }
    if (*found && ended) {
      return bad_input(fmt::format("there is a field q{} but no q{}; expected q1 … qn without a gap", joint, joint - 1),
                       where);
    }
    if (*found) {
      columns.push_back(**found);
    }
    ended = ended || !*found;
  }
  if (columns.size() > 3 && !units.angle) {
    warnings.push_back("the joint angles in the file are not read, because their unit was not stated");
    columns.resize(3);
  }
  return columns;
}

CloudBuilder::CloudBuilder(const CloudUnits& units, std::size_t columns, std::size_t max_records)
    : units_(units), points_(3, static_cast<Eigen::Index>(max_records)) {
  if (columns > 3) {
    joints_.resize(static_cast<Eigen::Index>(columns) - 3, static_cast<Eigen::Index>(max_records));
  }
  rows_ = large_vector<int>(max_records);
  prefer_large_pages(points_.data(), static_cast<std::size_t>(points_.size()) * sizeof(double));
  low_.fill(std::numeric_limits<double>::infinity());
  high_.fill(-std::numeric_limits<double>::infinity());
}

void CloudBuilder::add(const double* records, std::size_t count) {
  const Eigen::Index width = 3 + joints_.rows();
  const auto records_here = static_cast<Eigen::Index>(count);
  if (width == 3) {
    auto points = points_.middleCols(size_, records_here);
    points = units_.length * Eigen::Matrix3Xd::Map(records, 3, records_here);
    // A number times zero is zero, but for those that are not finite: one sum shows it of all.
    if (std::isfinite((0.0 * points).sum())) {
      Eigen::Array3d low = Eigen::Array3d::Map(low_.data()), high = Eigen::Array3d::Map(high_.data());
      for (Eigen::Index i = 0; i < records_here; ++i) {
        low = low.min(points.col(i).array());
        high = high.max(points.col(i).array());
      }
      Eigen::Array3d::Map(low_.data()) = low;
      Eigen::Array3d::Map(high_.data()) = high;
      std::iota(rows_.begin() + size_, rows_.begin() + size_ + records_here, records_);
      size_ += records_here;
      records_ += static_cast<int>(count);
      return;
    }
  }
  for (Eigen::Index i = 0; i < records_here; ++i) {
    add(records + i * width);
  }
}

Expected<PointCloud> CloudBuilder::finish(const FileBytes& file, std::vector<std::string> warnings) && {
  const std::string name = file.path.string();
  if (records_ == 0) {
    return bad_input("the file holds no points", name);
  }
  if (size_ == 0 && missing_ == records_) {
    return bad_input(fmt::format("at none of the {} points anything was measured, all are 0 0 0", records_), name);
  }
  if (size_ == 0) {
    return bad_input(fmt::format("none of the {} points is a number, all are NaN or infinite", records_), name);
  }
  if (size_ != points_.cols()) {
    points_.conservativeResize(3, size_);
    joints_.conservativeResize(joints_.rows(), joints_.rows() == 0 ? 0 : size_);
    rows_.resize(static_cast<std::size_t>(size_));
    rows_.shrink_to_fit();
  }
  double span = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    span = std::max(span, high_[i] - low_[i]);
    largest = std::max({largest, high_[i], -low_[i]});
  }
  if (size_ > 1 && span == 0.0) {
    return bad_input(fmt::format("all {} points are the same, ({:.10g}, {:.10g}, {:.10g}) mm; nothing was scanned",
                                 size_, points_(0, 0), points_(1, 0), points_(2, 0)),
                     name);
  }
  PointCloud cloud{std::move(points_),  std::move(joints_),
                   std::move(rows_),    static_cast<std::size_t>(records_ - size_),
                   {name, file.sha256}, std::move(warnings)};
  if (const auto not_numbers = cloud.dropped - static_cast<std::size_t>(missing_); not_numbers > 0) {
    cloud.warnings.push_back(
        fmt::format("{} of {} points are NaN or infinite and were dropped", not_numbers, records_));
  }
  if (missing_ > 0) {
    cloud.warnings.push_back(fmt::format(
        "{} of {} points are 0 0 0 in the scanner's own frame, where it measured nothing, and were left out", missing_,
        records_));
  }
  if (auto unlikely = size_ > 1 ? unlikely_size(span) : std::nullopt) {
    cloud.warnings.push_back(*unlikely);
  }
  if (auto coarse = single_precision_ ? coarse_storage(largest) : std::nullopt) {
    cloud.warnings.push_back(*coarse);
  }
  return cloud;
}

}  // namespace artcal
