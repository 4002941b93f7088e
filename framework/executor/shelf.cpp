#include "framework/executor/shelf.hpp"

#include <algorithm>
#include <functional>
#include <limits>

#include "framework/executor/channel.hpp"
#include "framework/executor/stored_payload.hpp"

namespace stope {

void Shelf::insert(std::uint64_t place, StoredPayload& payload) {
  const std::lock_guard lock(mutex_);
  entries_[place] = {&payload, 0};
}

void Shelf::erase(std::uint64_t place) {
  const std::lock_guard lock(mutex_);
  entries_.erase(place);
}

std::optional<Shelf::Choice> Shelf::choose(std::uint64_t round) const {
  std::vector<std::uint64_t> heads;
  for (const Channel* reader : readers_) {
    if (!reader->abandoned()) heads.push_back(reader->items_read());
  }
  std::sort(heads.begin(), heads.end(), std::greater<>());
  std::optional<Choice> best;
  // Between two heads, the reader further back is the next to come by.
  std::uint64_t end = std::numeric_limits<std::uint64_t>::max();
  for (const std::uint64_t head : heads) {
    if (const auto entry = last_between(head, end, round); entry != entries_.end()) {
      const std::uint64_t distance = entry->first - head + 1;
      if (!best || distance > best->distance) best = Choice{entry, distance};
    }
    end = head;
  }
  if (best) return best;
  // What every reader has taken out is in use or about to be: the last to go.
  const auto entry = last_between(0, end, round);
  return entry == entries_.end() ? std::nullopt : std::optional(Choice{entry, 0});
}

Shelf::Entries::const_iterator Shelf::last_between(std::uint64_t begin, std::uint64_t end,
                                                   std::uint64_t round) const {
  auto entry = entries_.lower_bound(end);
  while (entry != entries_.begin()) {
    --entry;
    if (entry->first < begin) break;
    if (entry->second.tried_in_round != round) return entry;
  }
  return entries_.end();
}

std::optional<std::uint64_t> Shelf::furthest(std::uint64_t round) const {
  const std::lock_guard lock(mutex_);
  const auto choice = choose(round);
  return choice ? std::optional(choice->distance) : std::nullopt;
}

std::shared_ptr<StoredPayload> Shelf::take_furthest(std::uint64_t round) {
  const std::lock_guard lock(mutex_);
  const auto choice = choose(round);
  if (!choice) return nullptr;
  // A payload that is dying waits for the lock to leave the shelf: its memory is still there, but
  // it cannot be had any more.
  auto payload = choice->entry->second.payload->weak_from_this().lock();
  entries_.erase(choice->entry);
  return payload;
}

void Shelf::put_back(std::uint64_t place, StoredPayload& payload, std::uint64_t round) {
  const std::lock_guard lock(mutex_);
  entries_[place] = {&payload, round};
}

}  // namespace stope
