#include "acquisition/point_cloud/pcd/pcd_text.h"

#include <cassert>
#include <iterator>

#include <fmt/format.h>

#include "core/units.h"

namespace artcal {

std::string pcd_file_text(const Eigen::Matrix3Xd& points, const Eigen::MatrixXd& joints) {
  assert(joints.rows() == 0 || joints.cols() == points.cols());
  std::string names = "x y z";
  std::string sizes = "8 8 8";
  std::string types = "F F F";
  std::string counts = "1 1 1";
  for (Eigen::Index j = 0; j < joints.rows(); ++j) {
    names += fmt::format(" q{}", j + 1);
    sizes += " 8";
    types += " F";
    counts += " 1";
  }
  fmt::memory_buffer out;
  const auto to = std::back_inserter(out);
  fmt::format_to(to,
                 "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS {}\nSIZE {}\nTYPE {}\nCOUNT {}\n"
                 "WIDTH {}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA ascii\n",
                 names, sizes, types, counts, points.cols(), points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    fmt::format_to(to, "{:.9f} {:.9f} {:.9f}", points(0, i), points(1, i), points(2, i));
    for (Eigen::Index j = 0; j < joints.rows(); ++j) {
      fmt::format_to(to, " {:.12f}", joints(j, i) / units::degree);
    }
    fmt::format_to(to, "\n");
  }
  return fmt::to_string(out);
}

}  // namespace artcal
