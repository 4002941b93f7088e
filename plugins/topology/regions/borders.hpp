#pragma once

#include <vector>

#include "plugins/topology/regions/region_set.hpp"

namespace stope::topology {

/// Where two regions touch, by their numbers, the lower first; `low` and `high` are its clearest
/// cells.
using Border = Contact;

/// The contacts of all tiles, in their order.
std::vector<Contact> all_contacts(const TileParts& tiles);

/// The borders between regions, by their numbers in increasing order. Only free cells touch,
/// 8-connected.
std::vector<Border> find_borders(const std::vector<Contact>& contacts, const RegionSet& set);

}  // namespace stope::topology
