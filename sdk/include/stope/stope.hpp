#pragma once

/// Everything a stage needs.
#include "stope/payloads.hpp"
#include "stope/stage_instance.hpp"
