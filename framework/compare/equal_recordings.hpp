#pragma once

#include <string>
#include <vector>

#include "framework/compare/comparison.hpp"

namespace stope {

/// What a cell is made from: by cell, the contents_key() of its sources; empty if it was not
/// planned.
using SourceKeys = std::vector<std::string>;

/// Finds recordings that are an earlier one under another name: sets ComparedRecording::same_as and
/// warns, once. They are, if in every arm that has both
/// - their sources have equal keys, which is known before anything runs, or gave equal values; or
/// - they left the very same files, one of them more than measures, and the same figures, such as
///   recordings that differ in a seed which nobody reads.
/// Ten names of one pit are not ten pits, and seven equal differences would make a sure verdict.
void note_equal_recordings(Comparison& comparison, const SourceKeys& sources);

}  // namespace stope
