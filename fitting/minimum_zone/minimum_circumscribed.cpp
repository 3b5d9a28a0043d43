#include "fitting/minimum_zone/minimum_circumscribed.h"

#include <vector>

#include <CGAL/Min_sphere_of_points_d_traits_2.h>
#include <CGAL/Min_sphere_of_points_d_traits_3.h>
#include <CGAL/Min_sphere_of_spheres_d.h>
#include <CGAL/Simple_cartesian.h>

namespace artcal::fitting {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;

Kernel::Point_2 as_point(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }
Kernel::Point_3 as_point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

template <int Dimension>
struct Traits;
template <>
struct Traits<2> {
  using Point = Kernel::Point_2;
  using Type = CGAL::Min_sphere_of_points_d_traits_2<Kernel, double, CGAL::Tag_true>;
};
template <>
struct Traits<3> {
  using Point = Kernel::Point_3;
  using Type = CGAL::Min_sphere_of_points_d_traits_3<Kernel, double, CGAL::Tag_true>;
};

}  // namespace

// Min_sphere_of_spheres_d pivots by largest distance (Fischer, Gärtner 2003) and is meant for doubles;
// Min_sphere_d is not: away from the origin it is wrong by more than the sphere.
template <int Dimension>
Ball<Dimension> minimum_circumscribed(const BallPoints<Dimension>& points) {
  std::vector<typename Traits<Dimension>::Point> all;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Matrix<double, Dimension, 1> p = points.col(i);
    all.push_back(as_point(p));
  }
  CGAL::Min_sphere_of_spheres_d<typename Traits<Dimension>::Type> smallest(all.begin(), all.end());
  Ball<Dimension> ball;
  std::copy(smallest.center_cartesian_begin(), smallest.center_cartesian_end(), ball.centre.data());
  ball.radius = (points.colwise() - ball.centre).colwise().norm().maxCoeff();
  return ball;
}

template Ball<2> minimum_circumscribed(const BallPoints<2>&);
template Ball<3> minimum_circumscribed(const BallPoints<3>&);

}  // namespace artcal::fitting
