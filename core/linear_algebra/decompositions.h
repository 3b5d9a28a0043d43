#pragma once

#include <Eigen/Dense>

// Each of these takes g++ seconds wherever it is used: they are compiled once, in decompositions.cpp. Only precompiled
// headers read this; what is compiled without them compiles its own, as ever.
#define INSTANCE extern template
#include "core/linear_algebra/decompositions.inc"
#undef INSTANCE
