#include "framework/report/graph/layered_layout.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace stope::report {
namespace {

constexpr int kOrderSweeps = 24, kHeightSweeps = 40;

// A box, or the passage of a wire through a column.
struct Slot {
  int column = 0;
  double height = 0;
  double top = 0;
  bool passage = false;
};

// A wire, or a part of one, between neighbouring columns.
struct Link {
  std::size_t from = 0, to = 0;           ///< slots
  double from_height = 0, to_height = 0;  ///< below the slots' upper edges
};

class Layouter {
 public:
  explicit Layouter(const LayoutProblem& problem) : problem_(problem) {
    assign_columns();
    add_passages();
  }

  Layout run() {
    order_columns();
    assign_heights();
    return result();
  }

 private:
  void assign_columns() {
    std::vector<int> column(problem_.boxes.size(), 0);
    for (std::size_t i = 0; i < column.size(); ++i) column[i] = problem_.boxes[i].earliest_column;
    // Boxes stand in topological order, but wires need not: repeat until nothing moves.
    for (bool moved = true; moved;) {
      moved = false;
      for (const auto& wire : problem_.wires) {
        if (column[wire.to] > column[wire.from]) continue;
        column[wire.to] = column[wire.from] + 1;
        moved = true;
      }
    }
    // A source moves next to its first reader.
    std::vector<bool> reads(column.size(), false);
    std::vector<int> nearest(column.size(), std::numeric_limits<int>::max());
    for (const auto& wire : problem_.wires) {
      reads[wire.to] = true;
      nearest[wire.from] = std::min(nearest[wire.from], column[wire.to]);
    }
    for (std::size_t i = 0; i < column.size(); ++i) {
      if (!reads[i] && nearest[i] != std::numeric_limits<int>::max()) column[i] = nearest[i] - 1;
      slots_.push_back({column[i], problem_.boxes[i].height, 0, false});
      columns_ = std::max(columns_, column[i] + 1);
    }
  }

  void add_passages() {
    passages_.resize(problem_.wires.size());
    for (std::size_t w = 0; w < problem_.wires.size(); ++w) {
      const auto& wire = problem_.wires[w];
      std::size_t from = wire.from;
      double from_height = wire.from_height;
      for (int column = slots_[wire.from].column + 1; column < slots_[wire.to].column; ++column) {
        slots_.push_back({column, problem_.lane, 0, true});
        passages_[w].push_back(slots_.size() - 1);
        links_.push_back({from, slots_.size() - 1, from_height, problem_.lane / 2});
        from = slots_.size() - 1;
        from_height = problem_.lane / 2;
      }
      links_.push_back({from, wire.to, from_height, wire.to_height});
    }
    // Those of one column side by side, for counting crossings.
    std::stable_sort(links_.begin(), links_.end(), [this](const Link& a, const Link& b) {
      return slots_[a.from].column < slots_[b.from].column;
    });
    links_of_.resize(slots_.size());
    for (std::size_t l = 0; l < links_.size(); ++l) {
      links_of_[links_[l].from].push_back(l);
      links_of_[links_[l].to].push_back(l);
    }
    order_.resize(static_cast<std::size_t>(columns_));
    for (std::size_t s = 0; s < slots_.size(); ++s) column_of(s).push_back(s);
  }

  std::vector<std::size_t>& column_of(std::size_t slot) {
    return order_[static_cast<std::size_t>(slots_[slot].column)];
  }

  // Tops such that every column stands centred on the same line, without looking at wires.
  void stack() {
    for (const auto& column : order_) {
      double height = 0;
      for (const std::size_t s : column) height += slots_[s].height + gap_after(s);
      double top = -height / 2;
      for (const std::size_t s : column) {
        slots_[s].top = top;
        top += slots_[s].height + gap_after(s);
      }
    }
  }

  double gap_after(std::size_t slot) const {
    return slots_[slot].passage ? problem_.gap / 2 : problem_.gap;
  }

  // Where a slot's top would be if its wires from the left (or to the right) were level.
  double wanted_top(std::size_t slot, bool left, bool both = false) const {
    double sum = 0, weights = 0;
    const auto add = [&](std::size_t other, double top) {
      // A wire on its way should run straight: its bends count more than its ends.
      const double weight = slots_[slot].passage && slots_[other].passage ? 8 : 1;
      sum += weight * top;
      weights += weight;
    };
    for (const std::size_t place : links_of_[slot]) {
      const Link& link = links_[place];
      if ((left || both) && link.to == slot)
        add(link.from, slots_[link.from].top + link.from_height - link.to_height);
      if ((!left || both) && link.from == slot)
        add(link.to, slots_[link.to].top + link.to_height - link.from_height);
    }
    return weights > 0 ? sum / weights : slots_[slot].top;
  }

