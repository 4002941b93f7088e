#include "plugins/topology/line_network.hpp"

#include <utility>

namespace stope::topology {
namespace {

std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

/// Makes one line of those that follow each other from node to node where no other line ends.
class ChainJoiner {
 public:
  ChainJoiner(LineNetwork& network, bool keep_places)
      : network_(network),
        keep_places_(keep_places),
        at_nodes_(network),
        taken_(network.lines.size(), false) {}

  std::vector<Line> run() {
    const auto nodes = static_cast<std::int32_t>(network_.nodes.size());
    for (std::int32_t node = 0; node < nodes; ++node) {
      if (is_joint(node)) continue;
      for (const std::int32_t line : at_nodes_[node])
        if (!taken_[at(line)]) follow(node, line);
    }
    // Rings without a junction.
    for (std::int32_t node = 0; node < nodes; ++node)
      if (is_joint(node) && !taken_[at(at_nodes_[node][0])]) follow(node, at_nodes_[node][0]);
    return std::move(result_);
  }

 private:
  bool is_joint(std::int32_t node) const {
    const auto lines = at_nodes_[node];
    return lines.size() == 2 && lines[0] != lines[1];
  }

  void follow(std::int32_t start, std::int32_t name) {
    std::vector<CourseId> courses;
    std::int32_t node = start;
    while (true) {
      taken_[at(name)] = true;
      const Line& line = network_.lines[at(name)];
      const bool forwards = line.from == node;
      courses.push_back(forwards ? line.course : backwards(line.course));
      node = forwards ? line.to : line.from;
      if (node == start || !is_joint(node)) break;
      const auto lines = at_nodes_[node];
      name = lines[lines[0] == name ? 1 : 0];
    }
    if (courses.size() == 1) {
      result_.push_back(network_.lines[at(name)]);
      return;
    }
    const CourseId whole =
        keep_places_ ? network_.courses->joined(courses) : network_.courses->merged(courses);
    for (const CourseId course : courses) network_.courses->drop(course);
    result_.push_back({start, node, whole, network_.courses->length(whole)});
  }

  LineNetwork& network_;
  bool keep_places_;
  LinesAtNodes at_nodes_;
  std::vector<bool> taken_;
  std::vector<Line> result_;
};

}  // namespace

LinesAtNodes::LinesAtNodes(const LineNetwork& network) : begin_(network.nodes.size() + 1, 0) {
  for (const Line& line : network.lines) {
    if (line.erased()) continue;
    ++begin_[at(line.from) + 1], ++begin_[at(line.to) + 1];
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  lines_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < network.lines.size(); ++i) {
    const Line& line = network.lines[i];
    if (line.erased()) continue;
    lines_[next[at(line.from)]++] = static_cast<std::int32_t>(i);
    lines_[next[at(line.to)]++] = static_cast<std::int32_t>(i);
  }
}

void LineNetwork::tidy(bool keep_places) {
  lines = ChainJoiner(*this, keep_places).run();
  std::vector<std::int32_t> place(nodes.size(), -1);
  for (const Line& line : lines) place[at(line.from)] = place[at(line.to)] = 0;
  std::vector<Node> used;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    if (place[node] < 0 && !nodes[node].alone) continue;
    place[node] = static_cast<std::int32_t>(used.size());
    used.push_back(nodes[node]);
  }
  for (Line& line : lines) line.from = place[at(line.from)], line.to = place[at(line.to)];
  nodes = std::move(used);
}

}  // namespace stope::topology
