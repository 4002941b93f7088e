#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace stope::metric {

/// Rooms of a picture: its white parts, numbered from 1.
struct LabelledRooms {
  std::int32_t width = 0, height = 0;
  std::vector<std::int32_t> cells;  ///< row-major, row 0 lowest; 0 is no room
  std::int32_t rooms = 0;
};

/// Reads a picture (PNG) in which each 4-connected part of pixels of at least `white` (of 255;
/// what is transparent is black) is a room, unless it has fewer than `least` pixels. Throws Error.
LabelledRooms read_labelled_rooms(const std::filesystem::path& file, int white, std::size_t least);

/// The same for a picture in memory, its lowest row first.
LabelledRooms label_rooms(std::int32_t width, std::int32_t height,
                          const std::vector<std::uint8_t>& grey, int white, std::size_t least);

}  // namespace stope::metric
