#include "plugins/topology/connect_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <tuple>
#include <unordered_map>

#include "plugins/topology/disjoint_sets.hpp"

namespace stope::topology {
namespace {

class PieceConnector {
 public:
  PieceConnector(FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges,
                 const std::vector<CellIndex>& corners, const Checkpoint& checkpoint)
      : space_(space),
        outlines_(outlines),
        edges_(edges),
        corners_(corners),
        checkpoint_(checkpoint),
        stride_(space.stride()),
        pieces_(outlines.list.size()) {}

  LineNetwork run() {
    join_outlines();
    checkpoint_();
    TracedLines traced = trace_lines(space_, outlines_, edges_, corners_, {});
    checkpoint_();
    const std::vector<std::int32_t> torn = torn_pieces(traced);
    if (!torn.empty()) drop_fragments(traced);
    // A new trace brings fragments back, so they are linked as well.
    if (!torn_pieces(traced).empty())
      traced = trace_lines(space_, outlines_, edges_, corners_, links_within(torn));
    checkpoint_();
    add_lone_nodes(traced);
    return std::move(traced.network);
  }

 private:
  struct Group {
    std::int32_t piece = 0;
    std::vector<CellIndex> corners;
  };

  bool free(CellIndex cell) const { return !(space_[cell] & kObstacle); }
  std::int32_t outline_at(CellIndex cell) const {
    return outlines_.of_edge[static_cast<std::size_t>(edges_[cell])];
  }
  std::int64_t distance(CellIndex cell) const {
    return squared_distance(edges_, outlines_, cell, edges_[cell]);
  }

  template <class Visit>
  void for_each_step(CellIndex corner, Visit visit) const {
    if (space_[corner] & kDividedEast) visit(Divide{corner, false});
    if (space_[corner] & kDividedNorth) visit(Divide{corner, true});
  }

  /// Outlines on both sides of a line bound the same piece of free space.
  void join_outlines() {
    for (const CellIndex corner : corners_) {
      for_each_step(corner, [&](Divide step) {
        const CellIndex a = step.cell, b = a + (step.north ? stride_ : 1);
        pieces_.join(outline_facing(a, b), outline_facing(b, a));
      });
    }
  }
  std::int32_t outline_facing(CellIndex cell, CellIndex other) const {
    if (free(cell)) return outline_at(cell);
    const auto& sides = outlines_.sides[static_cast<std::size_t>(edges_[cell])];
    const CellIndex step = other - cell;
    const int side = step == 1 ? kEast : step == -1 ? kWest : step > 0 ? kNorth : kSouth;
    return outlines_.of_edge[static_cast<std::size_t>(sides[static_cast<std::size_t>(side)])];
  }

  /// Where sides are about as long as the bound, the raster lets lines flicker: bits of line
  /// shorter than it that end on both sides come to lie apart before a branch's tip. They are left
  /// out.
  void drop_fragments(TracedLines& traced) {
    LineNetwork& network = traced.network;
    DisjointSets connected(network.nodes.size());
    struct Size {
      std::size_t points = 0;
      bool cyclic = false;
    };
    std::vector<Size> size(network.nodes.size());
    for (const Line& line : network.lines)
      if (!connected.join(line.from, line.to))
        size[static_cast<std::size_t>(connected.find(line.from))].cyclic = true;
    std::vector<Size> total(network.nodes.size());
    for (std::size_t node = 0; node < size.size(); ++node)
      if (size[node].cyclic) total[group_at(connected, node)].cyclic = true;
    for (const Line& line : network.lines)
      total[group_at(connected, static_cast<std::size_t>(line.from))].points += line.points.size();
    std::vector<std::int32_t> largest(outlines_.list.size(), -1);
    for (std::size_t node = 0; node < total.size(); ++node) {
      if (group_at(connected, node) != node) continue;
      auto& best = largest[piece_of(traced.outline[node])];
      if (best < 0 || total[node].points > total[static_cast<std::size_t>(best)].points)
        best = static_cast<std::int32_t>(node);
    }
    const auto dropped = [&](std::size_t node) {
      const std::size_t group = group_at(connected, node);
      const bool keep = static_cast<std::size_t>(largest[piece_of(traced.outline[group])]) == group;
      return !keep && !total[group].cyclic &&
             total[group].points <= static_cast<std::size_t>(outlines_.gap);
    };
    std::vector<std::size_t> nodes;
    for (std::size_t node = 0; node < total.size(); ++node)
      if (dropped(node)) nodes.push_back(node);
    for (Line& line : network.lines)
      if (dropped(static_cast<std::size_t>(line.from))) line.points.clear();
    for (const std::size_t node : nodes) traced.outline[node] = -1;
  }
  static std::size_t group_at(DisjointSets& connected, std::size_t node) {
    return static_cast<std::size_t>(connected.find(static_cast<std::int32_t>(node)));
  }
  std::size_t piece_of(std::int32_t outline) {
    return static_cast<std::size_t>(pieces_.find(outline));
  }

  std::vector<std::int32_t> torn_pieces(const TracedLines& traced) {
    const LineNetwork& network = traced.network;
    DisjointSets connected(network.nodes.size());
    for (const Line& line : network.lines) connected.join(line.from, line.to);
    std::vector<std::int32_t> first(outlines_.list.size(), -1), torn;
    for (std::size_t node = 0; node < network.nodes.size(); ++node) {
      if (traced.outline[node] < 0) continue;
      const std::int32_t piece = pieces_.find(traced.outline[node]);
      const std::int32_t group = connected.find(static_cast<std::int32_t>(node));
      auto& known = first[static_cast<std::size_t>(piece)];
      if (known < 0) known = group;
      if (known != group) torn.push_back(piece);
    }
    std::sort(torn.begin(), torn.end());
    torn.erase(std::unique(torn.begin(), torn.end()), torn.end());
    return torn;
  }

