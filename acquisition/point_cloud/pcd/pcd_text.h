#pragma once

#include <string>

#include <Eigen/Core>

namespace artcal {

/// Points with the joint angles they were taken at as a PCD file, ascii: fields x, y, z in mm with 9 decimals and
/// q1 … qn in deg with 12, of 8 bytes each. `joints` has a column a point (rad), and no rows where there are none.
std::string pcd_file_text(const Eigen::Matrix3Xd& points, const Eigen::MatrixXd& joints);

}  // namespace artcal
