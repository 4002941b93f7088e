#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stope::planner {

/// Places by keys that never fall below the last one taken, nor rise above it by `most` or more.
class BucketQueue {
 public:
  explicit BucketQueue(std::uint32_t most) {
    std::size_t count = 1;
    while (count <= most) count *= 2;
    buckets_.resize(count);
  }
  void start(std::uint32_t key) { now_ = key; }
  void push(std::uint32_t key, std::uint32_t place) {
    buckets_[key & (buckets_.size() - 1)].push_back(place);
    ++size_;
  }
  bool empty() const { return size_ == 0; }
  /// One with the least key; of several the last that came.
  std::uint32_t pop() {
    while (buckets_[now_ & (buckets_.size() - 1)].empty()) ++now_;
    auto& bucket = buckets_[now_ & (buckets_.size() - 1)];
    const std::uint32_t place = bucket.back();
    bucket.pop_back();
    --size_;
    return place;
  }
  std::uint32_t key() const { return now_; }

 private:
  std::vector<std::vector<std::uint32_t>> buckets_;
  std::uint32_t now_ = 0;
  std::size_t size_ = 0;
};

}  // namespace stope::planner
