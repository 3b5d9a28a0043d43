#include "core/linear_algebra/decompositions.h"

#define INSTANCE template
#include "core/linear_algebra/decompositions.inc"
#undef INSTANCE
