#include "plugins/topology/connect_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "plugins/topology/disjoint_sets.hpp"
#include "plugins/topology/link_groups.hpp"

namespace stope::topology {
namespace {

class PieceConnector {
 public:
  PieceConnector(FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges,
                 std::vector<const TracedLine*> lines, const LineEnds& ends, Courses& courses,
                 double least_apart, const Checkpoint& checkpoint)
      : space_(space),
        outlines_(outlines),
        edges_(edges),
        lines_(std::move(lines)),
        ends_(ends),
        courses_(courses),
        least_apart_(least_apart),
        checkpoint_(checkpoint),
        pieces_(outlines.list.size()) {}

  ConnectedLines run() {
    // Outlines on both sides of a line bound the same piece of free space.
    for (const TracedLine* line : lines_)
      pieces_.join(outline_of(line->sides[0]), outline_of(line->sides[1]));
    Groups groups(ends_);
    for (std::size_t i = 0; i < lines_.size(); ++i) groups.add(i, *lines_[i], piece_of(*lines_[i]));
    const std::vector<std::int32_t> torn = torn_pieces(groups);
    if (!torn.empty()) leave_out_fragments(groups);
    ConnectedLines connected{LineNetwork(courses_), {}};
    if (torn.empty() || torn_pieces(groups).empty()) {
      std::vector<const TracedLine*> kept;
      for (std::size_t i = 0; i < lines_.size(); ++i) {
        if (!groups.left_out[groups.of_line(i)]) {
          kept.push_back(lines_[i]);
        } else {
          groups.ends.of_line[i].first = kLeftOut;
        }
      }
      std::erase_if(groups.ends.of_line, [](const auto& ends) { return ends.first == kLeftOut; });
      connected = {to_network(kept, groups.ends, courses_), narrow_stretches(kept)};
    } else {
      // A new trace brings fragments back, so they are linked as well.
      connected = linked_within(torn);
    }
    checkpoint_();
    add_lone_nodes(connected.network);
    return connected;
  }

 private:
  static constexpr std::int32_t kLeftOut = -1;
  /// Which lines hang together. A group is named by its first node.
  struct Groups {
    explicit Groups(const LineEnds& ends_of_lines)
        : ends(ends_of_lines),
          connected(ends.corner.size()),
          piece(ends.corner.size(), -1),
          points(ends.corner.size(), 0),
          cyclic(ends.corner.size(), false),
          left_out(ends.corner.size(), false) {
      std::vector<std::int32_t> loops;
      for (const auto& [from, to] : ends.of_line)
        if (!connected.join(from, to)) loops.push_back(from);
      for (const std::int32_t node : loops) cyclic[at(connected.find(node))] = true;
    }
    std::size_t of_line(std::size_t line) { return at(connected.find(ends.of_line[line].first)); }
    void add(std::size_t place, const TracedLine& line, std::int32_t piece_of_line) {
      const std::size_t group = of_line(place);
      piece[group] = piece_of_line;
      points[group] += line.corners.size() + 1;
    }
    LineEnds ends;
    DisjointSets connected;
    std::vector<std::int32_t> piece;  ///< by group, as what follows; -1: a node is not a group
    std::vector<std::size_t> points;
    std::vector<bool> cyclic, left_out;
  };

  static std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }
  bool free(CellIndex cell) const { return !(space_[cell] & kObstacle); }
  std::int32_t outline_of(OutlineEdge edge) const { return outlines_.of_edge[at(edge)]; }
  std::int64_t distance(CellIndex cell) const {
    return squared_distance(edges_, outlines_, cell, edges_[cell]);
  }
  std::int32_t piece_of(const TracedLine& line) { return pieces_.find(outline_of(line.sides[0])); }

  /// Where sides are about as long as the bound, the raster lets lines flicker: bits of line
  /// shorter than it that end on both sides come to lie apart before a branch's tip. They are left
  /// out.
  void leave_out_fragments(Groups& groups) const {
    std::vector<std::int32_t> largest(outlines_.list.size(), -1);
    for (std::size_t group = 0; group < groups.piece.size(); ++group) {
      if (groups.piece[group] < 0) continue;
      auto& best = largest[at(groups.piece[group])];
      if (best < 0 || groups.points[group] > groups.points[at(best)])
        best = static_cast<std::int32_t>(group);
    }
    for (std::size_t group = 0; group < groups.piece.size(); ++group)
      groups.left_out[group] = groups.piece[group] >= 0 &&
                               at(largest[at(groups.piece[group])]) != group &&
                               !groups.cyclic[group] && groups.points[group] <= at(outlines_.gap);
  }

