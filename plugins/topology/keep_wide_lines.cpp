// Problem: cut the parts of lines that are too narrow to count, but never a way between two that
// are wide enough.
// Idea: narrow steps lie within one outline, so they are on no cycle: each parts its piece of the
// network in two, and is on a way between wide steps if there are some on both sides. So it is
// enough to take lines off from their open ends until a wide step comes; what is left is all that
// has wide steps on both sides. Nothing has to be searched for in space.
// Cost: linear in the lines.
#include "plugins/topology/keep_wide_lines.hpp"

#include <algorithm>

#include "plugins/topology/disjoint_sets.hpp"

namespace stope::topology {
namespace {

std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

class WideKeeper {
 public:
  WideKeeper(LineNetwork& network, const std::vector<std::vector<StepRange>>& narrow,
             std::int32_t few)
      : network_(network),
        narrow_(narrow),
        few_(few),
        pieces_(network.nodes.size()),
        wide_of_(network.lines.size()),
        kept_(network.lines.size()),
        open_ends_(network.nodes.size(), 0) {
    for (const Line& line : network_.lines) {
      pieces_.join(line.from, line.to);
      ++open_ends_[at(line.from)], ++open_ends_[at(line.to)];
    }
  }

  void run() {
    list_wide();
    leave_out_few();
    find_kept();
    leave_nodes_of_narrow_pieces();
    take_off_from_ends();
    for (std::size_t i = 0; i < kept_.size(); ++i) cut(network_.lines[i], kept_[i]);
    // Where nothing branches off any more a line runs from step to step.
    network_.tidy(false);
  }

 private:
  struct Wide {
    std::size_t line = 0;
    StepRange steps;
    std::int32_t group = 0;  ///< the node they begin or end at, else a number beyond all nodes
    bool joins = false;      ///< the nodes at both ends of its line
  };

  std::int32_t steps_of(std::size_t line) const {
    return static_cast<std::int32_t>(network_.points(network_.lines[line]).size()) - 2;
  }

  /// What is not narrow of each line.
  void list_wide() {
    auto groups = static_cast<std::int32_t>(network_.nodes.size());
    for (std::size_t i = 0; i < network_.lines.size(); ++i) {
      const Line& line = network_.lines[i];
      const std::int32_t count = steps_of(i);
      const auto add = [&](std::int32_t begin, std::int32_t end) {
        if (begin >= end) return;
        const std::int32_t group = begin == 0 ? line.from : end == count ? line.to : groups++;
        wide_.push_back({i, {begin, end}, group, begin == 0 && end == count});
      };
      std::int32_t begin = 0;
      for (const StepRange& stretch : narrow_[i]) {
        add(begin, stretch.begin);
        begin = stretch.end;
      }
      add(begin, count);
    }
    groups_ = at(groups);
  }

  void leave_out_few() {
    DisjointSets together(groups_);
    std::vector<std::int32_t> loops;
    for (const Wide& wide : wide_)
      if (wide.joins && !together.join(wide.group, network_.lines[wide.line].to))
        loops.push_back(wide.group);
    std::vector<bool> cyclic(groups_, false);
    for (const std::int32_t group : loops) cyclic[at(together.find(group))] = true;
    std::vector<std::int64_t> steps(groups_, 0);
    for (const Wide& wide : wide_)
      steps[at(together.find(wide.group))] += wide.steps.end - wide.steps.begin;
    // Of groups with as many steps the first.
    std::vector<std::int32_t> most(network_.nodes.size(), -1);
    for (const Wide& wide : wide_) {
      const std::int32_t group = together.find(wide.group);
      std::int32_t& best = most[at(piece_of(wide))];
      if (best < 0 || steps[at(group)] > steps[at(best)]) best = group;
    }
    std::erase_if(wide_, [&](const Wide& wide) {
      const std::int32_t group = together.find(wide.group);
      return !cyclic[at(group)] && steps[at(group)] <= few_ && most[at(piece_of(wide))] != group;
    });
  }
  std::int32_t piece_of(const Wide& wide) { return pieces_.find(network_.lines[wide.line].from); }

