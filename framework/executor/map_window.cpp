#include "framework/executor/map_window.hpp"

#include <algorithm>
#include <thread>
#include <utility>

namespace stope {

namespace {

constexpr int kItemsOfARunner = 32;            ///< then it queues up again
constexpr std::int64_t kWorthWaking = 20'000;  ///< ns of work that pay for one more runner
constexpr int kLooks = 40;                     ///< before a runner leaves or a process sleeps

}  // namespace

MapWindow::MapWindow(WorkerPool& pool, std::shared_ptr<Doorbell> doorbell, std::size_t places,
                     Apply apply)
    : pool_(pool),
      doorbell_(std::move(doorbell)),
      apply_(std::move(apply)),
      places_(places),
      usual_work_(kWorthWaking) {}

std::vector<MapItem*> MapWindow::all() {
  std::vector<MapItem*> items;
  for (Place& place : places_) items.push_back(&place.item);
  return items;
}

void MapWindow::submit() {
  places_[submitted_.load() % places_.size()].done.store(false, std::memory_order_relaxed);
  submitted_.fetch_add(1);
  call_runner();
}

int MapWindow::runners_wanted() const {
  const auto waiting = static_cast<std::int64_t>(submitted_.load() - claimed_.load());
  return static_cast<int>(std::min<std::int64_t>(
      pool_.threads(), 1 + waiting * usual_work_.load(std::memory_order_relaxed) / kWorthWaking));
}

void MapWindow::call_runner() {
  int runners = runners_.load();
  while (runners < runners_wanted()) {
    if (runners_.compare_exchange_weak(runners, runners + 1)) {
      pool_.enqueue(shared_from_this());
      return;
    }
  }
}

bool MapWindow::claim_soon(std::uint64_t& place) {
  for (int look = 0; look < kLooks; ++look) {
    if (claim(place)) return true;
    std::this_thread::yield();
  }
  return false;
}

bool MapWindow::claim(std::uint64_t& place) {
  place = claimed_.load();
  while (place < submitted_.load()) {
    if (claimed_.compare_exchange_weak(place, place + 1)) return true;
  }
  return false;
}

void MapWindow::run() noexcept {
  std::uint64_t number = 0;
  for (int i = 0; i < kItemsOfARunner; ++i) {
    if (!claim_soon(number)) {
      runners_.fetch_sub(1);
      // What was submitted meanwhile may have counted on this runner.
      if (claimed_.load() < submitted_.load()) call_runner();
      return;
    }
    Place& place = places_[number % places_.size()];
    apply_(place.item);
    const std::int64_t usual = usual_work_.load(std::memory_order_relaxed);
    usual_work_.store(usual + (place.item.work - usual) / 8, std::memory_order_relaxed);
    place.done.store(true);
    if (oldest_.load() == number) doorbell_->ring();
  }
  pool_.enqueue(shared_from_this());
}

void MapWindow::advance() { oldest_.fetch_add(1); }

void MapWindow::stop() {
  for (std::uint64_t number = 0; claim(number);) places_[number % places_.size()].done.store(true);
  while (!empty()) {
    doorbell_->prepare();
    if (!oldest_done()) doorbell_->sleep();
    doorbell_->dismiss();
    if (oldest_done()) advance();
  }
}

}  // namespace stope