  std::vector<Link> links_within(const std::vector<std::int32_t>& torn) {
    std::vector<Group> groups = find_groups(torn);
    // Small groups look for large ones: their searches are short.
    std::vector<std::size_t> order(groups.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return groups[a].corners.size() < groups[b].corners.size();
    });
    DisjointSets joined(groups.size());
    std::vector<Link> links;
    for (const std::size_t start : order) {
      const std::int32_t own = joined.find(static_cast<std::int32_t>(start));
      const bool apart = std::any_of(order.begin(), order.end(), [&](std::size_t other) {
        return groups[other].piece == groups[start].piece &&
               joined.find(static_cast<std::int32_t>(other)) != own;
      });
      if (!apart) continue;
      checkpoint_();
      links.push_back(widest_way(groups, joined, own));
      joined.join(own, group_of_.at(links.back().to));
    }
    return links;
  }

  std::vector<Group> find_groups(const std::vector<std::int32_t>& torn) {
    std::vector<Group> groups;
    for (const CellIndex start : corners_) {
      const std::int32_t piece = piece_at(start);
      if (piece < 0 || !std::binary_search(torn.begin(), torn.end(), piece)) continue;
      if (group_of_.contains(start)) continue;
      const auto name = static_cast<std::int32_t>(groups.size());
      Group group{piece, {start}};
      group_of_.emplace(start, name);
      for (std::size_t i = 0; i < group.corners.size(); ++i) {
        const CellIndex corner = group.corners[i];
        const auto reach = [&](bool divided, CellIndex next) {
          if (divided && group_of_.emplace(next, name).second) group.corners.push_back(next);
        };
        reach(space_[corner] & kDividedEast, corner - stride_);
        reach(space_[corner] & kDividedNorth, corner - 1);
        reach(space_[corner + stride_] & kDividedEast, corner + stride_);
        reach(space_[corner + 1] & kDividedNorth, corner + 1);
      }
      groups.push_back(std::move(group));
    }
    return groups;
  }

  std::array<CellIndex, 4> cells_at(CellIndex corner) const {
    return {corner, corner + 1, corner + stride_, corner + stride_ + 1};
  }
  /// The piece of free space a corner of a line lies in; -1 for a corner without lines.
  std::int32_t piece_at(CellIndex corner) {
    const bool passed = (space_[corner] & (kDividedEast | kDividedNorth)) ||
                        (space_[corner + stride_] & kDividedEast) ||
                        (space_[corner + 1] & kDividedNorth);
    if (!passed) return -1;
    for (const CellIndex cell : cells_at(corner))
      if (free(cell)) return pieces_.find(outline_at(cell));
    return -1;
  }

  /// From any corner of one group to any of another, through the cells with the most room.
  Link widest_way(const std::vector<Group>& groups, DisjointSets& joined, std::int32_t own) {
    struct Entry {
      std::int64_t room;
      std::int32_t steps;
      CellIndex cell, from;
      bool operator<(const Entry& other) const {
        return std::tuple(-room, steps, cell, from) >
               std::tuple(-other.room, other.steps, other.cell, other.from);
      }
    };
    std::priority_queue<Entry> open;
    std::unordered_map<CellIndex, CellIndex> came_from, corner_of;
    for (std::size_t group = 0; group < groups.size(); ++group) {
      if (joined.find(static_cast<std::int32_t>(group)) != own) continue;
      for (const CellIndex corner : groups[group].corners) {
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
        if (group == group_of_.end() || joined.find(group->second) == own) continue;
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

  void add_lone_nodes(TracedLines& traced) {
    std::vector<bool> seen(outlines_.list.size(), false);
    for (const std::int32_t outline : traced.outline)
      if (outline >= 0) seen[static_cast<std::size_t>(pieces_.find(outline))] = true;
    for (std::size_t outline = 0; outline < outlines_.list.size(); ++outline) {
      if (seen[static_cast<std::size_t>(pieces_.find(static_cast<std::int32_t>(outline)))])
        continue;
      const CellIndex cell = widest_place(static_cast<std::int32_t>(outline));
      traced.network.nodes.push_back({{edges_.column(cell) + 0.5, edges_.row(cell) + 0.5,
                                       std::sqrt(static_cast<double>(distance(cell)))},
                                      true});
    }
  }

  CellIndex widest_place(std::int32_t outline) const {
    const Outline& box = outlines_.list[static_cast<std::size_t>(outline)];
    CellIndex best = -1;
    std::int64_t room = -1;
    for (std::int32_t row = std::max(box.bottom, 0); row <= std::min(box.top, space_.height() - 1);
         ++row) {
      for (std::int32_t column = std::max(box.left, 0);
           column <= std::min(box.right, space_.width() - 1); ++column) {
        const CellIndex cell = space_.index(column, row);
        if (!free(cell) || outline_at(cell) != outline || distance(cell) <= room) continue;
        best = cell;
        room = distance(cell);
      }
    }
    return best;
  }

  FreeSpace& space_;
  const Outlines& outlines_;
  const EdgeGrid& edges_;
  const std::vector<CellIndex>& corners_;
  const Checkpoint& checkpoint_;
  CellIndex stride_;
  DisjointSets pieces_;
  std::unordered_map<CellIndex, std::int32_t> group_of_;
};

}  // namespace

LineNetwork connect_pieces(FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges,
                           const std::vector<CellIndex>& corners, const Checkpoint& checkpoint) {
  return PieceConnector(space, outlines, edges, corners, checkpoint).run();
}

}  // namespace stope::topology
