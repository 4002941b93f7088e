#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "tests/framework/executor/toy_stages.hpp"

/// Stages over payloads large enough to be evicted.
namespace stope::toy {

struct Blob {
  static constexpr std::string_view kType = "toy/Blob@1";
  std::vector<std::uint64_t> words;
  std::string text;
  static constexpr void fields(auto& s, auto&& visit) {
    visit("words", s.words);
    visit("text", s.text);
  }
};

inline Blob make_blob(std::uint64_t seed, std::size_t words) {
  Blob blob;
  for (std::size_t i = 0; i < words; ++i) blob.words.push_back(seed * 1'000'003 + i);
  blob.text = "blob " + std::to_string(seed);
  return blob;
}

inline std::int64_t checksum(const Blob& blob) {
  std::uint64_t sum = blob.text.size();
  for (const std::uint64_t word : blob.words) sum = sum * 31 + word;
  return static_cast<std::int64_t>(sum);
}

/// A recording: blobs, lazy or not.
class Blobs final : public Stage {
 public:
  struct Params {
    std::int64_t count = 100, words = 5000;
    bool lazy = true;
    std::optional<std::int64_t> fail_at;
  } params;
  Out<Blob> blobs;
  static void describe(About<Blobs>& about) {
    about.summary("Blobs.")
        .output("blobs", &Blobs::blobs)
        .param("count", &Params::count, "Items.")
        .param("words", &Params::words, "Words of an item.")
        .param("lazy", &Params::lazy, "Whether they load when touched.")
        .param("fail_at", &Params::fail_at, "The item that cannot be loaded.");
  }
  void run(Context&) override {
    const auto words = static_cast<std::size_t>(params.words);
    for (std::int64_t i = 0; i < params.count; ++i) {
      const auto seed = static_cast<std::uint64_t>(i);
      if (!params.lazy) {
        blobs.put(i * 1'000'000'000, make_blob(seed, words));
        continue;
      }
      const bool broken = params.fail_at == i;
      blobs.put_lazy(
          i * 1'000'000'000,
          [seed, words, broken] {
            if (broken) throw Error("the file is shorter than its header says");
            return make_blob(seed, words);
          },
          8 * words);
    }
  }
};

/// The checksum of all blobs, as a value.
class BlobTotal final : public Stage {
 public:
  struct Params {
  } params;
  In<Blob> blobs;
  OutValue<Number> total;
  static void describe(About<BlobTotal>& about) {
    about.summary("Totals.").input("blobs", &BlobTotal::blobs).output("total", &BlobTotal::total);
  }
  void run(Context&) override {
    std::uint64_t sum = 0;
    while (const auto blob = blobs.next())
      sum = sum * 7 + static_cast<std::uint64_t>(checksum(*blob));
    total.set({static_cast<std::int64_t>(sum)});
  }
};

/// The checksum of each blob, once the total is known, as a map.
class BlobAgain final : public Map<Number(Blob, Number)> {
 public:
  struct Params {
  } params;
  static void describe(About<BlobAgain>& about) {
    about.summary("Second pass.").ports("blob", "total", "again");
  }
  Number apply(const Blob& blob, const Number&, Context&) const { return {checksum(blob)}; }
};

}  // namespace stope::toy
