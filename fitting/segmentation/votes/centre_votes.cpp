#include "fitting/segmentation/votes/centre_votes.h"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace artcal::segmentation {
namespace {

constexpr double min_points = 6.0;
constexpr double points_that_tell_flatness = 12.0;

struct Patch {
  double count;
  Eigen::Vector3d centroid;
  Eigen::Vector3d variances;  // ascending
  Eigen::Vector3d normal;
};

Patch patch_of(const Moments& moments) {
  Patch patch;
  patch.count = moments.count;
  patch.centroid = moments.sum / moments.count;
  const Eigen::Matrix3d covariance = moments.squares / moments.count - patch.centroid * patch.centroid.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen;
  eigen.computeDirect(covariance);
  patch.variances = eigen.eigenvalues();
  patch.normal = eigen.eigenvectors().col(0);
  return patch;
}

// A piece of a sphere is hollow: over a disc the depth has the standard deviation 0.289·(λ1 + λ2)/R, over a
// strip 0.447·λ1/R. Half the lesser is left to chance. Noise only adds to it.
bool too_flat(const Patch& patch, double radius) {
  const double depth = std::sqrt(std::max(0.0, patch.variances(0)));
  return patch.count >= points_that_tell_flatness && depth < 0.145 * (patch.variances(1) + patch.variances(2)) / radius;
}

// On a line the normal is anyone's guess; in a lump there is none.
bool no_surface(const Patch& patch) {
  return patch.variances(1) < 0.03 * patch.variances(2) || patch.variances(0) > 0.25 * patch.variances(1);
}

}  // namespace

CentreVotes centre_votes(const VoxelGrid& grid, double radius) {
  CentreVotes votes;
  std::vector<Eigen::Vector3d> places;
  const std::vector<Moments> patches = grid.neighbourhoods();
  for (std::size_t cube = 0; cube < patches.size(); ++cube) {
    if (patches[cube].count < min_points) {
      continue;
    }
    const Patch patch = patch_of(patches[cube]);
    const double squared_depth = radius * radius - patch.variances.sum();
    if (no_surface(patch) || too_flat(patch, radius) || squared_depth <= 0.0) {
      continue;
    }
    const Eigen::Vector3d way = std::sqrt(squared_depth) * patch.normal;
    places.emplace_back(patch.centroid - way);
    places.emplace_back(patch.centroid + way);
    votes.cubes.insert(votes.cubes.end(), 2, cube);
  }
  votes.places.resize(3, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    votes.places.col(static_cast<Eigen::Index>(i)) = places[i];
  }
  return votes;
}

}  // namespace artcal::segmentation
