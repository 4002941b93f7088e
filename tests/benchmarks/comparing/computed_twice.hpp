#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace stope::benchmark {

/// Seconds that each stage of a comparison worked, by its key. Of a map, what its items took; of
/// any other stage its life without waiting for inputs and outputs, which on a full machine is more
/// than it computed.
std::map<std::string, double> stage_seconds(const std::filesystem::path& comparison);

/// Names of the recording that a comparison was at when it was killed; empty if all were done.
std::string unfinished_recording(const std::filesystem::path& comparison);

/// Seconds that can have been computed twice at most, after a comparison that was killed has been
/// gone on with: of all stages that ran afterwards, those whose inputs were there before (`stored`
/// at that time, or streams of such stages), each as though it had been about to end.
double most_computed_twice(const std::filesystem::path& comparison, const std::string& recording,
                           const std::set<std::string>& stored,
                           const std::map<std::string, double>& seconds);

/// How many stages ran after `since` though all that was asked of them had been stored.
std::size_t ran_again(const std::filesystem::path& comparison, const std::set<std::string>& stored,
                      std::filesystem::file_time_type since);

}  // namespace stope::benchmark
