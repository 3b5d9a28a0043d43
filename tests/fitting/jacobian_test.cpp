// Every model's derivative against differences of its residuals.
#include <gtest/gtest.h>

#include "fitting/cloud.h"
#include "fitting/least_squares/round_models.h"
#include "fitting/least_squares/row_reducer.h"
#include "tests/fitting/shapes.h"

namespace artcal::test {
namespace {

using namespace fitting;

template <typename Model>
Eigen::MatrixXd rows_of(const Model& model, const RoundState& state) {
  std::vector<double> all;
  model.rows(state, [&](const Eigen::Matrix<double, 1, Model::size + 1>& row) {
    all.insert(all.end(), row.data(), row.data() + row.size());
  });
  const auto count = static_cast<Eigen::Index>(all.size()) / (Model::size + 1);
  return Eigen::Map<Eigen::MatrixXd>(all.data(), Model::size + 1, count).transpose();
}

template <typename Model>
void expect_derivative(double curvature, double taper) {
  const Cloud cloud = *make_cloud(Shape<Sphere>::points(20, 1.0), {}, {"test", 3, 3});
  RandomStream random(13, "jacobian");
  const RoundState state{0.3 * random.direction(), random.rotation(), curvature, taper};
  const Model model{cloud};
  const Eigen::MatrixXd rows = rows_of(model, state);
  for (int j = 0; j < Model::size; ++j) {
    const typename Model::Step step = 1e-6 * Model::Step::Unit(j);
    const Eigen::VectorXd difference = (rows_of(model, model.moved(state, step)).col(Model::size) -
                                        rows_of(model, model.moved(state, -step)).col(Model::size)) /
                                       2e-6;
    EXPECT_LT((difference - rows.col(j)).cwiseAbs().maxCoeff(), 2e-8) << "column " << j << ", curvature " << curvature;
  }
}

TEST(Jacobian, OfEveryModelAtEveryCurvature) {
  for (const double curvature : {1e-8, 0.05, 0.8, -0.4}) {
    expect_derivative<SphereModel<false>>(curvature, 0.0);
    expect_derivative<SphereModel<true>>(curvature, 0.0);
    expect_derivative<CircleModel<false>>(curvature, 0.0);
    expect_derivative<CircleModel<true>>(curvature, 0.0);
    expect_derivative<AxialModel<false>>(curvature, 0.0);
    for (const double taper : {0.0, 0.3, -0.2}) {
      if (std::abs(curvature) > 1e-3) {
        expect_derivative<AxialModel<true>>(curvature, taper);
      }
    }
  }
}

TEST(RowReducer, KeepsTheGramMatrix) {
  Eigen::MatrixXd all(500, 4);
  RowReducer<4> reducer;
  RandomStream random(17, "rows");
  for (Eigen::Index i = 0; i < all.rows(); ++i) {
    all.row(i) << random.normal(), random.normal(), 1e-6 * random.normal(), random.normal();
    reducer.add(all.row(i));
    if (i == 2 || i == 499) {  // fewer rows than columns, too
      const Eigen::MatrixXd r = RowReducer<4>(reducer).triangle();
      const Eigen::MatrixXd gram = all.topRows(i + 1).transpose() * all.topRows(i + 1);
      EXPECT_TRUE(r.isUpperTriangular(0.0));
      EXPECT_LT((r.transpose() * r - gram).cwiseAbs().maxCoeff(), 1e-12 * gram.cwiseAbs().maxCoeff());
      EXPECT_NEAR((r.transpose() * r)(2, 2) / gram(2, 2), 1.0, 1e-13);
    }
  }
}

}  // namespace
}  // namespace artcal::test
