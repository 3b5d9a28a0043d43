#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/error.h"
#include "core/files/input_file.h"

namespace artcal {

/// Factors from the units of a cloud's file to those of artcal (core/units.h). No format for clouds says its
/// unit, and none is guessed: who reads a cloud states it.
struct CloudUnits {
  double length = 1.0;          ///< mm per unit of x, y, z
  std::optional<double> angle;  ///< rad per unit of q1 … qn; without it joint angles are not read
};

/// Points of a scan or a probing, in the frame that the file has them in.
struct PointCloud {
  Eigen::Matrix3Xd points;            ///< mm, every coordinate finite
  Eigen::MatrixXd joints;             ///< joint × point, rad; 0 × 0 where the file has none or no unit was stated
  std::vector<int> rows;              ///< which record of the file each point is, from 0, ascending
  std::size_t dropped = 0;            ///< records left out because a number was NaN or infinite
  InputFile input;                    ///< the file, for results that rest on it
  std::vector<std::string> warnings;  ///< things that look wrong but may be right
};

/// Reads points from a file, by its content and not by its name (docs/files.md, "Scans"):
///  - PCD 0.5 to 0.7: ascii, binary, binary_compressed. Fields x, y, z of any type up to 4-byte integers,
///    float and double; q1 … qn of the same; other fields are passed over. VIEWPOINT, the place of the
///    sensor, is not applied: coordinates are taken as they stand, with a warning where it is not the origin.
///  - PLY 1.0: ascii, binary of both byte orders. Properties x, y, z (q1 … qn) of the element `vertex`;
///    other elements, such as faces, are passed over. A list inside `vertex` is refused.
///  - Text: three or more columns, separated by blanks, tabs or commas, with or without a header line that
///    names x, y, z (q1 … qn); lines that begin with # or // are comments.
/// Doubles keep every digit. No count in a file is believed before its size allows it.
///
/// Errors (BadInput, with file and line): not one of these formats; a header that contradicts itself or
/// promises other than what the file holds; no points; no point that is a number; all points the same.
Expected<PointCloud> read_point_cloud(const std::filesystem::path& path, const CloudUnits& units);

}  // namespace artcal
