#include "fitting/segmentation/spheres/ball_region.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "fitting/segmentation/spheres/direction_cells.h"

namespace artcal {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double band_of_radius = 0.1;
constexpr double foreign_of_radius = 0.5;
constexpr double max_far_off = 0.05;  // of the points
constexpr double margin = 15.0 * pi / 180.0;
constexpr double hangs_together = 25.0 * pi / 180.0;
constexpr int cells_per_edge = 17;
constexpr int cells_of_share = 5;  // so few that a sparse scan has points in all it covers

struct Cell {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // of unit directions
  std::vector<int> points;
  int part = -1;

  [[nodiscard]] Eigen::Vector3d direction() const { return sum.normalized(); }
};
using Cells = std::map<std::size_t, Cell>;

void add_to_cell(Cells& cells, const segmentation::DirectionCells& grid, const Eigen::Vector3d& from_centre,
                 int point) {
  Cell& cell = cells[grid.cell_of(from_centre)];
  cell.sum += from_centre.normalized();
  cell.points.push_back(point);
}

bool is_near(const Cell& cell, const Cell& other, double angle) {
  return cell.direction().dot(other.direction()) > std::cos(angle);
}

void remove_near(Cells& cells, const Cells& foreign) {
  std::erase_if(cells, [&](const auto& entry) {
    return std::any_of(foreign.begin(), foreign.end(),
                       [&](const auto& other) { return is_near(entry.second, other.second, margin); });
  });
}

// Numbers the parts that hang together; returns the one with most points, the first of equals.
int largest_part(Cells& cells) {
  int parts = 0;
  int best = -1;
  std::size_t most = 0;
  for (auto& [first, seed] : cells) {
    if (seed.part >= 0) {
      continue;
    }
    std::vector<Cell*> open{&seed};
    seed.part = parts;
    std::size_t count = 0;
    while (!open.empty()) {
      const Cell* cell = open.back();
      open.pop_back();
      count += cell->points.size();
      for (auto& [index, other] : cells) {
        if (other.part < 0 && is_near(*cell, other, hangs_together)) {
          other.part = parts;
          open.push_back(&other);
        }
      }
    }
    if (count > most) {
      most = count;
      best = parts;
    }
    ++parts;
  }
  return best;
}

double share_covered(const Eigen::Matrix3Xd& from_centre) {
  const segmentation::DirectionCells coarse(cells_of_share);
  std::vector<bool> seen(coarse.size(), false);
  double share = 0.0;
  for (Eigen::Index i = 0; i < from_centre.cols(); ++i) {
    const std::size_t cell = coarse.cell_of(from_centre.col(i));
    share += seen[cell] ? 0.0 : coarse.share(cell);
    seen[cell] = true;
  }
  return share;
}

}  // namespace

BallRegion ball_region(const Points& points, const Sphere& sphere) {
  assert(sphere.radius > 0.0);
  const segmentation::DirectionCells grid(cells_per_edge);
  BallRegion region;
  region.band = band_of_radius * sphere.radius;
  Cells candidates, foreign;
  const auto off = [&](Eigen::Index i) { return std::abs((points.col(i) - sphere.centre).norm() - sphere.radius); };
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double distance = off(i);
    if (distance <= foreign_of_radius * sphere.radius) {
      add_to_cell(distance <= region.band ? candidates : foreign, grid, points.col(i) - sphere.centre,
                  static_cast<int>(i));
    }
  }
  const auto count = [](const Cells& cells) {
    return std::accumulate(cells.begin(), cells.end(), 0, [](int sum, const auto& entry) {
      return sum + static_cast<int>(entry.second.points.size());
    });
  };
  region.beside_foreign = count(candidates);
  remove_near(candidates, foreign);
  const int part = largest_part(candidates);
  for (const auto& [index, cell] : candidates) {
    if (cell.part == part) {
      region.points.insert(region.points.end(), cell.points.begin(), cell.points.end());
    }
  }
  region.beside_foreign -= static_cast<int>(region.points.size());
  std::sort(region.points.begin(), region.points.end());
  region.share = share_covered(points(Eigen::all, region.points).colwise() - sphere.centre);
  region.far_off = static_cast<int>(
      std::count_if(region.points.begin(), region.points.end(), [&](int i) { return off(i) > 0.5 * region.band; }));
  return region;
}

bool BallRegion::is_clear() const {
  const auto count = static_cast<double>(points.size());
  return far_off <= max_far_off * count && beside_foreign <= count;
}

}  // namespace artcal
