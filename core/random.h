#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <Eigen/Core>

namespace artcal {

/// A stream of random numbers known by (seed, name, index): the same three give the same numbers on
/// every machine, and streams of different names or indices do not disturb each other, so that work
/// can be split over threads without changing a digit. Generator: xoshiro256** (Blackman, Vigna 2018)
/// seeded through splitmix64; normal deviates by Marsaglia's polar method. The standard library's
/// distributions are not used: their digits differ from one implementation to the next.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name, std::uint64_t index = 0);

  std::uint64_t bits();
  double uniform();                         ///< in [0, 1)
  double uniform(double low, double high);  ///< in [low, high)
  double normal();                          ///< mean 0, standard deviation 1
  Eigen::Vector3d direction();              ///< uniform on the unit sphere
  Eigen::Matrix3d rotation();               ///< uniform over all rotations

 private:
  std::array<std::uint64_t, 4> state_;
};

}  // namespace artcal
