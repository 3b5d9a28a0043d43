// What nearly every source reads, compiled once (cmake/layer.cmake). A source includes what it uses all the same: the
// sanitizers' builds have no precompiled headers.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Dense>
#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "core/linear_algebra/decompositions.h"