  std::size_t crossings() const {
    std::size_t count = 0;
    for (std::size_t a = 0; a < links_.size(); ++a) {
      for (std::size_t b = a + 1; b < links_.size(); ++b) {
        const Link &one = links_[a], &two = links_[b];
        if (slots_[one.from].column != slots_[two.from].column) break;
        const double left =
            slots_[one.from].top + one.from_height - slots_[two.from].top - two.from_height;
        const double right =
            slots_[one.to].top + one.to_height - slots_[two.to].top - two.to_height;
        count += left * right < 0 ? 1 : 0;
      }
    }
    return count;
  }

  void order_columns() {
    stack();
    auto best = order_;
    std::size_t fewest = crossings();
    for (int sweep = 0; sweep < kOrderSweeps && fewest > 0; ++sweep) {
      const bool left = sweep % 2 == 0;
      for (int i = 0; i < columns_; ++i) {
        auto& column = order_[static_cast<std::size_t>(left ? i : columns_ - 1 - i)];
        std::vector<std::pair<double, std::size_t>> wanted;
        for (const std::size_t s : column)
          wanted.emplace_back(wanted_top(s, left) + slots_[s].height / 2, s);
        std::stable_sort(wanted.begin(), wanted.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        for (std::size_t k = 0; k < column.size(); ++k) column[k] = wanted[k].second;
        stack();
      }
      const std::size_t now = crossings();
      if (now < fewest) fewest = now, best = order_;
    }
    order_ = best;
    stack();
  }

  // Tops nearest to the wanted ones, in least squares, that keep the column's order and gaps.
  void settle(const std::vector<std::size_t>& column, const std::vector<double>& wanted) {
    struct Pool {
      double sum = 0;
      int count = 0;
      double mean() const { return sum / count; }
    };
    std::vector<double> offset(column.size(), 0.0);
    for (std::size_t k = 1; k < column.size(); ++k)
      offset[k] = offset[k - 1] + slots_[column[k - 1]].height + gap_after(column[k - 1]);
    std::vector<Pool> pools;
    for (std::size_t k = 0; k < column.size(); ++k) {
      pools.push_back({wanted[k] - offset[k], 1});
      while (pools.size() > 1 && pools[pools.size() - 2].mean() > pools.back().mean()) {
        const Pool last = pools.back();
        pools.pop_back();
        pools.back().sum += last.sum;
        pools.back().count += last.count;
      }
    }
    std::size_t k = 0;
    for (const Pool& pool : pools) {
      for (int i = 0; i < pool.count; ++i, ++k) slots_[column[k]].top = pool.mean() + offset[k];
    }
  }

  void assign_heights() {
    for (int sweep = 0; sweep < kHeightSweeps; ++sweep) {
      const bool left = sweep % 2 == 0;
      const bool last = sweep + 16 >= kHeightSweeps;
      for (int i = 0; i < columns_; ++i) {
        const auto& column = order_[static_cast<std::size_t>(left ? i : columns_ - 1 - i)];
        std::vector<double> wanted;
        for (const std::size_t s : column) wanted.push_back(wanted_top(s, left, last));
        settle(column, wanted);
      }
    }
  }

  Layout result() const {
    double lowest = std::numeric_limits<double>::infinity(), highest = 0;
    for (const Slot& slot : slots_) lowest = std::min(lowest, slot.top);
    Layout layout;
    layout.columns = columns_;
    for (std::size_t i = 0; i < problem_.boxes.size(); ++i) {
      layout.column.push_back(slots_[i].column);
      layout.top.push_back(slots_[i].top - lowest);
    }
    for (const Slot& slot : slots_) highest = std::max(highest, slot.top - lowest + slot.height);
    layout.height = slots_.empty() ? 0 : highest;
    for (const auto& passage : passages_) {
      std::vector<Layout::Bend> bends;
      for (const std::size_t s : passage)
        bends.push_back({slots_[s].column, slots_[s].top - lowest + slots_[s].height / 2});
      layout.bends.push_back(std::move(bends));
    }
    return layout;
  }

  const LayoutProblem& problem_;
  int columns_ = 0;
  std::vector<Slot> slots_;  ///< the boxes, then the passages
  std::vector<Link> links_;
  std::vector<std::vector<std::size_t>> links_of_;  ///< by slot: those that begin or end there
  std::vector<std::vector<std::size_t>> passages_;  ///< by wire: slots
  std::vector<std::vector<std::size_t>> order_;     ///< by column: slots from top to bottom
};

}  // namespace

Layout lay_out(const LayoutProblem& problem) { return Layouter(problem).run(); }

}  // namespace stope::report
