#include "plugins/topology/regions/merge_regions.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <set>
#include <utility>

#include "plugins/topology/regions/join_small.hpp"
#include "plugins/topology/regions/neighbour_lists.hpp"
#include "plugins/topology/regions/network.hpp"
#include "plugins/topology/regions/visit_convex.hpp"
#include "plugins/topology/regions/whole_points.hpp"

namespace stope::topology {
namespace {

double distance(const ShapePoint& a, const ShapePoint& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

ShapePoint centre(const RegionShape& shape) {
  return centre_of_gravity(shape.hull, shape.hull.front());
}

class Merging {
 public:
  Merging(const Ground& ground, const RegionCells& regions, const std::vector<RegionShape>& shapes,
          const std::vector<Contact>& contacts, const RegionSet& set, const MergeRule& rule,
          MergeMemo* memo)
      : ground_(ground),
        regions_(regions),
        rule_(rule),
        memo_(memo),
        shapes_(static_cast<std::size_t>(set.count)),
        borders_(static_cast<std::size_t>(set.count) + 1),
        now_(static_cast<std::size_t>(set.count) + 1) {
    for (std::size_t i = 0; i < now_.size(); ++i) now_[i] = static_cast<std::int32_t>(i);
    for (std::size_t name = 1; name < set.of_name.size(); ++name)
      if (set.of_name[name] != 0)
        shapes_[place(set.of_name[name])] = {&shapes[name], memo ? memo->shape_of(name) : 0};
    std::vector<Border> borders = find_borders(contacts, set);
    if (rule.as_printed) borders = tree_of(borders, set.count);
    for (const Border& border : borders) {
      borders_.add(border.a, border.b, border.steps);
      borders_.add(border.b, border.a, border.steps);
    }
    for (std::int32_t region = 1; region <= set.count; ++region) offer(region);
  }

  void run(const Checkpoint& checkpoint) {
    while (!small_.empty()) {
      checkpoint();
      const std::int32_t region = small_.begin()->second;
      small_.erase(small_.begin());
      for (const std::int32_t other : neighbours(region)) {
        if (!allowed(region, other)) continue;
        merge(region, other);
        break;
      }
    }
  }

  /// The region each has become, 0 for 0.
  const std::vector<std::int32_t>& now() {
    for (std::size_t i = 1; i < now_.size(); ++i) now_[i] = find(static_cast<std::int32_t>(i));
    return now_;
  }

 private:
  const RegionShape& shape(std::int32_t region) const { return *shapes_[place(region)].shape; }
  static std::size_t place(std::int32_t region) { return static_cast<std::size_t>(region) - 1; }

  std::vector<Border> tree_of(const std::vector<Border>& borders, std::int32_t count) const {
    std::vector<RegionLink> links;
    for (const Border& border : borders)
      links.push_back(
          {border.a - 1, border.b - 1, distance(centre(shape(border.a)), centre(shape(border.b)))});
    std::vector<Border> tree;
    for (const std::size_t i : spanning_tree(count, links)) tree.push_back(borders[i]);
    return tree;
  }

  void offer(std::int32_t region) {
    const double radius = shape(region).radius();
    if (radius < rule_.radius) small_.insert({radius, region});
  }

  std::vector<std::int32_t> neighbours(std::int32_t region) const {
    std::vector<std::pair<std::int64_t, std::int32_t>> order;
    for (const auto& [other, steps] : borders_.of(region)) order.emplace_back(-steps, other);
    std::sort(order.begin(), order.end());
    std::vector<std::int32_t> result;
    for (const auto& [steps, other] : order) result.push_back(other);
    return result;
  }

  bool allowed(std::int32_t a, std::int32_t b) {
    const RegionShape &first = shape(a), &second = shape(b);
    if (static_cast<double>(first.cells + second.cells) > rule_.area) return false;
    if (rule_.as_printed) return scan_allows(a, b);
    if (!memo_) return hull_allows(first, second);
    const MergeMemo::Shape one = shapes_[place(a)].number, other = shapes_[place(b)].number;
    if (const std::optional<bool> known = memo_->allowed(one, other)) return *known;
    const bool allows = hull_allows(first, second);
    memo_->note(one, other, allows);
    return allows;
  }

  bool hull_allows(const RegionShape& first, const RegionShape& second) const {
    const std::int64_t inside = whole_points_in(joined_hull(first.hull, second.hull));
    const std::int64_t own = first.cells + second.cells;
    return static_cast<double>(inside - own) <= rule_.obstacle_ratio * static_cast<double>(own);
  }

  /// Lines 4 to 18 of Algorithm 2: only the cells in a disc of the mean radius around the centre,
  /// weighted with the areas, are looked at.
  bool scan_allows(std::int32_t a, std::int32_t b) {
    const RegionShape &first = shape(a), &second = shape(b);
    const ShapePoint c1 = centre(first), c2 = centre(second);
    const auto n1 = static_cast<double>(first.cells), n2 = static_cast<double>(second.cells);
    const double x = (n1 * c1.x + n2 * c2.x) / (n1 + n2), y = (n1 * c1.y + n2 * c2.y) / (n1 + n2);
    const double radius = (first.radius() + second.radius()) / 2;
    std::vector<HullPoint> own, failed;
    for (auto row = static_cast<std::int32_t>(y - radius); row <= y + radius; ++row) {
      for (auto column = static_cast<std::int32_t>(x - radius); column <= x + radius; ++column) {
        if (std::hypot(column - x, row - y) > radius) continue;
        if (column < 0 || row < 0 || column >= ground_.width() || row >= ground_.height()) continue;
        const std::int32_t region = find(regions_[ground_.index(column, row)]);
        (region == a || region == b ? own : failed).push_back({column, row});
      }
    }
    if (own.empty()) return false;
    const std::vector<HullPoint> hull = convex_hull(own);
    std::int64_t inside = 0;
    visit_convex(hull, [&](std::int32_t row, std::int32_t left, std::int32_t right) {
      for (const HullPoint& cell : failed)
        inside += cell.y == row && cell.x >= left && cell.x <= right ? 1 : 0;
    });
    return static_cast<double>(inside) <= rule_.obstacle_ratio * static_cast<double>(own.size());
  }

  /// The second takes the first in.
  void merge(std::int32_t gone, std::int32_t kept) {
    small_.erase({shape(kept).radius(), kept});
    now_[static_cast<std::size_t>(gone)] = kept;
    const auto both = [&] {
      RegionShape sum = shape(kept);
      return sum += shape(gone);
    };
    Numbered& now = shapes_[place(kept)];
    if (memo_) {  // allowed() asked about the first with the second
      const auto& merged = memo_->merged(shapes_[place(gone)].number, now.number, both);
      now = {merged.shape.get(), merged.number};
    } else {
      merged_.push_back(both());
      now = {&merged_.back(), 0};
    }
    borders_.join(gone, kept, [](std::int64_t& steps, std::int64_t more) { steps += more; });
    offer(kept);
  }

  std::int32_t find(std::int32_t region) {
    while (now_[static_cast<std::size_t>(region)] != region) {
      auto& next = now_[static_cast<std::size_t>(region)];
      next = now_[static_cast<std::size_t>(next)];
      region = next;
    }
    return region;
  }

  const Ground& ground_;
  const RegionCells& regions_;
  MergeRule rule_;
  MergeMemo* memo_;
  struct Numbered {
    const RegionShape* shape = nullptr;
    MergeMemo::Shape number = 0;  ///< in the memo
  };
  std::vector<Numbered> shapes_;
  std::deque<RegionShape> merged_;        ///< shapes that regions have become, without a memo
  NeighbourLists<std::int64_t> borders_;  ///< their length
  std::vector<std::int32_t> now_;
  std::set<std::pair<double, std::int32_t>> small_;  ///< radius, region
};

}  // namespace

void merge_regions(const Ground& ground, const RegionCells& names,
                   const std::vector<RegionShape>& shapes, const std::vector<Contact>& contacts,
                   RegionSet& set, const MergeRule& rule, const Checkpoint& checkpoint,
                   MergeMemo* memo) {
  Merging merging(ground, names, shapes, contacts, set, rule, memo);
  merging.run(checkpoint);
  if (memo) memo->forget_unused();
  renumber(set, merging.now());
}

}  // namespace stope::topology
