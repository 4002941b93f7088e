#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace stope {

class Channel;
class StoredPayload;

/// The payloads of one output that are in memory, in the order in which they were written; from
/// here the memory budget takes what to evict.
///
/// The best to evict is what is needed last. Channels are read in order, so a payload's next use
/// lies as far ahead as the nearest reader that has not read it has items before it. In the common
/// hard case, one reader at the front and another that begins only when the first has finished,
/// that evicts what the first has just left behind and keeps what the second will ask for next.
class Shelf {
 public:
  /// A channel that carries these payloads. Before the run begins.
  void add_reader(const Channel& channel) { readers_.push_back(&channel); }

  /// A payload has come into memory, or dies. `place` counts the output's items.
  void insert(std::uint64_t place, StoredPayload& payload);
  void erase(std::uint64_t place);

  /// How far ahead the furthest payload's next use is, among those not tried in this round; none if
  /// there is none.
  std::optional<std::uint64_t> furthest(std::uint64_t round) const;
  /// Takes that payload off the shelf. Null if it is dying, or there is none any more.
  std::shared_ptr<StoredPayload> take_furthest(std::uint64_t round);
  /// Puts back one that could not be evicted; it is not tried again in this round.
  void put_back(std::uint64_t place, StoredPayload& payload, std::uint64_t round);

 private:
  struct Entry {
    StoredPayload* payload = nullptr;
    std::uint64_t tried_in_round = 0;
  };
  using Entries = std::map<std::uint64_t, Entry>;
  struct Choice {
    Entries::const_iterator entry;
    std::uint64_t distance = 0;
  };
  std::optional<Choice> choose(std::uint64_t round) const;
  /// The last entry of [begin, end) that was not tried in this round.
  Entries::const_iterator last_between(std::uint64_t begin, std::uint64_t end,
                                       std::uint64_t round) const;

  mutable std::mutex mutex_;
  Entries entries_;
  std::vector<const Channel*> readers_;
};

}  // namespace stope
