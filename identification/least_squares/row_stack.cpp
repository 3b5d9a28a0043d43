#include "identification/least_squares/row_stack.h"

#include <algorithm>

namespace artcal {

void RowStack::add(const RowsRef& rows) {
  if (!factor_ && count_ + rows.rows() > columns_) {
    factor_.emplace(columns_);
    factor_->add(kept_.topRows(count_));
    kept_.resize(0, 0);
  }
  if (factor_) {
    factor_->add(rows);
    return;
  }
  if (count_ + rows.rows() > kept_.rows()) {
    kept_.conservativeResize(std::min<Eigen::Index>(columns_, std::max(2 * count_, count_ + rows.rows())), columns_);
  }
  kept_.middleRows(count_, rows.rows()) = rows;
  count_ += rows.rows();
}

Eigen::MatrixXd RowStack::rows() { return factor_ ? factor_->triangle() : Eigen::MatrixXd(kept_.topRows(count_)); }

}  // namespace artcal
