#include "acquisition/point_cloud/ptx_file.h"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>
#include <Eigen/LU>

#include "acquisition/point_cloud/cloud_builder.h"
#include "acquisition/point_cloud/text_rows.h"

namespace artcal {
namespace {

constexpr std::size_t shortest_ptx_row = 6;       // "1 2 3\n"
constexpr double max_off_rotation = 1e-3;         // of a matrix written with three digits
constexpr double noticeable_distortion = 1.0e-3;  // mm

/// What stands before the points of one scan.
struct PtxScan {
  std::size_t points = 0;
  std::string where;                  // of its first line
  Eigen::Matrix3d file_from_scanner;  // in column convention
  Eigen::Vector3d scanner_in_file;    // in the file's unit
  double off_rotation = 0.0;          // largest element of RᵀR - I
};

// Numbers of one line of a header; `what` says what the line is.
template <std::size_t N>
Expected<std::array<double, N>> header_numbers(TextRows& rows, const std::string& path, const char* what) {
  if (!rows.next()) {
    return bad_input(fmt::format("the file ends in the header of a scan, expected {}; is it truncated?", what), path);
  }
  if (rows.fields().size() != N) {
    return bad_input(
        fmt::format("the line has {} columns, expected {} numbers: {} of a scan (PTX)", rows.fields().size(), N, what),
        rows.where());
  }
  std::vector<std::size_t> columns(N);
  for (std::size_t i = 0; i < N; ++i) {
    columns[i] = i;
  }
  std::array<double, N> values{};
  return rows.numbers(columns, values.data()).map([&] { return values; });
}

Expected<std::size_t> header_count(TextRows& rows, const std::string& path, const char* what) {
  if (!rows.next()) {
    return bad_input(fmt::format("the file ends where the number of {} of a scan is expected (PTX)", what), path);
  }
  const auto count = rows.fields().size() == 1 ? whole_number(rows.fields().front()) : std::nullopt;
  if (!count || *count == 0) {
    return bad_input(
        fmt::format("the line is no positive whole number alone, expected the number of {} of a scan (PTX)", what),
        rows.where());
  }
  return *count;
}

// The matrix moves the row (x, y, z, 1): its last row is the translation.
Expected<void> read_matrix(TextRows& rows, const std::string& path, PtxScan& scan) {
  Eigen::Matrix4d matrix;
  for (Eigen::Index i = 0; i < 4; ++i) {
    const auto line = header_numbers<4>(rows, path, "a row of the matrix that moves the points");
    if (!line) {
      return tl::unexpected(line.error());
    }
    matrix.row(i) = Eigen::RowVector4d::Map(line->data());
  }
  const Eigen::Vector4d last = matrix.col(3);
  if (last != Eigen::Vector4d(0, 0, 0, 1)) {
    return bad_input(
        fmt::format(
            "the last column of the scan's matrix is {:.6g}, {:.6g}, {:.6g}, {:.6g}, expected 0, 0, 0, 1 (a point "
            "is moved as the row x y z 1 times the matrix, the last row is the translation)",
            last[0], last[1], last[2], last[3]),
        rows.where());
  }
  scan.file_from_scanner = matrix.topLeftCorner<3, 3>().transpose();
  scan.scanner_in_file = matrix.bottomLeftCorner<1, 3>().transpose();
  const Eigen::Matrix3d& r = scan.file_from_scanner;
  scan.off_rotation = (r.transpose() * r - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(scan.off_rotation <= max_off_rotation) || r.determinant() < 0.0) {
    return bad_input(
        "the scan's matrix is no rotation and translation (it scales, shears or mirrors), expected a rigid motion",
        rows.where());
  }
  return {};
}

Expected<PtxScan> read_header(TextRows& rows, const std::string& path) {
  PtxScan scan;
  const auto columns = header_count(rows, path, "columns");
  if (!columns) {
    return tl::unexpected(columns.error());
  }
  scan.where = rows.where();
  const auto lines = header_count(rows, path, "rows");
  if (!lines) {
    return tl::unexpected(lines.error());
  }
  const std::size_t room = rows.rest().size() / shortest_ptx_row + 1;
  if (*columns > room / *lines) {
    return bad_input(
        fmt::format("the header promises {} x {} points, more than the {} bytes that follow can hold; is the file "
                    "truncated?",
                    *columns, *lines, rows.rest().size()),
        scan.where);
  }
  scan.points = *columns * *lines;
  for (const char* what :
       {"the scanner's position", "the scanner's x axis", "the scanner's y axis", "the scanner's z axis"}) {
    if (auto pose = header_numbers<3>(rows, path, what); !pose) {
      return tl::unexpected(pose.error());
    }
  }
  return read_matrix(rows, path, scan).map([&] { return scan; });
}

/// Reads the scans of a file one after the other.
class PtxReader {
 public:
  PtxReader(const FileBytes& file, const CloudUnits& units)
      : file_(file),
        path_(file.path.string()),
        unit_(units.length),
        builder_(units, 3, std::min(lines_of(file), file.bytes.size() / shortest_ptx_row + 1)) {}

