#pragma once

#include <functional>
#include <string>

#include "core/error.h"

namespace artcal {

/// One of `count` parts of a batch.
struct Shard {
  int index = 0;  ///< from 0
  int count = 1;
};

/// "3/8" is the third of eight. For "" the part of a Slurm job array that `variable` (getenv) tells, where it does:
/// SLURM_ARRAY_TASK_ID from SLURM_ARRAY_TASK_MIN on, SLURM_ARRAY_TASK_COUNT of them; else all. Refused as wrong usage:
/// what is no such part, an array that counts in steps.
Expected<Shard> parse_shard(const std::string& text, const std::function<const char*(const char*)>& variable);

}  // namespace artcal
