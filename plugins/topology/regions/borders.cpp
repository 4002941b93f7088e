#include "plugins/topology/regions/borders.hpp"

#include <algorithm>
#include <utility>

namespace stope::topology {

std::vector<Contact> all_contacts(const TileParts& tiles) {
  std::vector<Contact> contacts;
  for (std::size_t tile = 0; tile < tiles.size(); ++tile)
    contacts.insert(contacts.end(), tiles.contacts(tile).begin(), tiles.contacts(tile).end());
  return contacts;
}

std::vector<Border> find_borders(const std::vector<Contact>& contacts, const RegionSet& set) {
  std::vector<Border> borders;
  for (Contact contact : contacts) {
    contact.a = set.of(contact.a);
    contact.b = set.of(contact.b);
    if (contact.a == contact.b || contact.a == 0 || contact.b == 0) continue;
    if (contact.a > contact.b) std::swap(contact.a, contact.b);
    borders.push_back(contact);
  }
  std::sort(borders.begin(), borders.end(), is_before);
  std::size_t kept = 0;
  for (const Border& border : borders) {
    if (kept > 0 && borders[kept - 1].a == border.a && borders[kept - 1].b == border.b) {
      borders[kept - 1].steps += border.steps;
    } else {
      borders[kept++] = border;
    }
  }
  borders.resize(kept);
  return borders;
}

}  // namespace stope::topology
