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
  // By counting up to the first region, of which each has few: much less than to sort them all.
  std::vector<std::size_t> end(static_cast<std::size_t>(set.count) + 2, 0);
  const auto touching = [&](const Contact& contact, auto&& visit) {
    const std::int32_t a = set.of(contact.a), b = set.of(contact.b);
    if (a != b && a != 0 && b != 0) visit(std::min(a, b), std::max(a, b));
  };
  for (const Contact& contact : contacts)
    touching(contact,
             [&](std::int32_t a, std::int32_t) { ++end[static_cast<std::size_t>(a) + 1]; });
  for (std::size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
  std::vector<Border> borders(end.back());
  for (const Contact& contact : contacts) {
    touching(contact, [&](std::int32_t a, std::int32_t b) {
      Border& border = borders[end[static_cast<std::size_t>(a)]++];
      border = contact;
      border.a = a, border.b = b;
    });
  }
  std::size_t kept = 0, begin = 0;
  for (const std::size_t past : end) {  // the next region's begin by now is this one's end
    std::sort(borders.begin() + static_cast<std::ptrdiff_t>(begin),
              borders.begin() + static_cast<std::ptrdiff_t>(past), is_before);
    for (; begin < past; ++begin) {
      const Border border = borders[begin];
      if (kept > 0 && borders[kept - 1].a == border.a && borders[kept - 1].b == border.b) {
        borders[kept - 1].steps += border.steps;
      } else {
        borders[kept++] = border;
      }
    }
  }
  borders.resize(kept);
  return borders;
}

}  // namespace stope::topology
