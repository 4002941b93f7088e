#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <vector>

#include "plugins/metric/labelled_rooms.hpp"
#include "plugins/metric/measure_list.hpp"
#include "plugins/metric/region_scores.hpp"
#include "stope/stope.hpp"

namespace stope::metric {

class RegionSegmentation final : public Map<Measures(RegionMap, Optional<RegionMap>)> {
 public:
  struct Params {
    std::optional<std::filesystem::path> picture;
    int white = 250;
    double min_room_area = 1.0;
  } params;

  static void describe(About<RegionSegmentation>& about) {
    about.summary("Regions against labelled rooms: recall, precision and Matthews correlation.")
        .from(
            "recall and precision as Bormann et al. 2016; Matthews correlation as proposed by "
            "Mielle et al. 2018 (MAORIS)")
        .notes(
            "The truth is a picture whose white parts are rooms, or a region map at `truth`. Only "
            "cells in a true room are counted: what the picture draws as a wall or a door line is "
            "left out. docs/regions.md states the protocol.")
        .ports("regions", "truth", "measures")
        .param("picture", &Params::picture, existing(PathKind::kFile),
               "PNG with the true rooms in white, of the map's size, its first row the highest.")
        .param("white", &Params::white, between(1, 255), "Least grey value of a room's pixel.")
        .param("min_room_area", &Params::min_room_area, "m^2", at_least(0.0),
               "White parts of the picture smaller than this are specks, not rooms.");
  }

  Measures apply(const RegionMap& regions, const Optional<RegionMap>& truth, Context&) const {
    const GridFrame& frame = regions.labels.frame;
    if (regions.labels.cells.size() != frame.size())
      throw Error(
          fmt::format("the region map says {} x {} cells but holds {}; its source is at "
                      "fault",
                      frame.width, frame.height, regions.labels.cells.size()));
    if (static_cast<bool>(truth) == params.picture.has_value())
      throw Error("give the true rooms either as the parameter `picture` or at the input `truth`");
    std::vector<std::int32_t> room, true_room;
    const auto labels = regions.labels.cells.read(0, frame.size(), room);
    RegionScores scores;
    std::string against = "a region map";
    if (truth) {
      check_frame(truth->labels.frame.width, truth->labels.frame.height, frame);
      scores =
          score_regions(truth->labels.cells.read(0, truth->labels.cells.size(), true_room), labels);
    } else {
      const auto least = static_cast<std::size_t>(std::clamp(
          std::ceil(params.min_room_area / (frame.resolution * frame.resolution)), 1.0, 1e18));
      const LabelledRooms rooms = read_labelled_rooms(*params.picture, params.white, least);
      check_frame(rooms.width, rooms.height, frame);
      against = fmt::format("{}, rooms of at least {} m^2", params.picture->filename().string(),
                            params.min_room_area);
      scores = score_regions(rooms.cells, labels);
    }
    return MeasureList(
               fmt::format("against {}: {} rooms, {} regions, {} cells in rooms; recall is the "
                           "mean over rooms of the share in the best region, precision the mean "
                           "over regions of the share in the best room, mcc pools the cells of all "
                           "rooms against their best regions",
                           against, scores.rooms, scores.regions, scores.cells))
        .add("region_recall", scores.recall)
        .add("region_precision", scores.precision)
        .add("region_mcc", scores.mcc)
        .add("region_mcc_mean", scores.mcc_mean)
        .add("region_mcc_pairs", scores.mcc_pairs)
        .add("region_count", static_cast<double>(scores.regions))
        .add("room_count", static_cast<double>(scores.rooms))
        .take();
  }

 private:
  static void check_frame(std::int32_t width, std::int32_t height, const GridFrame& frame) {
    if (width == frame.width && height == frame.height) return;
    throw Error(fmt::format(
        "the true rooms are {} x {} cells but the regions {} x {}; both must be of the same map at "
        "the same resolution",
        width, height, frame.width, frame.height));
  }
};

STOPE_STAGE(RegionSegmentation, "metric/region_segmentation")

}  // namespace stope::metric