  /// Of each line from the first wide step to the last: what may be left when its ends go.
  void find_kept() {
    for (const Wide& wide : wide_) {
      StepRange& whole = wide_of_[wide.line];
      if (whole.begin == whole.end) whole.begin = wide.steps.begin;
      whole.end = wide.steps.end;
    }
    for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i] = {0, steps_of(i)};
  }

  void leave_nodes_of_narrow_pieces() {
    std::vector<bool> has_wide(network_.nodes.size(), false);
    for (const Wide& wide : wide_) has_wide[at(piece_of(wide))] = true;
    std::vector<std::int32_t> lone(network_.nodes.size(), -1);
    for (std::size_t i = 0; i < network_.lines.size(); ++i) {
      Line& line = network_.lines[i];
      const std::int32_t piece = pieces_.find(line.from);
      if (has_wide[at(piece)]) continue;
      std::int32_t& node = lone[at(piece)];
      const LinePoint widest = network_.courses->widest(line.course);
      if (node < 0) {
        node = static_cast<std::int32_t>(network_.nodes.size());
        network_.nodes.push_back({widest, true});
      }
      if (widest.distance > network_.nodes[at(node)].point.distance)
        network_.nodes[at(node)].point = widest;
    }
  }

  void take_off_from_ends() {
    const LinesAtNodes at_nodes(network_);
    std::vector<bool> gone(network_.lines.size(), false);
    for (std::size_t start = 0; start < open_ends_.size(); ++start) {
      for (auto node = static_cast<std::int32_t>(start); open_ends_[at(node)] == 1;) {
        const auto around = at_nodes[node];
        const std::int32_t name =
            *std::find_if(around.begin(), around.end(), [&](auto line) { return !gone[at(line)]; });
        const Line& line = network_.lines[at(name)];
        const StepRange wide = wide_of_[at(name)];
        StepRange& kept = kept_[at(name)];
        open_ends_[at(node)] = 0;
        if (wide.begin < wide.end) {
          if (line.from == node) kept.begin = wide.begin;
          if (line.to == node) kept.end = wide.end;
          break;
        }
        gone[at(name)] = true;
        kept = {0, 0};
        node = line.from == node ? line.to : line.from;
        --open_ends_[at(node)];
      }
    }
  }

  /// Point k + 1 is that of step k; the first and the last are the nodes'.
  void cut(Line& line, const StepRange& kept) {
    const auto count = static_cast<std::int32_t>(network_.points(line).size());
    if (kept.begin == kept.end) {
      network_.set_course(line, kNoCourse);
      return;
    }
    std::int32_t first = kept.begin == 0 ? 0 : kept.begin + 1;
    const std::int32_t last = kept.end == count - 2 ? count : kept.end + 1;
    if (last - first < 2) --first;
    if (first == 0 && last == count) return;
    network_.set_course(line, network_.courses->part(line.course, at(first), at(last)));
    const auto new_end = [&](const LinePoint& point) {
      network_.nodes.push_back({point, false});
      return static_cast<std::int32_t>(network_.nodes.size()) - 1;
    };
    if (first > 0) line.from = new_end(network_.courses->front(line.course));
    if (last < count) line.to = new_end(network_.courses->back(line.course));
  }

  LineNetwork& network_;
  const std::vector<std::vector<StepRange>>& narrow_;
  std::int32_t few_;
  DisjointSets pieces_;  ///< of nodes
  std::vector<Wide> wide_;
  std::size_t groups_ = 0;
  std::vector<StepRange> wide_of_;  ///< by line: from its first wide step to its last, or empty
  std::vector<StepRange> kept_;     ///< by line: the steps that stay
  std::vector<std::int32_t> open_ends_;  ///< by node: lines that end there
};

}  // namespace

void keep_wide_lines(LineNetwork& network, const std::vector<std::vector<StepRange>>& narrow,
                     std::int32_t few) {
  WideKeeper(network, narrow, few).run();
}

}  // namespace stope::topology
