#pragma once

#include <chrono>
#include <thread>
#include <vector>

#include "tests/framework/executor/toy_stages.hpp"

/// Stages for stress tests: each may pause at random between its operations and may break down at
/// any chosen one of them.
namespace stope::toy {

struct Trouble {
  std::int64_t seed = 0;
  std::optional<std::int64_t> fail_at;
};

/// Goes through the operations of a stage.
class Steps {
 public:
  explicit Steps(const Trouble& trouble)
      : trouble_(trouble), random_(static_cast<std::uint64_t>(trouble.seed)) {}
  void step() {
    if (trouble_.fail_at == count_++) throw Error("broken on purpose");
    const std::uint64_t dice = random_.below(32);
    if (dice == 0) std::this_thread::sleep_for(std::chrono::microseconds(random_.below(100)));
    if (dice == 1) std::this_thread::yield();
  }

 private:
  Trouble trouble_;
  Random random_;
  std::int64_t count_ = 0;
};

template <class S>
void describe_trouble(About<S>& about) {
  about.param("seed", &S::Params::seed, "Of its pauses.")
      .param("fail_at", &S::Params::fail_at, "Operation to fail at.");
}

/// Random numbers at irregular times; forever if count < 0.
class StressSource final : public Stage {
 public:
  struct Params : Trouble {
    std::int64_t count = 10;
  } params;
  Out<Number> numbers;
  static void describe(About<StressSource>& about) {
    about.summary("Numbers.")
        .output("out", &StressSource::numbers)
        .param("count", &Params::count, "How many.");
    describe_trouble(about);
  }
  static std::int64_t value(std::int64_t i) { return i * i % 1009 - 500; }
  static Stamp stamp(std::int64_t i) { return i * 7 - i % 3; }
  void run(Context&) override {
    Steps steps(params);
    for (std::int64_t i = 0; i != params.count; ++i) {
      steps.step();
      numbers.put(stamp(i), {value(i)}, static_cast<std::uint64_t>(2 * i));
    }
  }
};

/// A running sum: what it gives depends on the order of everything before.
class StressRunningSum final : public Stage {
 public:
  struct Params : Trouble {
  } params;
  In<Number> in;
  Out<Number> out;
  static void describe(About<StressRunningSum>& about) {
    about.summary("Running sum.")
        .input("a", &StressRunningSum::in)
        .output("out", &StressRunningSum::out);
    describe_trouble(about);
  }
  void run(Context&) override {
    Steps steps(params);
    std::int64_t sum = 0;
    while (const auto number = in.next()) {
      steps.step();
      sum = sum * 3 % 100'003 + number->value;
      out.put(number.stamp(), {sum}, number.index());
    }
  }
};

/// Joins two streams in time order; where times are equal, those of `a` come first.
class StressJoin final : public Stage {
 public:
  struct Params : Trouble {
  } params;
  In<Number> a, b;
  Out<Number> out;
  static void describe(About<StressJoin>& about) {
    about.summary("Joins.")
        .input("a", &StressJoin::a)
        .input("b", &StressJoin::b)
        .output("out", &StressJoin::out);
    describe_trouble(about);
  }
  void run(Context&) override {
    Steps steps(params);
    const auto write = [&](const Item<Number>& number) {
      steps.step();
      out.put(number.stamp(), *number);
    };
    while (const auto later = b.next()) {
      for (const auto& number : a.until(later.stamp())) write(number);
      write(later);
    }
    while (const auto number = a.next()) write(number);
  }
};

/// The sum of the first `most` numbers, as a value; ends before its input does.
class StressTotal final : public Stage {
 public:
  struct Params : Trouble {
    std::int64_t most = 1'000'000;
  } params;
  In<Number> in;
  OutValue<Number> out;
  static void describe(About<StressTotal>& about) {
    about.summary("Total.")
        .input("a", &StressTotal::in)
        .output("out", &StressTotal::out)
        .param("most", &Params::most, "How many.");
    describe_trouble(about);
  }
  void run(Context&) override {
    Steps steps(params);
    Number total;
    for (std::int64_t i = 0; i < params.most; ++i) {
      steps.step();
      const auto number = in.next();
      if (!number) break;
      total.value += number->value;
    }
    out.set(total);
  }
};

/// Waits for `b`, then adds it to all of `a`.
class StressLate final : public Stage {
 public:
  struct Params : Trouble {
  } params;
  In<Number> a;
  InValue<Number> b;
  Out<Number> out;
  static void describe(About<StressLate>& about) {
    about.summary("Late.")
        .input("a", &StressLate::a)
        .input("b", &StressLate::b)
        .output("out", &StressLate::out);
    describe_trouble(about);
  }
  void run(Context&) override {
    Steps steps(params);
    const std::int64_t more = b.get().value;
    while (const auto number = a.next()) {
      steps.step();
      out.put(number.stamp(), {number->value + more}, number.index());
    }
  }
};

/// a + 2 b, as a map.
class StressAdd final : public Map<Number(Number, Number)> {
 public:
  struct Params : Trouble {
  } params;
  static void describe(About<StressAdd>& about) {
    about.summary("Adds.").ports("a", "b", "out");
    describe_trouble(about);
  }
  Number apply(const Number& a, const Number& b, Context& context) const {
    if (params.fail_at && a.value % 16 == *params.fail_at % 16) throw Error("broken on purpose");
    const std::uint64_t dice = context.random().below(16);
    if (dice == 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
    return {a.value + 2 * b.value};
  }
};

}  // namespace stope::toy
