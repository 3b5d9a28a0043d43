// Every variant that this machine has, against the sums written out one by one in the order that the header states.
#include "identification/least_squares/kernels/gram.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace artcal {
namespace {

struct alignas(64) Line {
  double numbers[8];
};

std::vector<Line> numbers_of(int count, const char* name) {
  RandomStream random(5, name);
  std::vector<Line> lines(static_cast<std::size_t>(count / 8));
  for (Line& line : lines) {
    for (double& number : line.numbers) {
      number = random.normal() * std::pow(10.0, 4.0 * random.uniform());
    }
  }
  return lines;
}

TEST(Gram, GivesTheSameBytesWithEveryInstructionSet) {
  for (const int columns : {8, 16, 24, 32, 40, 56}) {
    for (const int rows : {0, 1, 7, 96}) {
      const auto a = numbers_of(rows * columns + 8, "rows");
      const auto before = numbers_of(columns * columns, "gram");
      const double* numbers = a.front().numbers;
      const double* at_first = before.front().numbers;
      for (const GramVariant& variant : gram_variants()) {
        auto sums = before;
        double* gram = sums.front().numbers;
        variant.add(numbers, rows, columns, gram);
        for (int i = 0; i < columns; ++i) {
          for (int j = i; j < columns; ++j) {
            double sum = at_first[i * columns + j];
            for (int r = 0; r < rows; ++r) {
              sum = sum + numbers[r * columns + i] * numbers[r * columns + j];
            }
            ASSERT_EQ(gram[i * columns + j], sum)
                << variant.instructions << ", " << rows << " x " << columns << " at " << i << ", " << j;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace artcal
