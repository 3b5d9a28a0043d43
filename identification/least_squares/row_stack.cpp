#include "identification/least_squares/row_stack.h"

#include <algorithm>

namespace artcal {

RowStack::RowStack(int columns, Folding folding, int expected)
    : columns_(columns), folding_(folding), kept_(0, columns) {
  if (expected > columns) {
    begin_folding();
  }
}

void RowStack::begin_folding() {
  if (folding_ == Folding::NormalEquations) {
    normal_.emplace(columns_);
  } else {
    factor_.emplace(columns_);
  }
}

void RowStack::add(const RowsRef& rows) {
  if (!factor_ && !normal_ && count_ + rows.rows() > columns_) {
    begin_folding();
    if (count_ > 0) {
      normal_ ? normal_->add(kept_.topRows(count_)) : factor_->add(kept_.topRows(count_));
    }
    kept_.resize(0, 0);
  }
  if (normal_) {
    normal_->add(rows);
    return;
  }
  if (factor_) {
    factor_->add(rows);
    return;
  }
  if (count_ + rows.rows() > kept_.rows()) {
    kept_.conservativeResize(std::min<Eigen::Index>(columns_, std::max(2 * count_, count_ + rows.rows())), columns_);
  }
  kept_.middleRows(count_, rows.rows()) = rows.matrix();
  count_ += rows.rows();
}

Eigen::MatrixXd RowStack::rows() {
  if (normal_) {
    return normal_->triangle();
  }
  return factor_ ? factor_->triangle() : Eigen::MatrixXd(kept_.topRows(count_));
}

}  // namespace artcal
