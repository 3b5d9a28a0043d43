#pragma once

#include <vector>

#include <Eigen/Core>

namespace artcal {

/// A column that equals an earlier one in every row.
struct RepeatedColumn {
  Eigen::Index column;
  Eigen::Index first;  ///< the first of all that are equal
};

/// The columns that repeat an earlier one, ascending. NaN equals NaN, and −0 equals 0. Time goes with the number of
/// columns: they are put into buckets by a hash, and each bucket is looked at by itself, on `threads` threads (≤ 0: as
/// many as the machine has), which do not change the answer. REQUIRES fewer than 2³² columns.
std::vector<RepeatedColumn> repeated_columns(const Eigen::Ref<const Eigen::MatrixXd>& columns, int threads = 0);

/// The same as a number a column: the first one that equals it, itself where none does before.
std::vector<Eigen::Index> first_coincident(const Eigen::Ref<const Eigen::MatrixXd>& columns);

}  // namespace artcal
