#pragma once

/// Marks what the SDK's shared library exports. Everything else stays private to it.
#define STOPE_API __attribute__((visibility("default")))
