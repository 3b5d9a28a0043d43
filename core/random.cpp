#include "core/random.h"

#include <bit>
#include <cmath>

#include <Eigen/Geometry>

namespace artcal {
namespace {

std::uint64_t splitmix64(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// FNV-1a: enough to tell names apart, and the same on every machine.
std::uint64_t hash_name(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : name) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  }
  return hash;
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view name, std::uint64_t index) {
  std::uint64_t mix = seed;
  mix = splitmix64(mix) ^ hash_name(name);
  mix = splitmix64(mix) ^ index;
  for (auto& word : state_) {
    word = splitmix64(mix);
  }
}

std::uint64_t RandomStream::bits() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t t = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double RandomStream::uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

double RandomStream::uniform(double low, double high) { return low + (high - low) * uniform(); }

double RandomStream::normal() {
  for (;;) {
    const double u = uniform(-1.0, 1.0);
    const double v = uniform(-1.0, 1.0);
    const double s = u * u + v * v;
    if (s > 0.0 && s < 1.0) {
      return u * std::sqrt(-2.0 * std::log(s) / s);
    }
  }
}

Eigen::Vector3d RandomStream::direction() {
  Eigen::Vector3d v;
  do {
    v = {normal(), normal(), normal()};
  } while (v.squaredNorm() == 0.0);
  return v.normalized();
}

Eigen::Matrix3d RandomStream::rotation() {
  Eigen::Quaterniond q;
  do {
    // Braces, not parentheses: they fix the order of the four calls.
    q = Eigen::Quaterniond{normal(), normal(), normal(), normal()};
  } while (q.squaredNorm() == 0.0);
  return q.normalized().toRotationMatrix();
}

}  // namespace artcal