  /// Those whose lines are of more than one group.
  std::vector<std::int32_t> torn_pieces(const Groups& groups) const {
    std::vector<std::int32_t> torn;
    std::vector<bool> seen(outlines_.list.size(), false);
    for (std::size_t group = 0; group < groups.piece.size(); ++group) {
      if (groups.piece[group] < 0 || groups.left_out[group]) continue;
      if (seen[at(groups.piece[group])]) torn.push_back(groups.piece[group]);
      seen[at(groups.piece[group])] = true;
    }
    std::sort(torn.begin(), torn.end());
    torn.erase(std::unique(torn.begin(), torn.end()), torn.end());
    return torn;
  }

  /// Lines that links end on are traced anew, with nodes there.
  ConnectedLines linked_within(const std::vector<std::int32_t>& torn) {
    const std::vector<Link> links =
        link_groups(space_, outlines_, edges_, find_groups(torn), checkpoint_);
    std::unordered_set<CellIndex> link_ends;
    for (const Link& link : links) link_ends.insert({link.from, link.to});
    LineTracer tracer(space_, outlines_, edges_, courses_, least_apart_);
    std::vector<CellIndex> corners;
    std::vector<const TracedLine*> whole;
    for (const TracedLine* line : lines_) {
      if (std::none_of(line->corners.begin(), line->corners.end(),
                       [&](CellIndex corner) { return link_ends.contains(corner); })) {
        whole.push_back(line);
        continue;
      }
      tracer.forget(*line);
      corners.insert(corners.end(), line->corners.begin(), line->corners.end());
    }
    checkpoint_();
    for (const CellIndex corner : link_ends) space_[corner] |= kEndsHere;
    std::vector<TracedLine> split = trace_lines(tracer, corners);
    for (std::size_t i = 0; i < links.size(); ++i)
      split.push_back(tracer.link(links[i], static_cast<std::int32_t>(i)));
    for (const CellIndex corner : link_ends)
      space_[corner] &= static_cast<std::uint8_t>(~kEndsHere);
    for (const TracedLine& line : split) whole.push_back(&line);
    std::sort(whole.begin(), whole.end(),
              [](const TracedLine* a, const TracedLine* b) { return comes_first(*a, *b); });
    return {to_network(whole, courses_), narrow_stretches(whole)};
  }

  std::vector<std::vector<StepRange>> narrow_stretches(
      const std::vector<const TracedLine*>& lines) const {
    std::vector<std::vector<StepRange>> narrow(lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto [a, b] = lines[i]->sides;
      if (a < 0 || outline_of(a) == outline_of(b)) narrow[i] = lines[i]->narrow;
    }
    return narrow;
  }

  /// What hangs together within torn pieces.
  std::vector<LineGroup> find_groups(const std::vector<std::int32_t>& torn) {
    Groups connected(ends_);
    std::vector<std::int32_t> name(connected.ends.corner.size(), -1);
    std::vector<LineGroup> groups;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const std::int32_t piece = piece_of(*lines_[i]);
      if (!std::binary_search(torn.begin(), torn.end(), piece)) continue;
      auto& own = name[connected.of_line(i)];
      if (own < 0) {
        own = static_cast<std::int32_t>(groups.size());
        groups.push_back({piece, {}});
      }
      auto& corners = groups[at(own)].corners;
      corners.insert(corners.end(), lines_[i]->corners.begin(), lines_[i]->corners.end());
    }
    return groups;
  }

  void add_lone_nodes(LineNetwork& network) {
    std::vector<bool> seen(outlines_.list.size(), false);
    for (const TracedLine* line : lines_) seen[at(piece_of(*line))] = true;
    for (std::size_t outline = 0; outline < outlines_.list.size(); ++outline) {
      if (outlines_.list[outline].count == 0 ||
          seen[at(pieces_.find(static_cast<std::int32_t>(outline)))])
        continue;
      const CellIndex cell = widest_place(static_cast<std::int32_t>(outline));
      network.nodes.push_back({{edges_.column(cell) + 0.5, edges_.row(cell) + 0.5,
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
        if (!free(cell) || outline_of(edges_[cell]) != outline || distance(cell) <= room) continue;
        best = cell;
        room = distance(cell);
      }
    }
    return best;
  }

  FreeSpace& space_;
  const Outlines& outlines_;
  const EdgeGrid& edges_;
  std::vector<const TracedLine*> lines_;
  const LineEnds& ends_;
  Courses& courses_;
  double least_apart_;
  const Checkpoint& checkpoint_;
  DisjointSets pieces_;
};

}  // namespace

ConnectedLines connect_pieces(FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges,
                              std::vector<const TracedLine*> lines, const LineEnds& ends,
                              Courses& courses, double least_apart, const Checkpoint& checkpoint) {
  return PieceConnector(space, outlines, edges, std::move(lines), ends, courses, least_apart,
                        checkpoint)
      .run();
}

}  // namespace stope::topology
