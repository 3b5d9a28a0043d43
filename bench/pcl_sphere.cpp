#include "bench/pcl_sphere.h"

#include <numeric>

#include <pcl/point_types.h>
#include <pcl/sample_consensus/sac_model_sphere.h>

struct PclSphere::Model {
  pcl::SampleConsensusModelSphere<pcl::PointXYZ> sphere;
  pcl::Indices all;
};

PclSphere::PclSphere(const Eigen::Matrix3Xd& points) {
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (const auto& p : points.cast<float>().colwise()) {
    cloud->emplace_back(p.x(), p.y(), p.z());
  }
  model_ = std::make_unique<Model>(Model{pcl::SampleConsensusModelSphere<pcl::PointXYZ>(cloud), {}});
  model_->all.resize(cloud->size());
  std::iota(model_->all.begin(), model_->all.end(), 0);
}

PclSphere::~PclSphere() = default;

Eigen::Vector4f PclSphere::refine(const Eigen::Vector4f& start) const {
  Eigen::VectorXf refined;
  model_->sphere.optimizeModelCoefficients(model_->all, start, refined);
  return refined;
}
