#include "fitting/minimum_zone/radial_zone.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "fitting/minimum_zone/linear_program.h"

namespace artcal::fitting {
namespace {

enum class Aim { ThinnestShell, LargestEmpty };

template <int Dimension>
using Vector = Eigen::Matrix<double, Dimension, 1>;

// Distances of the points from a centre, and how they fall when the centre moves: |p − c − δ| ≈ ρ − û·δ.
// The true distance is never below that (it is convex in δ).
template <int Dimension>
struct Radii {
  Eigen::RowVectorXd rho;
  BallPoints<Dimension> unit;

  Radii(const BallPoints<Dimension>& points, const Vector<Dimension>& centre)
      : rho((points.colwise() - centre).colwise().norm()), unit(points.colwise() - centre) {
    for (Eigen::Index i = 0; i < rho.size(); ++i) {
      unit.col(i) /= std::max(rho(i), 1e-300);
    }
  }
};

// What is to be made small: the shell's thickness, or the empty ball's radius with its sign changed.
double objective(Aim aim, const Eigen::RowVectorXd& rho) {
  return aim == Aim::ThinnestShell ? rho.maxCoeff() - rho.minCoeff() : -rho.minCoeff();
}

// The points that may decide: a linear program over them alone, and those it overlooked added until
// none is. Variables (δ, r, h): shell |ρ − û·δ − r| ≤ h; empty ball: r − (ρ − û·δ) ≤ 0 and h unused.
template <int Dimension>
class LinearStep {
 public:
  LinearStep(Aim aim, const Radii<Dimension>& radii, double reach) : aim_(aim), radii_(radii), reach_(reach) {
    std::vector<int> order(static_cast<std::size_t>(radii.rho.size()));
    for (std::size_t i = 0; i < order.size(); ++i) {
      order[i] = static_cast<int>(i);
    }
    std::sort(order.begin(), order.end(), [&](int a, int b) { return radii.rho(a) < radii.rho(b); });
    for (std::size_t i = 0; i < std::min<std::size_t>(order.size(), 6); ++i) {
      rows_.insert(order[i]);
      if (aim == Aim::ThinnestShell) {
        rows_.insert(order[order.size() - 1 - i]);
      }
    }
  }

  std::optional<Vector<Dimension>> solve() {
    for (;;) {
      const auto x = solve_rows();
      if (!x) {
        return std::nullopt;
      }
      if (!add_overlooked(*x)) {
        return x->template head<Dimension>();
      }
    }
  }

 private:
  std::optional<Eigen::VectorXd> solve_rows() const {
    const bool shell = aim_ == Aim::ThinnestShell;
    const int variables = shell ? Dimension + 2 : Dimension + 1;
    const auto count = static_cast<int>(rows_.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero((shell ? 2 : 1) * count + 2 * Dimension, variables);
    Eigen::VectorXd b = Eigen::VectorXd::Constant(a.rows(), reach_);
    int row = 0;
    for (const int i : rows_) {
      a.row(row).template head<Dimension>() = radii_.unit.col(i).transpose();
      a(row, Dimension) = 1.0;
      b(row) = radii_.rho(i);
      if (shell) {
        a(row, Dimension + 1) = -1.0;
        a.row(row + 1) = -a.row(row);
        a(row + 1, Dimension + 1) = -1.0;
        b(row + 1) = -b(row);
      }
      row += shell ? 2 : 1;
    }
    for (int j = 0; j < Dimension; ++j) {  // the box that the linearisation is trusted in
      a(row++, j) = 1.0;
      a(row++, j) = -1.0;
    }
    Eigen::VectorXd cost = Eigen::VectorXd::Zero(variables);
    cost(variables - 1) = shell ? 1.0 : -1.0;
    return minimise_linear(cost, a, b);
  }

  // The worst point on either side that the solution leaves out of its bounds; false if there is none.
  bool add_overlooked(const Eigen::VectorXd& x) {
    const Eigen::RowVectorXd over = (radii_.rho - x.head<Dimension>().transpose() * radii_.unit).array() - x(Dimension);
    const double h = aim_ == Aim::ThinnestShell ? x(Dimension + 1) : 0.0;
    Eigen::Index low = 0;
    Eigen::Index high = 0;
    const bool below = over.minCoeff(&low) < -h - tolerance;
    const bool above = aim_ == Aim::ThinnestShell && over.maxCoeff(&high) > h + tolerance;
    const bool new_low = below && rows_.insert(static_cast<int>(low)).second;
    const bool new_high = above && rows_.insert(static_cast<int>(high)).second;
    return new_low || new_high;
  }

  static constexpr double tolerance = 1e-15;
  Aim aim_;
  const Radii<Dimension>& radii_;
  double reach_;
  std::set<int> rows_;
};

// Sequential linear programming: near a corner of the feasible set, where these optima lie, each step
// squares the error like Newton's. A step that does not help is retried within a smaller box.
template <int Dimension>
Expected<Vector<Dimension>> descend(Aim aim, const BallPoints<Dimension>& points, Vector<Dimension> centre) {
  constexpr double far = 5.0;  // times the size of the cloud: no points there to hold the centre
  constexpr int max_steps = 200;
  double reach = 0.25;
  Radii<Dimension> radii(points, centre);
  for (int step = 0; step < max_steps && reach > 1e-15; ++step) {
    const auto delta = LinearStep<Dimension>(aim, radii, reach).solve();
    if (!delta || centre.norm() > far) {
      break;
    }
    const Radii<Dimension> next(points, centre + *delta);
    if (objective(aim, next.rho) < objective(aim, radii.rho)) {
      centre += *delta;
      radii = next;
      continue;
    }
    if (delta->norm() < 1e-12) {
      return centre;
    }
    reach = std::min(0.25 * reach, delta->norm());
  }
  if (reach <= 1e-15) {
    return centre;
  }
  return no_solution(
      "the points do not surround their centre closely enough for this criterion, which has no optimum near the "
      "least-squares one; probe all around, or ask for least squares");
}

}  // namespace

template <int Dimension>
Expected<Ball<Dimension>> minimum_zone(const BallPoints<Dimension>& points, const Vector<Dimension>& start) {
  return descend<Dimension>(Aim::ThinnestShell, points, start).map([&](const Vector<Dimension>& centre) {
    const Eigen::RowVectorXd rho = (points.colwise() - centre).colwise().norm();
    return Ball<Dimension>{centre, 0.5 * (rho.maxCoeff() + rho.minCoeff())};
  });
}

template <int Dimension>
Expected<Ball<Dimension>> maximum_inscribed(const BallPoints<Dimension>& points, const Vector<Dimension>& start) {
  return descend<Dimension>(Aim::LargestEmpty, points, start).map([&](const Vector<Dimension>& centre) {
    return Ball<Dimension>{centre, (points.colwise() - centre).colwise().norm().minCoeff()};
  });
}

template Expected<Ball<2>> minimum_zone<2>(const BallPoints<2>&, const Eigen::Vector2d&);
template Expected<Ball<3>> minimum_zone<3>(const BallPoints<3>&, const Eigen::Vector3d&);
template Expected<Ball<2>> maximum_inscribed<2>(const BallPoints<2>&, const Eigen::Vector2d&);
template Expected<Ball<3>> maximum_inscribed<3>(const BallPoints<3>&, const Eigen::Vector3d&);

}  // namespace artcal::fitting
