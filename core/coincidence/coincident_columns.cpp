#include "core/coincidence/coincident_columns.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "core/large_pages.h"
#include "core/parallel.h"

namespace artcal {
namespace {

using Columns = Eigen::Ref<const Eigen::MatrixXd>;

constexpr std::size_t block_size = 1u << 16u;         // columns that are put into buckets together
constexpr std::size_t columns_of_bucket = 1u << 12u;  // so that a bucket's table stays in the nearest caches
constexpr std::size_t max_buckets = 1u << 12u;

/// A column in its bucket.
struct Entry {
  std::uint32_t tag;  // a part of the hash that the bucket does not tell
  std::uint32_t column;
};

// Equal columns have equal hashes.
std::uint64_t hash_of(const Columns& columns, Eigen::Index column) {
  std::uint64_t hash = 0;
  for (Eigen::Index row = 0; row < columns.rows(); ++row) {
    const double value = columns(row, column);
    const double one_of_equals = std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value + 0.0;
    hash = (hash ^ std::bit_cast<std::uint64_t>(one_of_equals)) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29u;
  }
  return hash * 0xBF58476D1CE4E5B9u;
}

bool are_equal(const Columns& columns, Eigen::Index a, Eigen::Index b) {
  for (Eigen::Index row = 0; row < columns.rows(); ++row) {
    const double x = columns(row, a), y = columns(row, b);
    if (!(x == y || (std::isnan(x) && std::isnan(y)))) {
      return false;
    }
  }
  return true;
}

/// Columns by the first bits of their hashes; ascending in each bucket.
class Buckets {
 public:
  Buckets(const Columns& columns, int threads) : count_(static_cast<std::size_t>(columns.cols())) {
    const std::size_t buckets = std::bit_ceil(std::clamp<std::size_t>(count_ / columns_of_bucket, 1, max_buckets));
    const int shift = 64 - std::countr_zero(buckets);
    const auto bucket_of = [&](std::uint64_t hash) {
      return buckets == 1 ? 0 : static_cast<std::size_t>(hash >> shift);
    };
    const std::size_t blocks = (count_ + block_size - 1) / block_size;
    const auto each = [&](std::size_t block, const auto& visit) {
      const std::size_t end = std::min(count_, (block + 1) * block_size);
      for (std::size_t i = block * block_size; i < end; ++i) {
        visit(i, hash_of(columns, static_cast<Eigen::Index>(i)));
      }
    };
    std::vector<std::size_t> places(blocks * buckets, 0);  // how many, and then where the next one goes
    parallel_for(blocks, threads, [&](std::size_t block) {
      each(block, [&](std::size_t, std::uint64_t hash) { ++places[block * buckets + bucket_of(hash)]; });
    });
    std::size_t next = 0;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
      first_.push_back(next);
      for (std::size_t block = 0; block < blocks; ++block) {
        next += std::exchange(places[block * buckets + bucket], next);
      }
    }
    first_.push_back(next);
    entries_ = large_vector<Entry>(count_);
    parallel_for(blocks, threads, [&](std::size_t block) {
      each(block, [&](std::size_t i, std::uint64_t hash) {
        entries_[places[block * buckets + bucket_of(hash)]++] = {static_cast<std::uint32_t>(hash),
                                                                 static_cast<std::uint32_t>(i)};
      });
    });
  }

  [[nodiscard]] std::size_t size() const { return first_.size() - 1; }

  // Each that repeats one before it.
  [[nodiscard]] std::vector<RepeatedColumn> repeated_in(std::size_t bucket, const Columns& columns) const {
    std::vector<RepeatedColumn> repeated;
    const std::size_t begin = first_[bucket];
    const std::size_t count = first_[bucket + 1] - begin;
    std::vector<std::uint32_t> table(std::bit_ceil(2 * count + 1), 0);  // entries of the bucket, from 1; 0: none
    const std::size_t mask = table.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      const Entry& entry = entries_[begin + i];
      std::size_t place = entry.tag & mask;
      for (; table[place] != 0; place = (place + 1) & mask) {
        const Entry& other = entries_[begin + table[place] - 1];
        if (other.tag == entry.tag && are_equal(columns, other.column, entry.column)) {
          repeated.push_back({entry.column, other.column});
          break;
        }
      }
      if (table[place] == 0) {
        table[place] = static_cast<std::uint32_t>(i + 1);
      }
    }
    return repeated;
  }

 private:
  std::size_t count_;
  std::vector<std::size_t> first_;  // entry of each bucket; one more at the end
  std::vector<Entry> entries_;
};

}  // namespace

std::vector<RepeatedColumn> repeated_columns(const Columns& columns, int threads) {
  assert(static_cast<std::uint64_t>(columns.cols()) < std::uint64_t{1} << 32u);
  const Buckets buckets(columns, threads);
  std::vector<std::vector<RepeatedColumn>> of_buckets(buckets.size());
  parallel_for(buckets.size(), threads,
               [&](std::size_t bucket) { of_buckets[bucket] = buckets.repeated_in(bucket, columns); });
  std::vector<RepeatedColumn> repeated;
  for (const auto& some : of_buckets) {
    repeated.insert(repeated.end(), some.begin(), some.end());
  }
  std::sort(repeated.begin(), repeated.end(),
            [](const RepeatedColumn& a, const RepeatedColumn& b) { return a.column < b.column; });
  return repeated;
}

std::vector<Eigen::Index> first_coincident(const Columns& columns) {
  std::vector<Eigen::Index> first(static_cast<std::size_t>(columns.cols()));
  std::iota(first.begin(), first.end(), 0);
  for (const auto& [column, earlier] : repeated_columns(columns)) {
    first[static_cast<std::size_t>(column)] = earlier;
  }
  return first;
}

}  // namespace artcal
