#include "fitting/segmentation/votes/vote_peaks.h"

#include <algorithm>
#include <numeric>

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace artcal::segmentation {
namespace {

pcl::PointCloud<pcl::PointXYZ>::Ptr local_floats(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& middle) {
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->reserve(static_cast<std::size_t>(points.cols()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3f p = (points.col(i) - middle).cast<float>();
    cloud->push_back({p.x(), p.y(), p.z()});
  }
  return cloud;
}

}  // namespace

std::vector<VotePeak> vote_peaks(const CentreVotes& all, double radius, int fewest) {
  const Eigen::Matrix3Xd& votes = all.places;
  std::vector<VotePeak> peaks;
  if (votes.cols() < fewest) {
    return peaks;
  }
  const auto cloud = local_floats(votes, votes.rowwise().mean());
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  const auto count = static_cast<int>(votes.cols());
  std::vector<std::vector<int>> agreeing(static_cast<std::size_t>(count));
  std::vector<float> squared_distances;
  for (int i = 0; i < count; ++i) {
    tree.radiusSearch(i, 0.2 * radius, agreeing[i], squared_distances);
  }
  std::vector<int> by_strength(static_cast<std::size_t>(count));
  std::iota(by_strength.begin(), by_strength.end(), 0);
  std::stable_sort(by_strength.begin(), by_strength.end(),
                   [&](int a, int b) { return agreeing[a].size() > agreeing[b].size(); });
  for (const int i : by_strength) {
    if (static_cast<int>(agreeing[i].size()) < fewest) {
      break;
    }
    const bool taken = std::any_of(peaks.begin(), peaks.end(),
                                   [&](const VotePeak& peak) { return (peak.centre - votes.col(i)).norm() < radius; });
    if (!taken) {
      std::sort(agreeing[i].begin(), agreeing[i].end());  // the sum below must not depend on the tree
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      VotePeak peak;
      for (const int j : agreeing[i]) {
        sum += votes.col(j);
        peak.cubes.push_back(all.cubes[static_cast<std::size_t>(j)]);
      }
      peak.centre = sum / static_cast<double>(agreeing[i].size());
      peaks.push_back(std::move(peak));
    }
  }
  return peaks;
}

}  // namespace artcal::segmentation