  Expected<ReadCloud> read() {
    std::size_t scans = 0;
    int line = 1;
    for (std::string_view rest = file_.bytes; scans == 0 || has_more(rest, line); ++scans) {
      TextRows header(rest, path_, line, TextRows::Separator::Blanks);
      const auto scan = read_header(header, path_);
      if (!scan) {
        return tl::unexpected(scan.error());
      }
      TextRows rows(header.rest(), path_, header.next_line(), TextRows::Separator::Blanks);
      if (auto taken = take_points(*scan, rows); !taken) {
        return tl::unexpected(taken.error());
      }
      rest = rows.rest();
      line = rows.next_line();
    }
    if (distortion_ > noticeable_distortion) {
      warnings_.push_back(
          fmt::format("a scan's matrix has so few digits that it distorts the points by up to {:.2g} mm", distortion_));
    }
    return std::move(builder_).finish(file_, std::move(warnings_)).map([&](PointCloud&& cloud) {
      return ReadCloud{std::move(cloud), scans == 1 ? std::string("one scan, moved by its matrix")
                                                    : fmt::format("{} scans, each moved by its matrix", scans)};
    });
  }

 private:
  static std::size_t lines_of(const FileBytes& file) {
    return static_cast<std::size_t>(std::count(file.bytes.begin(), file.bytes.end(), '\n')) + 1;
  }

  [[nodiscard]] bool has_more(std::string_view rest, int line) const {
    return TextRows(rest, path_, line, TextRows::Separator::Blanks).next();
  }

  Expected<void> take_points(const PtxScan& scan, TextRows& rows) {
    rows.allow_quotes();
    const std::vector<std::size_t> columns{0, 1, 2};
    std::size_t width = 0;
    for (std::size_t i = 0; i < scan.points; ++i) {
      if (!rows.next()) {
        return bad_input(
            fmt::format("the header promises {} points, the file ends after {}; is it truncated?", scan.points, i),
            scan.where);
      }
      Eigen::Vector3d point;
      if (auto read = rows.numbers(columns, point.data()); !read) {
        return tl::unexpected(Error{ErrorCode::BadInput,
                                    fmt::format("{}; {} of the {} points that the header promises were read",
                                                read.error().message, i, scan.points),
                                    read.error().where});
      }
      // Where the scanner got no echo, 0 0 0 stands in its own frame, in some files without a colour behind it.
      if (point.isZero(0.0)) {
        builder_.add_missing();
        continue;
      }
      width = width == 0 ? rows.fields().size() : width;
      if (rows.fields().size() != width) {
        return bad_input(
            fmt::format("the line has {} columns, expected {} as in the points before", rows.fields().size(), width),
            rows.where());
      }
      add(scan, point);
    }
    const auto end = rows.check_end();
    if (!end) {
      return tl::unexpected(end.error());
    }
    warnings_.insert(warnings_.end(), end->begin(), end->end());
    return {};
  }

  void add(const PtxScan& scan, const Eigen::Vector3d& point) {
    if (point.allFinite()) {
      distortion_ = std::max(distortion_, scan.off_rotation * point.norm() * unit_);
    }
    const Eigen::Vector3d moved = scan.file_from_scanner * point + scan.scanner_in_file;
    builder_.add(moved.data());
  }

  const FileBytes& file_;
  std::string path_;
  double unit_;
  CloudBuilder builder_;
  double distortion_ = 0.0;  // mm
  std::vector<std::string> warnings_;
};

}  // namespace

bool looks_like_ptx(std::string_view bytes) {
  TextRows rows(bytes, "", 1, TextRows::Separator::Blanks);
  for (int i = 0; i < 2; ++i) {
    if (!rows.next() || rows.fields().size() != 1 || !whole_number(rows.fields().front())) {
      return false;
    }
  }
  return rows.next() && rows.fields().size() == 3 && rows.is_number_at(0) && rows.is_number_at(1) &&
         rows.is_number_at(2);
}

Expected<ReadCloud> parse_ptx(const FileBytes& file, const CloudUnits& units) { return PtxReader(file, units).read(); }

}  // namespace artcal
