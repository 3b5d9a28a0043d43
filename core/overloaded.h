#pragma once

namespace artcal {

/// Functions of different arguments as one, for std::visit and for walks that meet several kinds of things.
template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace artcal
