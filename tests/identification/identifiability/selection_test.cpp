#include "identification/identifiability/selection.h"

#include <gtest/gtest.h>

#include "identification/identify.h"
#include "tests/support/probing/outcome.h"

namespace artcal {
namespace {

// Where the last two axes are parallel, a6 and theta6 are no pair: theta6 goes with theta5 and d6 with l. One parameter
// fixed too many left 0.19 mm where the noise is 0.015 mm, with exit code 0.
TEST(Selection, FixesAsManyParametersAsAreNotIdentifiable) {
  for (const double last_alpha : {90.0, -90.0, 0.0, 180.0}) {
    const auto session = probing::probe({.kind = probing::Kind::Bar4, .placements = 6, .last_alpha = last_alpha});
    const auto bound = probing::bound(session, 0.015);
    IdentifyOptions options;
    options.leave_out = false;
    options.noise.reading = 0.015;
    const auto result = identify(bound.recording, bound.constraints, options);
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_EQ(static_cast<int>(result->free.size()), result->coupling.rank) << last_alpha;
    EXPECT_LT(result->chi_squared, 1.2 * result->degrees_of_freedom) << last_alpha;
    EXPECT_EQ(probing::outcome(session, result), probing::Outcome::Found) << last_alpha;
  }
}

}  // namespace
}  // namespace artcal
