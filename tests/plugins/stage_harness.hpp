#pragma once

#include <gtest/gtest.h>

#include "stope/testing/stage_harness.hpp"
