#pragma once

// What nearly every test reads, compiled once (ARTCAL_PRECOMPILE_HEADERS).

#include <random>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cmake/precompiled.h"
#include "tests/support/places.h"
