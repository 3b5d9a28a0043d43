#include "fitting/segmentation/planes/propose_plane.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_plane.h>

namespace artcal::segmentation {

std::optional<Plane> propose_plane(const Eigen::Matrix3Xd& points, const std::vector<char>& used, double width) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  if (points.cols() > 0) {
    middle = points.rowwise().mean();
  }
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (used[static_cast<std::size_t>(i)] == 0) {
      const Eigen::Vector3f p = (points.col(i) - middle).cast<float>();
      cloud->push_back({p.x(), p.y(), p.z()});
    }
  }
  if (cloud->size() < 3) {
    return std::nullopt;
  }
  // Not random: PCL then draws from a generator of a fixed seed.
  const auto model = pcl::make_shared<pcl::SampleConsensusModelPlane<pcl::PointXYZ>>(cloud, false);
  pcl::RandomSampleConsensus<pcl::PointXYZ> consensus(model, width);
  consensus.setMaxIterations(2000);
  consensus.setProbability(0.999);
  Eigen::VectorXf coefficients;
  if (!consensus.computeModel() || (consensus.getModelCoefficients(coefficients), coefficients.size() != 4)) {
    return std::nullopt;
  }
  Plane plane;
  plane.normal = coefficients.head<3>().cast<double>().normalized();
  plane.point = middle - static_cast<double>(coefficients(3)) * plane.normal;
  return plane;
}

}  // namespace artcal::segmentation
