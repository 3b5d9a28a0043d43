#include "acquisition/recording/reading_fingerprint.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include <fmt/format.h>

#include "core/files/hash.h"

namespace artcal {
namespace {

constexpr std::size_t digits = 12;  // 48 bits: a chance agreement in a test of 1,000 readings happens once in 7e7
constexpr double step = 1e-6;       // rad

}  // namespace

std::string reading_fingerprint(const Eigen::Ref<const Eigen::VectorXd>& joints) {
  if (joints.size() == 0 || !joints.allFinite()) {
    return {};
  }
  std::string text;
  for (const double angle : joints) {
    const double steps = std::round(angle / step) + 0.0;  // no -0
    if (std::abs(steps) < 1e15) {                         // the same text in a tenth of the time
      fmt::format_to(std::back_inserter(text), "{} ", static_cast<std::int64_t>(steps));
    } else {
      fmt::format_to(std::back_inserter(text), "{:.0f} ", steps);
    }
  }
  return sha256(text).substr(0, digits);
}

std::vector<std::string> fingerprints_of(const Recording& recording, const std::vector<std::string>& earlier) {
  std::vector<std::string> all = earlier;
  for (Eigen::Index i = 0; i < recording.joints.cols(); ++i) {
    if (std::string one = reading_fingerprint(recording.joints.col(i)); !one.empty()) {
      all.push_back(std::move(one));
    }
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  all.resize(std::min(all.size(), max_fingerprints));
  return all;
}

int count_known(const Recording& recording, const std::vector<std::string>& known) {
  int count = 0;
  for (Eigen::Index i = 0; i < recording.joints.cols() && !known.empty(); ++i) {
    const std::string one = reading_fingerprint(recording.joints.col(i));
    count += !one.empty() && std::binary_search(known.begin(), known.end(), one) ? 1 : 0;
  }
  return count;
}

}  // namespace artcal
