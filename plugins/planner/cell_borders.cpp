#include "plugins/planner/cell_borders.hpp"

#include <algorithm>

namespace stope::planner {

LinksByLower::LinksByLower(std::uint32_t places, std::span<const CellLink> all)
    : first(places + 1, 0), links(all.size()) {
  for (const CellLink& link : all) ++first[std::min(link.from, link.to) + 1];
  for (std::uint32_t place = 0; place < places; ++place) first[place + 1] += first[place];
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t i = 0; i < all.size(); ++i)
    links[next[std::min(all[i].from, all[i].to)]++] = i;
}

CellBorders cell_borders(const Dissection& dissection, std::span<const CellLink> links) {
  const LinksByLower by_lower(static_cast<std::uint32_t>(dissection.order.size()), links);
  std::vector<std::vector<std::uint32_t>> waiting(dissection.cells.size());
  CellBorders borders;
  for (std::uint32_t cell = 0; cell < dissection.cells.size(); ++cell) {
    const auto& [first, own, end, parent] = dissection.cells[cell];
    auto& border = waiting[cell];
    for (std::uint32_t i = by_lower.first[own]; i < by_lower.first[end]; ++i) {
      const CellLink& link = links[by_lower.links[i]];
      border.push_back(std::max(link.from, link.to));
    }
    std::sort(border.begin(), border.end());
    border.erase(std::unique(border.begin(), border.end()), border.end());
    border.erase(border.begin(), std::lower_bound(border.begin(), border.end(), end));
    borders.places.insert(borders.places.end(), border.begin(), border.end());
    borders.first.push_back(static_cast<std::uint32_t>(borders.places.size()));
    if (parent != Cell::kNone)
      waiting[parent].insert(waiting[parent].end(), border.begin(), border.end());
    std::vector<std::uint32_t>().swap(border);
  }
  return borders;
}

}  // namespace stope::planner
