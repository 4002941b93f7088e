#include "plugins/metric/labelled_rooms.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cstring>

#include "stope/error.hpp"

namespace stope::metric {

LabelledRooms label_rooms(std::int32_t width, std::int32_t height,
                          const std::vector<std::uint8_t>& grey, int white, std::size_t least) {
  LabelledRooms result{width, height, std::vector<std::int32_t>(grey.size(), 0), 0};
  const auto columns = static_cast<std::size_t>(width);
  std::vector<std::size_t> room;
  std::vector<bool> seen(grey.size(), false);
  for (std::size_t start = 0; start < grey.size(); ++start) {
    if (seen[start] || grey[start] < white) continue;
    room.assign(1, start);
    seen[start] = true;
    for (std::size_t next = 0; next < room.size(); ++next) {
      const std::size_t cell = room[next], column = cell % columns;
      const auto visit = [&](std::size_t other) {
        if (seen[other] || grey[other] < white) return;
        seen[other] = true;
        room.push_back(other);
      };
      if (column > 0) visit(cell - 1);
      if (column + 1 < columns) visit(cell + 1);
      if (cell >= columns) visit(cell - columns);
      if (cell + columns < grey.size()) visit(cell + columns);
    }
    if (room.size() < least) continue;
    ++result.rooms;
    for (const std::size_t cell : room) result.cells[cell] = result.rooms;
  }
  return result;
}

LabelledRooms read_labelled_rooms(const std::filesystem::path& file, int white, std::size_t least) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const auto broken = [&]() -> Error {
    const std::string reason = image.message;
    png_image_free(&image);
    return Error(fmt::format(
        "the picture of the true rooms {} cannot be read as a PNG ({}); check the path, and copy "
        "the file again if it is damaged",
        file.string(), reason));
  };
  if (!png_image_begin_read_from_file(&image, file.c_str())) throw broken();
  constexpr std::size_t kMostPixels = std::size_t{1} << 30;
  if (static_cast<std::size_t>(image.width) * image.height > kMostPixels) {
    png_image_free(&image);
    throw Error(
        fmt::format("the picture of the true rooms {} says it has {} x {} pixels, more "
                    "than the 2^30 that can be measured against",
                    file.string(), image.width, image.height));
  }
  image.format = PNG_FORMAT_GRAY;
  std::vector<std::uint8_t> top_first(PNG_IMAGE_SIZE(image));
  const png_color black{};
  if (!png_image_finish_read(&image, &black, top_first.data(), 0, nullptr)) throw broken();
  std::vector<std::uint8_t> grey(top_first.size());
  for (std::size_t row = 0; row < image.height; ++row)
    std::copy_n(top_first.data() + (image.height - 1 - row) * image.width, image.width,
                grey.data() + row * image.width);
  return label_rooms(static_cast<std::int32_t>(image.width),
                     static_cast<std::int32_t>(image.height), grey, white, least);
}

}  // namespace stope::metric
