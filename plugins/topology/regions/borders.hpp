#pragma once

#include <vector>

#include "plugins/topology/regions/region_set.hpp"

namespace stope::topology {

/// Where two regions touch, by their numbers, the lower first; `low` and `high` are its clearest
/// cells.
using Border = Contact;

/// By the regions' numbers, and of the same two the clearest first.
inline bool is_before(const Border& x, const Border& y) {
  if (x.a != y.a) return x.a < y.a;
  return x.b != y.b ? x.b < y.b : is_clearer(x, y);
}

/// The contacts of all tiles, in their order.
std::vector<Contact> all_contacts(const TileParts& tiles);

/// The borders between regions, one for each two, by their numbers in increasing order. Only free
/// cells touch, 8-connected.
std::vector<Border> find_borders(const std::vector<Contact>& contacts, const RegionSet& set);

}  // namespace stope::topology
