#include "tests/benchmarks/regions/room_maps.hpp"

#include <png.h>

#include <algorithm>

namespace stope::benchmarks {
namespace {

struct Picture {
  std::int32_t width = 0, height = 0;
  std::vector<std::uint8_t> grey;
};

Picture read_picture(const std::filesystem::path& file, bool only_size) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&image, file.c_str())) return {};
  Picture picture{
      static_cast<std::int32_t>(image.width), static_cast<std::int32_t>(image.height), {}};
  image.format = PNG_FORMAT_GRAY;
  if (only_size) {
    png_image_free(&image);
    return picture;
  }
  picture.grey.resize(PNG_IMAGE_SIZE(image));
  const png_color black{};
  png_image_finish_read(&image, &black, picture.grey.data(), 0, nullptr);
  return picture;
}

}  // namespace

std::vector<RoomMap> room_maps(const std::filesystem::path& folder) {
  std::vector<RoomMap> maps;
  if (!std::filesystem::is_directory(folder)) return maps;
  constexpr std::string_view kTruth = "_gt_segmentation";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string stem = entry.path().stem().string();
    if (stem.size() < kTruth.size() || !stem.ends_with(kTruth)) continue;
    const std::string base = stem.substr(0, stem.size() - kTruth.size());
    const Picture truth = read_picture(entry.path(), true);
    for (const char* kind : {"", "_furnitures", "_trashbins", "_furnitures_trashbins"}) {
      const auto picture = folder / (base + kind + ".png");
      if (!std::filesystem::exists(picture)) continue;
      const Picture found = read_picture(picture, true);
      if (found.width != truth.width || found.height != truth.height) continue;
      maps.push_back({base + kind, picture, entry.path()});
    }
  }
  std::sort(maps.begin(), maps.end(),
            [](const RoomMap& a, const RoomMap& b) { return a.name < b.name; });
  return maps;
}

OccupancyGrid read_rooms(const std::filesystem::path& file, double resolution) {
  const Picture picture = read_picture(file, false);
  OccupancyGrid grid;
  grid.frame.width = picture.width;
  grid.frame.height = picture.height;
  grid.frame.resolution = resolution;
  const auto width = static_cast<std::size_t>(picture.width);
  for (auto row = static_cast<std::size_t>(picture.height); row-- > 0;)
    for (std::size_t column = 0; column < width; ++column)
      grid.cells.push_back(picture.grey[row * width + column] >= 250 ? OccupancyGrid::kFree
                                                                     : OccupancyGrid::kOccupied);
  return grid;
}

OccupancyGrid coarser(const OccupancyGrid& grid, std::int32_t factor) {
  OccupancyGrid result;
  result.frame = grid.frame;
  result.frame.width = grid.frame.width / factor;
  result.frame.height = grid.frame.height / factor;
  result.frame.resolution = grid.frame.resolution * factor;
  for (std::int32_t row = 0; row < result.frame.height; ++row) {
    for (std::int32_t column = 0; column < result.frame.width; ++column) {
      std::int32_t free = 0;
      for (std::int32_t y = 0; y < factor; ++y)
        for (std::int32_t x = 0; x < factor; ++x)
          free += grid.cells[grid.frame.place({column * factor + x, row * factor + y})] ==
                          OccupancyGrid::kFree
                      ? 1
                      : 0;
      result.cells.push_back(2 * free >= factor * factor ? OccupancyGrid::kFree
                                                         : OccupancyGrid::kOccupied);
    }
  }
  return result;
}

void write_picture(const RegionMap& map, const std::filesystem::path& file) {
  const GridFrame& frame = map.labels.frame;
  std::vector<std::uint8_t> pixels;
  for (std::int32_t row = frame.height; row-- > 0;) {
    for (std::int32_t column = 0; column < frame.width; ++column) {
      const auto label = static_cast<std::uint32_t>(map.labels.cells[frame.place({column, row})]);
      for (const std::uint32_t mix : {2654435761U, 2246822519U, 3266489917U})
        pixels.push_back(label == 0 ? 0
                                    : static_cast<std::uint8_t>(70 + (label * mix >> 24) % 180));
    }
  }
  for (const Region& region : map.regions) {
    const auto cell = frame.cell_at(region.x, region.y);
    if (!cell) continue;
    const auto place = static_cast<std::size_t>(frame.height - 1 - cell->row) *
                           static_cast<std::size_t>(frame.width) +
                       static_cast<std::size_t>(cell->column);
    pixels[3 * place] = pixels[3 * place + 1] = pixels[3 * place + 2] = 255;
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(frame.width);
  image.height = static_cast<png_uint_32>(frame.height);
  image.format = PNG_FORMAT_RGB;
  png_image_write_to_file(&image, file.c_str(), 0, pixels.data(), 0, nullptr);
}

}  // namespace stope::benchmarks
