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

// As the header states it, number by number.
std::vector<double> factor_of(std::vector<double> gram, int size, int columns) {
  const auto at = [&](int i, int j) -> double& { return gram[static_cast<std::size_t>(i * columns + j)]; };
  std::vector<double> squares;
  for (int k = 0; k < size; ++k) squares.push_back(at(k, k));
  for (int k = 0; k < size; ++k) {
    const bool depends = !(at(k, k) > 1e-14 * squares[static_cast<std::size_t>(k)]);
    const double root = std::sqrt(at(k, k));
    for (int j = k; j < size; ++j) at(k, j) = depends ? 0.0 : at(k, j) / root;
    for (int i = k + 1; i < size; ++i) {
      for (int j = i; j < size; ++j) at(i, j) = at(i, j) - at(k, i) * at(k, j);
    }
  }
  return gram;
}

TEST(Gram, IsFactoredToTheSameBytesWithEveryInstructionSet) {
  for (const int size : {1, 7, 8, 19, 40}) {
    const int columns = (size + 7) / 8 * 8;
    auto a = numbers_of(96 * columns, "rows");
    double* numbers = a.front().numbers;
    for (int r = 0; r < 96 && size > 7; ++r) numbers[r * columns + 5] = 0.0;
    auto gram = numbers_of(columns * columns, "gram");
    for (Line& line : gram) line = {};
    gram_variants().front().add(numbers, 96, columns, gram.front().numbers);
    const double* first = gram.front().numbers;
    const auto expected = factor_of({first, first + columns * columns}, size, columns);
    for (const GramFactorVariant& variant : gram_factor_variants()) {
      auto factor = gram;
      double* found = factor.front().numbers;
      variant.factor(found, size, columns);
      for (int i = 0; i < size; ++i) {
        for (int j = i; j < size; ++j) {
          ASSERT_EQ(found[i * columns + j], expected[static_cast<std::size_t>(i * columns + j)])
              << variant.instructions << ", " << size << " at " << i << ", " << j;
        }
      }
    }
  }
}

}  // namespace
}  // namespace artcal
