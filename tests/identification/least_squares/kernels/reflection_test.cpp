// Every variant that this machine has, against the sums written out one by one in the order that the header states.
#include "identification/least_squares/kernels/reflection.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "core/random.h"

namespace artcal {
namespace {

struct Task {
  int pairs, groups, stride;
  double twice;
  std::vector<RowPairs> v;
  std::vector<double> row;
  std::vector<RowPairs> columns;
};

Task task_of(int pairs, int groups) {
  RandomStream random(3, "reflection");
  Task task{pairs, groups, pairs + 2, 0.3, std::vector<RowPairs>(pairs), std::vector<double>(4 * groups), {}};
  task.columns.resize(static_cast<std::size_t>(groups * task.stride));
  for (RowPairs& pair : task.v) {
    const double numbers[2] = {random.normal(), random.normal()};
    for (int i = 0; i < 8; ++i) {
      pair.values[i] = numbers[i % 2];
    }
  }
  for (double& number : task.row) {
    number = random.normal();
  }
  for (RowPairs& pair : task.columns) {
    for (double& number : pair.values) {
      number = random.normal() * std::pow(10.0, 4.0 * random.uniform());
    }
  }
  return task;
}

void reflect_one_by_one(Task& task) {
  for (int column = 0; column < 4 * task.groups; ++column) {
    RowPairs* pairs = task.columns.data() + column / 4 * task.stride;
    const int at = 2 * (column % 4);
    double sums[2] = {0.0, 0.0};
    for (int p = 0; p < task.pairs; ++p) {
      for (int i = 0; i < 2; ++i) {
        sums[i] = sums[i] + task.v[p].values[i] * pairs[p].values[at + i];
      }
    }
    const double along = task.twice * (sums[0] + sums[1] + task.row[column]);
    task.row[column] -= along;
    for (int p = 0; p < task.pairs; ++p) {
      for (int i = 0; i < 2; ++i) {
        pairs[p].values[at + i] -= along * task.v[p].values[i];
      }
    }
  }
}

TEST(Reflection, GivesTheSameBytesWithEveryInstructionSet) {
  for (const int pairs : {1, 7, 48}) {
    for (const int groups : {1, 2, 3, 4, 5, 9}) {
      Task expected = task_of(pairs, groups);
      reflect_one_by_one(expected);
      for (const ReflectionVariant& variant : reflection_variants()) {
        Task task = task_of(pairs, groups);
        variant.reflect(task.v.data(), task.pairs, task.twice, task.row.data(), task.columns.data(), task.stride,
                        task.groups);
        EXPECT_EQ(task.row, expected.row) << variant.instructions << ", " << groups << " groups";
        EXPECT_EQ(std::memcmp(task.columns.data(), expected.columns.data(), task.columns.size() * sizeof(RowPairs)), 0)
            << variant.instructions << ", " << groups << " groups of " << pairs << " pairs";
      }
    }
  }
}

}  // namespace
}  // namespace artcal
