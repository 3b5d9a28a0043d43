#pragma once

#include <memory>

#include <Eigen/Core>

/// PCL's refinement of a sphere, behind plain Eigen types: its headers bring warnings and a float world.
class PclSphere {
 public:
  explicit PclSphere(const Eigen::Matrix3Xd& points);
  ~PclSphere();
  /// SampleConsensusModelSphere::optimizeModelCoefficients over all points from (centre, radius).
  [[nodiscard]] Eigen::Vector4f refine(const Eigen::Vector4f& start) const;

 private:
  struct Model;
  std::unique_ptr<Model> model_;
};
