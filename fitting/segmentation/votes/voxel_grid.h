#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "fitting/fit.h"

namespace artcal::segmentation {

/// Count, sum and sum of squares of points, about the origin of the grid they belong to.
struct Moments {
  double count = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();

  void add(const Eigen::Vector3d& p);
  Moments& operator+=(const Moments& other);
};

/// Points sorted into cubes. Exact and without a map: cubes are known by 63-bit keys (21 bits an axis) and
/// kept in the order of their keys, x fastest; memory goes with the points, not with the room they stand
/// in. `pcl::VoxelGrid` counts cubes in 32 bits and keeps no indices.
class VoxelGrid {
 public:
  static constexpr int bits = 21;
  static constexpr double max_cubes = static_cast<double>((1 << bits) - 4);  ///< along one axis

  /// REQUIRES finite points, edge > 0 and points.cols() < 2³¹.
  /// Errors: BadInput where the points reach over more than `most_cubes` edges.
  static Expected<VoxelGrid> make(const Points& points, double edge);

  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  [[nodiscard]] double edge() const { return edge_; }
  [[nodiscard]] const Eigen::Vector3d& origin() const { return origin_; }
  [[nodiscard]] const Moments& moments(std::size_t cube) const { return moments_[cube]; }  ///< about origin()

  /// Columns of the cube's points, ascending; none in a coarsened grid.
  [[nodiscard]] std::span<const std::uint32_t> points_in(std::size_t cube) const {
    return order_.empty() ? std::span<const std::uint32_t>()
                          : std::span(order_).subspan(first_[cube], first_[cube + 1] - first_[cube]);
  }

  /// The moments of each cube together with its 26 neighbours.
  [[nodiscard]] std::vector<Moments> neighbourhoods() const;
  /// Cubes of twice the edge; they know no points.
  [[nodiscard]] VoxelGrid coarsened() const;
  /// Centroids of these cubes, in the frame of the points.
  [[nodiscard]] Eigen::Matrix3Xd centroids_of(const std::vector<std::size_t>& cubes) const;
  /// Columns of the points within `radius` of `centre`, ascending; `points` are those the grid was made of.
  [[nodiscard]] std::vector<int> within(const Points& points, const Eigen::Vector3d& centre, double radius) const;

 private:
  /// Puts the points in the order of their cubes and notes where each cube begins; `size` is that of the room.
  void sort(const Points& points, const Eigen::Vector3d& size);
  template <typename KeyAt>
  void begin_cubes(const KeyAt& key_at);
  void sum_up(const Points& points);
  /// Calls visit(cube) for every cube that may reach within `radius` of `centre`.
  template <typename Visit>
  void visit_around(const Eigen::Vector3d& centre, double radius, const Visit& visit) const;

  std::vector<std::uint64_t> keys_;   // ascending
  std::vector<Moments> moments_;      // of each
  std::vector<std::uint32_t> first_;  // where each cube's points begin in order_; one more at the end
  std::vector<std::uint32_t> order_;  // columns, cube by cube, ascending in each
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  double edge_ = 1.0;
};

}  // namespace artcal::segmentation
