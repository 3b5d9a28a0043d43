#include "identification/least_squares/rows.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/overloaded.h"
#include "identification/initial/nuisance_estimation.h"
#include "tests/support/recordings.h"

namespace artcal {
namespace {

// All blocks together meet each observation once: readings feature by feature, distances that bind, certificates.
TEST(BlockWalk, MeetsEachObservationOnce) {
  for (const char* name : {"examples/two-socket-bar", "tests/reference/aacmm-simulated/sphere-plate"}) {
    const test::Bound bound = test::read_bound(std::string(ARTCAL_SOURCE_DIR) + "/" + name + "/recording.toml");
    const Constraints& constraints = bound.constraints;
    const System system = make_system(bound.recording, constraints, bound.recording.arm, {});
    const auto unknowns = estimate_nuisance_parameters(system, bound.recording.arm, bound.recording);
    ASSERT_TRUE(unknowns) << unknowns.error().text();
    std::vector<int> features(constraints.features.size()), distances(constraints.distances.size()),
        certified(constraints.shared.size());
    for (const Block& block : blocks_of(constraints)) {
      for_each_observation(constraints, block, point_of(block, *unknowns),
                           Overloaded{[&](const FeatureReadings& readings) {
                                        EXPECT_EQ(&readings.feature, &constraints.features[readings.index]);
                                        EXPECT_EQ(readings.feature.group, block.group);
                                        ++features[readings.index];
                                      },
                                      [&](const BindingDistance& distance) { ++distances[distance.index]; },
                                      [&](const CertifiedParameter& parameter) {
                                        EXPECT_EQ(block.parameters.first + parameter.column, parameter.index);
                                        ++certified[parameter.index];
                                      }});
    }
    EXPECT_EQ(features, std::vector<int>(features.size(), 1)) << name;
    for (std::size_t d = 0; d < distances.size(); ++d) EXPECT_EQ(distances[d], constraints.distances[d].binds ? 1 : 0);
    EXPECT_EQ(certified, std::vector<int>(certified.size(), 1)) << name;
  }
}

// The columns of a block's rows follow one another without a gap.
TEST(BlockWalk, ColumnsFollowOneAnother) {
  const test::Bound bound = test::read_bound(test::example("two-socket-bar/recording.toml"));
  const System system =
      make_system(bound.recording, bound.constraints, bound.recording.arm, all_parameters(bound.recording.arm));
  for (const Block& block : blocks_of(bound.constraints)) {
    const BlockColumns columns(block, system, 4);
    std::vector<double> row(static_cast<std::size_t>(columns.all()));
    const RowsOut out = columns.out(row.data());
    EXPECT_EQ(out.stride, columns.all());
    EXPECT_EQ(out.by_arm, row.data() + block.unknowns + block.parameters.size);
    EXPECT_EQ(out.residuals, row.data() + columns.all() - 1);
    EXPECT_EQ(columns.fitted() + 4, columns.residual());
    EXPECT_EQ(out.by_group == nullptr, block.unknowns == 0);
  }
}

}  // namespace
}  // namespace artcal
