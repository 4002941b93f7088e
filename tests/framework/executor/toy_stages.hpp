#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "stope/stope.hpp"

/// Small stages over a small payload, from which tests build networks.
namespace stope::toy {

struct Number {
  static constexpr std::string_view kType = "toy/Number@1";
  std::int64_t value = 0;
  static constexpr void fields(auto& s, auto&& visit) { visit("value", s.value); }
};

/// Writes 0, 1, … count - 1, stamped 10, 20, …; forever if count < 0. Fails before `fail_at`.
class Count final : public Stage {
 public:
  struct Params {
    std::int64_t count = 10;
    std::optional<std::int64_t> fail_at;
    std::int64_t pause_us = 0;
  } params;
  Out<Number> numbers;
  static void describe(About<Count>& about) {
    about.summary("Counts.")
        .output("numbers", &Count::numbers)
        .param("count", &Params::count, "How many; forever if negative.")
        .param("fail_at", &Params::fail_at, "Where to fail.")
        .param("pause_us", &Params::pause_us, "Pause before each.");
  }
  void run(Context& context) override {
    for (std::int64_t i = 0; params.count < 0 || i < params.count; ++i) {
      if (params.fail_at == i) throw Error("the counter broke");
      if (params.pause_us > 0)
        std::this_thread::sleep_for(std::chrono::microseconds(params.pause_us));
      numbers.put(10 * (i + 1), {i});
      if (params.count > 0) context.progress(double(i + 1) / double(params.count));
    }
  }
};

/// Gives the sum of its numbers at the end: a value that takes the whole stream.
class Sum final : public Stage {
 public:
  struct Params {
    std::optional<std::int64_t> most;
  } params;
  In<Number> numbers;
  OutValue<Number> sum;
  static void describe(About<Sum>& about) {
    about.summary("Sums.")
        .input("numbers", &Sum::numbers)
        .output("sum", &Sum::sum)
        .param("most", &Params::most, "Numbers to read; all if unset.");
  }
  void run(Context&) override {
    Number total;
    for (std::int64_t i = 0; !params.most || i < *params.most; ++i) {
      const auto number = numbers.next();
      if (!number) break;
      total.value += number->value;
    }
    sum.set(total);
  }
};

/// Waits for the offset, then adds it to each number: reads the stream late.
class AddLater final : public Stage {
 public:
  struct Params {
  } params;
  InValue<Number> offset;
  In<Number> numbers;
  Out<Number> sums;
  static void describe(About<AddLater>& about) {
    about.summary("Adds a value to a stream, once it has the value.")
        .input("offset", &AddLater::offset)
        .input("numbers", &AddLater::numbers)
        .output("sums", &AddLater::sums);
  }
  void run(Context&) override {
    const std::int64_t more = offset.get().value;
    while (const auto number = numbers.next())
      sums.put(number.stamp(), {number->value + more}, number.index());
  }
};

/// Passes every number on, one after the other.
class Pass final : public Stage {
 public:
  struct Params {
  } params;
  In<Number> numbers;
  Out<Number> same;
  static void describe(About<Pass>& about) {
    about.summary("Passes on.").input("numbers", &Pass::numbers).output("same", &Pass::same);
  }
  void run(Context&) override {
    while (const auto number = numbers.next())
      same.put(number.stamp(), number.share(), number.index());
  }
};

/// Squares as a map. Slower for some numbers, so that they finish out of order.
class Square final : public Map<Number(Number)> {
 public:
  struct Params {
    std::optional<std::int64_t> fail_at;
    std::int64_t pause_us = 0;
    bool seeded = false;
  } params;
  static void describe(About<Square>& about) {
    about.summary("Squares.")
        .ports("number", "square")
        .param("fail_at", &Params::fail_at, "Fails from this number on.")
        .param("pause_us", &Params::pause_us, "Longest pause.")
        .param("seeded", &Params::seeded, "Gives the seed instead.");
  }
  Number apply(const Number& number, Context& context) const {
    if (params.pause_us > 0)
      std::this_thread::sleep_for(
          std::chrono::microseconds(params.pause_us * (1 + number.value * 7 % 5) / 5));
    if (params.fail_at && number.value >= *params.fail_at)
      throw Error("cannot square " + std::to_string(number.value));
    if (params.seeded) return {static_cast<std::int64_t>(context.seed())};
    return {number.value * number.value};
  }
};

/// Adds two inputs as a map; the second may be left unwired.
class Add final : public Map<Number(Number, Optional<Number>)> {
 public:
  struct Params {
  } params;
  static void describe(About<Add>& about) { about.summary("Adds.").ports("a", "b", "sum"); }
  Number apply(const Number& a, const Optional<Number>& b, Context&) const {
    return {a.value + (b ? b->value : 0)};
  }
};

}  // namespace stope::toy
