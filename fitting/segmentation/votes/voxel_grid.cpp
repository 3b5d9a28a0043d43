#include "fitting/segmentation/votes/voxel_grid.h"

#include <algorithm>
#include <bit>
#include <compare>

#include <fmt/format.h>

#include "core/large_pages.h"
#include "core/parallel.h"
#include "fitting/bounding_box.h"
#include "fitting/point_blocks.h"
#include "fitting/segmentation/votes/radix_sort.h"

namespace artcal::segmentation {
namespace {

using Key = std::uint64_t;
constexpr Key y_step = Key{1} << VoxelGrid::bits;
constexpr Key z_step = y_step << VoxelGrid::bits;
constexpr Key axis_mask = y_step - 1;

constexpr std::size_t ahead = 16;  // points

// A cube of the finer grid and its key.
struct Keyed {
  Key key;
  std::uint32_t index;
  auto operator<=>(const Keyed&) const = default;
};

// Cubes are counted from 1, so that a neighbour below the first one does not borrow from the next axis.
// REQUIRES offset ≥ 0: the conversion takes off what is behind the point, as floor does.
Key coordinate(double offset, double edge) { return static_cast<Key>(static_cast<std::int64_t>(offset / edge)) + 1; }

// Different columns of `count`, ascending. Many of them are faster marked and read off than compared.
void sort_columns(std::vector<int>& columns, std::size_t count) {
  if (columns.size() < count / 64) {
    std::sort(columns.begin(), columns.end());
    return;
  }
  std::vector<std::uint64_t> marks(count / 64 + 1, 0);
  for (const int column : columns) {
    marks[static_cast<std::size_t>(column) / 64] |= std::uint64_t{1} << (static_cast<unsigned>(column) % 64);
  }
  auto next = columns.begin();
  for (std::size_t word = 0; word < marks.size(); ++word) {
    for (std::uint64_t left = marks[word]; left != 0; left &= left - 1) {
      *next++ = static_cast<int>(64 * word) + std::countr_zero(left);
    }
  }
}

template <typename Visit>
void each_point(std::size_t count, const Visit& visit) {
  parallel_blocks(count, fitting::points_of_a_block, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      visit(i);
    }
  });
}

/// How keys are packed for sorting: as many bits an axis as the cubes of this grid need.
struct Packing {
  std::array<int, 3> bits{};

  [[nodiscard]] int total() const { return bits[0] + bits[1] + bits[2]; }
  [[nodiscard]] Key packed(Key x, Key y, Key z) const { return (((z << bits[1]) | y) << bits[0]) | x; }
  [[nodiscard]] Key key_of(Key packed) const {
    const Key x = packed & ((Key{1} << bits[0]) - 1);
    const Key y = (packed >> bits[0]) & ((Key{1} << bits[1]) - 1);
    return x + y_step * y + z_step * (packed >> (bits[0] + bits[1]));
  }
};

}  // namespace

void Moments::add(const Eigen::Vector3d& p) {
  count += 1.0;
  sum += p;
  squares.noalias() += p * p.transpose();
}

Moments& Moments::operator+=(const Moments& other) {
  count += other.count;
  sum += other.sum;
  squares += other.squares;
  return *this;
}

Expected<VoxelGrid> VoxelGrid::make(const Points& points, double edge) {
  VoxelGrid grid;
  grid.edge_ = edge;
  const fitting::BoundingBox box = fitting::bounding_box(points);
  grid.origin_ = box.low;
  const double reach = box.size().maxCoeff();
  if (!(reach < edge * max_cubes)) {
    return bad_input(
        fmt::format("the points reach over {:.4g} mm, more than {:.2g} times the {:.4g} mm that are looked "
                    "at together; is the unit right, and are there stray points far away?",
                    reach, max_cubes, edge));
  }
  grid.sort(points, box.size());
  grid.sum_up(points);
  return grid;
}

void VoxelGrid::sort(const Points& points, const Eigen::Vector3d& size) {
  const auto count = static_cast<std::size_t>(points.cols());
  Packing packing;
  for (int axis = 0; axis < 3; ++axis) {
    packing.bits[axis] = static_cast<int>(std::bit_width(coordinate(size(axis), edge_)));
  }
  const auto cube_of = [&](std::size_t i) {
    const Eigen::Vector3d offset = points.col(static_cast<Eigen::Index>(i)) - origin_;
    return packing.packed(coordinate(offset.x(), edge_), coordinate(offset.y(), edge_), coordinate(offset.z(), edge_));
  };
  order_ = large_vector<std::uint32_t>(count);
  // One number a point: its cube above, its column below. In rooms of billions of cubes both do not go into one.
  const auto index_bits = static_cast<int>(std::bit_width(count));
  if (packing.total() + index_bits > 64) {
    std::vector<Keyed> keyed(count);
    each_point(count, [&](std::size_t i) { keyed[i] = {cube_of(i), static_cast<std::uint32_t>(i)}; });
    std::ranges::sort(keyed);
    each_point(count, [&](std::size_t k) { order_[k] = keyed[k].index; });
    begin_cubes([&](std::size_t k) { return packing.key_of(keyed[k].key); });
    return;
  }
  auto numbers = large_vector<std::uint64_t>(count);
  each_point(count, [&](std::size_t i) { numbers[i] = (cube_of(i) << index_bits) | i; });
  radix_sort(numbers, index_bits, index_bits + packing.total());
  const std::uint64_t index_mask = (std::uint64_t{1} << index_bits) - 1;
  each_point(count, [&](std::size_t k) { order_[k] = static_cast<std::uint32_t>(numbers[k] & index_mask); });
  begin_cubes([&](std::size_t k) { return packing.key_of(numbers[k] >> index_bits); });
}

