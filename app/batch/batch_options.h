#pragma once

#include <string>

namespace artcal {

/// What a batch is asked beside the recordings, as far as results depend on it.
struct BatchOptions {
  bool leave_out = false;  ///< identify again without each placement

  /// As the store states it.
  [[nodiscard]] std::string text() const { return leave_out ? "leave-out" : ""; }
};

}  // namespace artcal
