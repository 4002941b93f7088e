#pragma once

#include <cstdint>

namespace stope::source {

/// What a synthetic pit looks like and how it is driven and scanned. Metres, radians, seconds.
struct PitParameters {
  // The mine.
  double size = 600.0;          ///< side of the square map
  std::int64_t benches = 3;     ///< steps from the surface to the pit floor
  double bench_height = 10.0;   ///< of one step
  double road_width = 15.0;     ///< between the feet of the berms
  double grade = 0.09;          ///< steepest slope of a ramp, rise over run
  std::int64_t dead_ends = 8;   ///< loading faces, dumps and yards aimed at
  std::int64_t connectors = 2;  ///< extra roads aimed at that close loops
  double rough = 0.6;           ///< amplitude of freshly dug faces
  double objects = 1.5;         ///< parked machines for each dead end, on average
  double resolution = 0.5;      ///< of the height field and of the truth grids
  // The drive.
  double truck_speed = 9.0;   ///< on straight roads
  double route_length = 0.0;  ///< stop after this distance; 0: drive the whole network
  std::int64_t scans = 0;     ///< stop after this many scans; 0: as many as the route gives
  std::int64_t stride = 15;   ///< keep one sweep of this many
  // The sensor.
  std::int64_t rings = 16;      ///< 16, 32 or 64 lasers
  std::int64_t azimuths = 900;  ///< firings a turn
  double scan_rate = 10.0;      ///< turns a second
  double range_noise = 0.02;    ///< standard deviation
  double dropout = 0.02;        ///< share of the returns that are lost
  double max_range = 100.0;
  double sensor_height = 3.6;  ///< over the road
};

}  // namespace stope::source