template <typename KeyAt>
void VoxelGrid::begin_cubes(const KeyAt& key_at) {
  for (std::size_t k = 0; k < order_.size(); ++k) {
    if (const Key key = key_at(k); keys_.empty() || keys_.back() != key) {
      keys_.push_back(key);
      first_.push_back(static_cast<std::uint32_t>(k));
    }
  }
  first_.push_back(static_cast<std::uint32_t>(order_.size()));
}

// Cubes are summed up side by side, the points of each in their order.
void VoxelGrid::sum_up(const Points& points) {
  moments_.resize(size());
  const std::size_t parts = (order_.size() + fitting::points_of_a_block - 1) / fitting::points_of_a_block;
  const auto cube_from = [&](std::size_t part) {
    return static_cast<std::size_t>(
        std::lower_bound(first_.begin(), first_.end() - 1, part * fitting::points_of_a_block) - first_.begin());
  };
  parallel_for(parts, 0, [&](std::size_t part) {
    for (std::size_t cube = cube_from(part), end = cube_from(part + 1); cube < end; ++cube) {
      Moments moments;
      for (std::size_t k = first_[cube]; k < first_[cube + 1]; ++k) {
        // The points of a cube lie anywhere in memory: what comes next is asked for in time.
        __builtin_prefetch(points.col(order_[std::min(k + ahead, order_.size() - 1)]).data());
        moments.add(points.col(order_[k]) - origin_);
      }
      moments_[cube] = moments;
    }
  });
}

std::vector<Moments> VoxelGrid::neighbourhoods() const {
  std::vector<Moments> sums(size());
  for (const Key dz : {Key{0} - z_step, Key{0}, z_step}) {
    for (const Key dy : {Key{0} - y_step, Key{0}, y_step}) {
      std::size_t low = 0;  // keys ascend, and so do those of the neighbours: one walk through all
      for (std::size_t i = 0; i < size(); ++i) {
        const Key middle = keys_[i] + dy + dz;
        while (low < size() && keys_[low] < middle - 1) {
          ++low;
        }
        for (std::size_t j = low; j < size() && keys_[j] <= middle + 1; ++j) {
          sums[i] += moments_[j];
        }
      }
    }
  }
  return sums;
}

VoxelGrid VoxelGrid::coarsened() const {
  VoxelGrid coarse;
  coarse.edge_ = 2.0 * edge_;
  coarse.origin_ = origin_;
  std::vector<Keyed> keyed(size());
  for (std::size_t i = 0; i < size(); ++i) {
    Key key = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Key fine = (keys_[i] >> (axis * bits)) & axis_mask;
      key |= ((fine + 1) / 2) << (axis * bits);
    }
    keyed[i] = {key, static_cast<std::uint32_t>(i)};
  }
  std::ranges::sort(keyed);
  for (const auto& [key, index] : keyed) {
    if (coarse.keys_.empty() || coarse.keys_.back() != key) {
      coarse.keys_.push_back(key);
      coarse.moments_.emplace_back();
    }
    coarse.moments_.back() += moments_[index];
  }
  return coarse;
}

template <typename Visit>
void VoxelGrid::visit_around(const Eigen::Vector3d& centre, double radius, const Visit& visit) const {
  const auto bound = [&](double value) { return std::clamp(value, 0.0, edge_ * (max_cubes + 1.0)); };
  std::array<Key, 3> low{};
  std::array<Key, 3> high{};
  for (int axis = 0; axis < 3; ++axis) {
    const double offset = centre(axis) - origin_(axis);
    low[axis] = coordinate(bound(offset - radius), edge_);
    high[axis] = coordinate(bound(offset + radius), edge_);
  }
  for (Key z = low[2]; z <= high[2]; ++z) {
    for (Key y = low[1]; y <= high[1]; ++y) {
      const Key row = y * y_step + z * z_step;
      auto key = std::lower_bound(keys_.begin(), keys_.end(), row + low[0]);
      for (; key != keys_.end() && *key <= row + high[0]; ++key) {
        visit(static_cast<std::size_t>(key - keys_.begin()));
      }
    }
  }
}

Eigen::Matrix3Xd VoxelGrid::centroids_of(const std::vector<std::size_t>& cubes) const {
  Eigen::Matrix3Xd centroids(3, static_cast<Eigen::Index>(cubes.size()));
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    const Moments& moments = moments_[cubes[i]];
    centroids.col(static_cast<Eigen::Index>(i)) = origin_ + moments.sum / moments.count;
  }
  return centroids;
}

std::vector<int> VoxelGrid::within(const Points& points, const Eigen::Vector3d& centre, double radius) const {
  std::vector<int> found;
  visit_around(centre, radius, [&](std::size_t cube) {
    for (std::uint32_t k = first_[cube]; k < first_[cube + 1]; ++k) {
      if ((points.col(order_[k]) - centre).squaredNorm() < radius * radius) {
        found.push_back(static_cast<int>(order_[k]));
      }
    }
  });
  sort_columns(found, order_.size());
  return found;
}

}  // namespace artcal::segmentation
