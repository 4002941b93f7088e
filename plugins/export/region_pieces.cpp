#include "plugins/export/region_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

#include "stope/error.hpp"

namespace stope::exports {
namespace {

using Contacts = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

void compact(Contacts& contacts) {
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
}

class Pieces {
 public:
  explicit Pieces(const RegionMap& map)
      : labels_(map.labels.cells.read(0, map.labels.cells.size(), room_)),
        frame_(map.labels.frame) {
    pieces_.of_cell.assign(labels_.size(), -1);
    pieces_.cells.assign(map.regions.size(), 0);
  }

  RegionPieces find() {
    for (std::int32_t row = frame_.height - 1; row >= 0; --row) {
      for (std::int32_t column = 0; column < frame_.width; ++column) {
        const std::size_t place = frame_.place({column, row});
        const std::int32_t label = labels_[place];
        if (label == 0) continue;
        if (label < 0 || static_cast<std::size_t>(label) > pieces_.cells.size()) {
          throw Error(fmt::format(
              "the cell ({}, {}) of the region map has the label {}, but there are {} regions",
              column, row, label, pieces_.cells.size()));
        }
        if (pieces_.of_cell[place] < 0) flood({column, row}, label);
      }
    }
    find_contacts();
    return std::move(pieces_);
  }

 private:
  void flood(Cell start, std::int32_t label) {
    const auto piece = static_cast<std::int32_t>(pieces_.region.size());
    const auto region = static_cast<std::uint32_t>(label - 1);
    pieces_.region.push_back(region);
    pieces_.of_cell[frame_.place(start)] = piece;
    open_.push_back(start);
    while (!open_.empty()) {
      const Cell at = open_.back();
      open_.pop_back();
      ++pieces_.cells[region];
      for (std::int32_t dy = -1; dy <= 1; ++dy) {
        for (std::int32_t dx = -1; dx <= 1; ++dx) {
          const Cell next{at.column + dx, at.row + dy};
          if (!frame_.contains(next)) continue;
          const std::size_t place = frame_.place(next);
          if (labels_[place] != label || pieces_.of_cell[place] >= 0) continue;
          pieces_.of_cell[place] = piece;
          open_.push_back(next);
        }
      }
    }
  }

  void find_contacts() {
    Contacts& contacts = pieces_.contacts;
    std::size_t full = 1U << 20U;
    for (std::int32_t row = 0; row < frame_.height; ++row) {
      for (std::int32_t column = 0; column < frame_.width; ++column) {
        const std::int32_t own = pieces_.of_cell[frame_.place({column, row})];
        if (own < 0) continue;
        for (const Cell next : {Cell{column + 1, row}, Cell{column - 1, row + 1},
                                Cell{column, row + 1}, Cell{column + 1, row + 1}}) {
          if (!frame_.contains(next)) continue;
          const std::int32_t other = pieces_.of_cell[frame_.place(next)];
          if (other < 0 || other == own) continue;
          contacts.emplace_back(std::min(own, other), std::max(own, other));
        }
      }
      // Long borders repeat their pair: keep memory near that of the distinct ones.
      if (contacts.size() > full) {
        compact(contacts);
        full = std::max(full, 2 * contacts.size());
      }
    }
    compact(contacts);
  }

  std::vector<std::int32_t> room_;  ///< for labels that are shared
  std::span<const std::int32_t> labels_;
  const GridFrame& frame_;
  RegionPieces pieces_;
  std::vector<Cell> open_;
};

}  // namespace

RegionPieces region_pieces(const RegionMap& map) { return Pieces(map).find(); }

}  // namespace stope::exports
