// Problem: divide free space into rooms where it is narrow, and again after a change.
// Idea: cells are looked at for two things only, each of which a change alters in places: in which
// basin of the clearance they are, and where basins touch in a tile. What rooms are made of basins
// is decided on some thousand basins, anew every time; measures and roads of rooms that are as they
// were are remembered. Cells' labels are shared with the maps before.
// Cost: some looks at every cell, side by side; after a change, at the cells that see it and at the
// tiles around them.
#include "plugins/topology/regions/room_divider.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "plugins/topology/regions/borders.hpp"
#include "plugins/topology/regions/shared_names.hpp"
#include "plugins/topology/regions/write_labels.hpp"

namespace stope::topology {

struct RoomDivider::State {
  State(const OccupancyGrid& grid, const ExtractionParams& extraction, bool keep,
        const Checkpoint& checkpoint)
      : ground(grid, extraction, checkpoint),
        basins(ground, keep, checkpoint),
        tiles(ground.width(), ground.height()) {
    tiles.look_at(ground, basins.cells(), all_tiles(ground), checkpoint);
    contacts = all_contacts(tiles);
    std::sort(contacts.begin(), contacts.end(), is_clearer);
  }

  bool update(const OccupancyGrid& grid, const CellWindow& window, ChangedSquares& changed,
              const Checkpoint& checkpoint) {
    GroundChange change(ground.width(), ground.height());
    if (!ground.update(grid, window, change, checkpoint)) return false;
    changed = change.squares;
    basins.update(ground, change.squares, changed);
    names->update(basins.cells(), changed, checkpoint);
    const std::vector<std::int32_t> near = tiles_that_see(changed);
    tiles.look_at(ground, basins.cells(), near, checkpoint);
    TileSet looked_at(ground.width(), ground.height());
    for (const std::int32_t tile : near) looked_at.add(tile);
    // A contact is in the tile of the earlier of its cells.
    std::erase_if(contacts, [&](const Contact& contact) {
      return looked_at.has(looked_at.tile_of(std::min(contact.low, contact.high)));
    });
    std::vector<Contact> now, all;
    for (const std::int32_t tile : near) {
      const auto& those = tiles.contacts(static_cast<std::size_t>(tile));
      now.insert(now.end(), those.begin(), those.end());
    }
    std::sort(now.begin(), now.end(), is_clearer);
    all.reserve(contacts.size() + now.size());
    std::merge(contacts.begin(), contacts.end(), now.begin(), now.end(), std::back_inserter(all),
               is_clearer);
    contacts = std::move(all);
    return true;
  }

  Ground ground;
  Basins basins;
  TileParts tiles;
  std::vector<Contact> contacts;  ///< the clearest first
  RegionMemo memo;
  std::optional<SharedNames> names;  ///< of those that are to be updated
};

void RoomDivider::label(const State& state, RegionsAndRoads& result) {
  result.map.labels.frame = state.ground.frame();
  result.map.labels.cells = state.names->labelled(std::move(result.label_of_name));
}

RoomDivider::RoomDivider(const ExtractionParams& extraction, const Rule& rule,
                         const RegionRoadsRule& roads)
    : extraction_(extraction), rule_(rule), roads_(roads) {
  // A piece of road between two doors is as wide as the road, so its clearest place is the middle.
  roads_.centre_share = 0.8;
  roads_.every_door = true;
}
RoomDivider::~RoomDivider() = default;
RoomDivider::RoomDivider(RoomDivider&&) noexcept = default;
RoomDivider& RoomDivider::operator=(RoomDivider&&) noexcept = default;

void RoomDivider::forget() { state_.reset(); }

std::size_t RoomDivider::reused() const { return state_ ? state_->memo.reused : 0; }

RegionsAndRoads RoomDivider::full(const OccupancyGrid& grid, bool keep,
                                  const Checkpoint& checkpoint) {
  forget();
  auto state = std::make_unique<State>(grid, extraction_, keep, checkpoint);
  RegionsAndRoads result = finish(*state, nullptr, checkpoint);
  if (keep) {
    state->names.emplace(state->basins.cells(), checkpoint);
    label(*state, result);
    state_ = std::move(state);
  } else {  // a large map's labels take the place of what is not needed any more
    const PaddedGrid<std::int32_t> names = std::move(state->basins).take_cells();
    state.reset();
    write_labels(grid.frame, names, result.label_of_name, result.map.labels, checkpoint);
  }
  return result;
}

RegionsAndRoads RoomDivider::update(const OccupancyGrid& grid, const CellWindow& window,
                                    const Checkpoint& checkpoint) {
  // Whoever stops half way must not leave half a state.
  std::unique_ptr<State> state = std::move(state_);
  if (!state) return full(grid, true, checkpoint);
  ChangedSquares changed(state->ground.width(), state->ground.height());
  if (!state->update(grid, window, changed, checkpoint)) return full(grid, true, checkpoint);
  RegionsAndRoads result = finish(*state, &changed, checkpoint);
  label(*state, result);
  state_ = std::move(state);
  return result;
}

RegionsAndRoads RoomDivider::finish(State& state, const ChangedSquares* changed,
                                    const Checkpoint& checkpoint) const {
  const double resolution = state.ground.frame().resolution;
  const double least_area = rule_.min_region_area / (resolution * resolution);
  const RegionSet rooms = join_at_doors(state.ground, state.basins, state.tiles, state.contacts,
                                        {rule_.door_ratio, rule_.similar_ratio, rule_.hub_ratio,
                                         least_area, roads_.least_squared(resolution)},
                                        checkpoint);
  return finish_regions(state.ground, state.basins.cells(), state.tiles, state.contacts, rooms,
                        least_area, roads_, checkpoint, &state.memo, changed);
}

}  // namespace stope::topology
