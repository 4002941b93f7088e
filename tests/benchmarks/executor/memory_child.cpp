// One run over a recording many times larger than the memory budget, in a process of its own, so
// that the kernel's high-water mark is this run's alone. memory_benchmark starts it for each case.
//
//     memory_child lazy|derived <payload bytes> <threads> <budget MiB> <recording MiB>
//
// Every payload is touched twice: by an estimate that needs all of them and, from the start again,
// by a map that first waits for the estimate. Stages use a third of the budget for themselves.
#include <chrono>
#include <cstdlib>
#include <iostream>

#include "tests/framework/executor/bench_of_stages.hpp"

namespace stope::toy {
namespace {

struct Blob {
  static constexpr std::string_view kType = "toy/Blob@1";
  std::vector<std::uint64_t> words;
  static constexpr void fields(auto& s, auto&& visit) { visit("words", s.words); }
};

struct Total {
  static constexpr std::string_view kType = "toy/Total@1";
  std::uint64_t value = 0;
  static constexpr void fields(auto& s, auto&& visit) { visit("value", s.value); }
};

Blob make_blob(std::uint64_t seed, std::size_t words) {
  Blob blob;
  blob.words.resize(words);
  for (std::size_t i = 0; i < words; ++i) blob.words[i] = seed + i;
  return blob;
}

std::uint64_t sum(const Blob& blob) {
  std::uint64_t total = 0;
  for (const std::uint64_t word : blob.words) total += word;
  return total;
}

class Recording final : public Stage {
 public:
  struct Params {
    std::int64_t count = 0, words = 0;
  } params;
  Out<Blob> blobs;
  static void describe(About<Recording>& about) {
    about.summary("Lazy blobs.")
        .output("blobs", &Recording::blobs)
        .param("count", &Params::count, "Items.")
        .param("words", &Params::words, "Words of an item.");
  }
  void run(Context&) override {
    const auto words = static_cast<std::size_t>(params.words);
    for (std::int64_t i = 0; i < params.count; ++i)
      blobs.put_lazy(
          i, [i, words] { return make_blob(static_cast<std::uint64_t>(i), words); }, 8 * words);
  }
};

class Derive final : public Map<Blob(Blob)> {
 public:
  struct Params {
  } params;
  static void describe(About<Derive>& about) { about.summary("Turns.").ports("blob", "turned"); }
  Blob apply(const Blob& blob, Context&) const {
    Blob turned = blob;
    for (std::uint64_t& word : turned.words) word = ~word;
    return turned;
  }
};

class Estimate final : public Stage {
 public:
  struct Params {
    std::int64_t working_words = 0;
  } params;
  In<Blob> blobs;
  OutValue<Total> total;
  static void describe(About<Estimate>& about) {
    about.summary("Sums, with memory of its own.")
        .input("blobs", &Estimate::blobs)
        .output("total", &Estimate::total)
        .param("working_words", &Params::working_words, "Own memory.");
  }
  void run(Context&) override {
    std::vector<std::uint64_t> own(static_cast<std::size_t>(params.working_words), 1);
    Total result;
    while (const auto blob = blobs.next()) {
      result.value += sum(*blob);
      own[blob.index() % own.size()] += result.value;
    }
    total.set(result);
  }
};

class Again final : public Map<Total(Blob, Total)> {
 public:
  struct Params {
  } params;
  static void describe(About<Again>& about) {
    about.summary("Second pass.").ports("blob", "total", "again");
  }
  Total apply(const Blob& blob, const Total& total, Context&) const {
    return {sum(blob) + total.value};
  }
};

int run(const std::string& kind, std::size_t bytes, int threads, std::size_t budget,
        std::size_t recording) {
  PlanBuilder bench;
  bench.options.threads = threads;
  bench.options.memory = budget;
  const auto count = static_cast<std::int64_t>(recording / bytes);
  bench.stage<Recording>("recording", {},
                         {{"count", count}, {"words", static_cast<std::int64_t>(bytes / 8)}});
  std::string blobs = "recording.blobs";
  if (kind == "derived") {
    bench.stage<Derive>("derive", {{"blob", blobs}});
    blobs = "derive.turned";
  }
  std::uint64_t items = 0, checksum = 0;
  bench
      .stage<Estimate>("estimate", {{"blobs", blobs}},
                       {{"working_words", static_cast<std::int64_t>(budget / 3 / 8)}})
      .stage<Again>("again", {{"blob", blobs}, {"total", "estimate.total"}})
      .sink("again.again", [&](const AnyItem& item) {
        ++items;
        checksum = checksum * 31 + Item<Total>(item)->value;
      });
  const RunRecord record = bench.run();
  if (record.end != RunRecord::End::kDone || items != static_cast<std::uint64_t>(count)) {
    std::cerr << "the run failed: " << record.sentence << "\n";
    return 1;
  }
  std::cout << static_cast<double>(record.peak_resident) / static_cast<double>(budget) << " "
            << static_cast<double>(record.wall) * 1e-9 << " " << record.payloads_loaded << " "
            << record.payloads_spilled << " " << record.payloads_evicted << " " << checksum << "\n";
  return 0;
}

}  // namespace
}  // namespace stope::toy

int main(int count, char** arguments) {
  if (count != 6) {
    std::cerr
        << "memory_child lazy|derived <payload bytes> <threads> <budget MiB> <recording MiB>\n";
    return 2;
  }
  return stope::toy::run(arguments[1], std::strtoull(arguments[2], nullptr, 10),
                         std::atoi(arguments[3]), std::strtoull(arguments[4], nullptr, 10) << 20U,
                         std::strtoull(arguments[5], nullptr, 10) << 20U);
}
