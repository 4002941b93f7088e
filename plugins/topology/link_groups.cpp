// Problem: lines of one piece of free space lie in groups; join these as a driver would.
// Idea: from each group, small ones first, a search through free cells takes those with the most
// room first and ends at the first corner of another group.
// Cost: see the header.
#include "plugins/topology/link_groups.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <queue>
#include <tuple>
#include <unordered_map>

#include "plugins/topology/disjoint_sets.hpp"

namespace stope::topology {
namespace {

class GroupLinker {
 public:
  GroupLinker(const FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges,
              std::vector<LineGroup> groups, const Checkpoint& checkpoint)
      : space_(space),
        outlines_(outlines),
        edges_(edges),
        checkpoint_(checkpoint),
        stride_(space.stride()),
        groups_(std::move(groups)),
        joined_(groups_.size()) {
    for (std::size_t i = 0; i < groups_.size(); ++i)
      std::erase_if(groups_[i].corners, [&](CellIndex corner) {
        return !group_of_.emplace(corner, static_cast<std::int32_t>(i)).second;
      });
  }

  std::vector<Link> run() {
    // Small groups look for large ones: their searches are short.
    std::vector<std::size_t> order(groups_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return groups_[a].corners.size() < groups_[b].corners.size();
    });
    std::vector<Link> links;
    for (const std::size_t start : order) {
      const std::int32_t own = joined_.find(static_cast<std::int32_t>(start));
      const bool apart = std::any_of(order.begin(), order.end(), [&](std::size_t other) {
        return groups_[other].piece == groups_[start].piece &&
               joined_.find(static_cast<std::int32_t>(other)) != own;
      });
      if (!apart) continue;
      checkpoint_();
      links.push_back(widest_way(own));
      joined_.join(own, group_of_.at(links.back().to));
    }
    return links;
  }

 private:
  struct Entry {
    std::int64_t room;
    std::int32_t steps;
    CellIndex cell, from;
    bool operator<(const Entry& other) const {
      return std::tuple(-room, steps, cell, from) >
             std::tuple(-other.room, other.steps, other.cell, other.from);
    }
  };

  bool free(CellIndex cell) const { return !(space_[cell] & kObstacle); }
  std::int64_t distance(CellIndex cell) const {
    return squared_distance(edges_, outlines_, cell, edges_[cell]);
  }
  std::array<CellIndex, 4> cells_at(CellIndex corner) const {
    return {corner, corner + 1, corner + stride_, corner + stride_ + 1};
  }

  /// From any corner of one group to any of another, through the cells with the most room.
  Link widest_way(std::int32_t own) {
    std::priority_queue<Entry> open;
    std::unordered_map<CellIndex, CellIndex> came_from, corner_of;
    for (std::size_t group = 0; group < groups_.size(); ++group) {
      if (joined_.find(static_cast<std::int32_t>(group)) != own) continue;
      for (const CellIndex corner : groups_[group].corners) {
        for (const CellIndex cell : cells_at(corner)) {
          if (!free(cell)) continue;
          if (corner_of.emplace(cell, corner).second) open.push({distance(cell), 0, cell, -1});
        }
      }
    }
    while (!open.empty()) {
      const Entry entry = open.top();
      open.pop();
      if (!came_from.emplace(entry.cell, entry.from).second) continue;
      for (const CellIndex corner :
           {entry.cell, entry.cell - 1, entry.cell - stride_, entry.cell - stride_ - 1}) {
        const auto group = group_of_.find(corner);
        if (group == group_of_.end() || joined_.find(group->second) == own) continue;
        Link link;
        link.to = corner;
        for (CellIndex cell = entry.cell; cell >= 0; cell = came_from.at(cell))
          link.cells.push_back(cell);
        std::reverse(link.cells.begin(), link.cells.end());
        link.from = corner_of.at(link.cells.front());
        return link;
      }
      for (const CellIndex row : {-stride_, 0, stride_}) {
        for (const CellIndex next :
             {entry.cell + row - 1, entry.cell + row, entry.cell + row + 1}) {
          if (!free(next) || came_from.contains(next)) continue;
          open.push({std::min(entry.room, distance(next)), entry.steps + 1, next, entry.cell});
        }
      }
    }
    return {};
  }

  const FreeSpace& space_;
  const Outlines& outlines_;
  const EdgeGrid& edges_;
  const Checkpoint& checkpoint_;
  CellIndex stride_;
  std::vector<LineGroup> groups_;
  DisjointSets joined_;
  std::unordered_map<CellIndex, std::int32_t> group_of_;
};

}  // namespace

std::vector<Link> link_groups(const FreeSpace& space, const Outlines& outlines,
                              const EdgeGrid& edges, std::vector<LineGroup> groups,
                              const Checkpoint& checkpoint) {
  return GroupLinker(space, outlines, edges, std::move(groups), checkpoint).run();
}

}  // namespace stope::topology
