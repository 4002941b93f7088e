#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "stope/about.hpp"

namespace stope {

/// How a call into a plugin ended. Exceptions are turned into it at the plugin's own edge.
struct Outcome {
  enum class Kind : int { kDone, kCancelled, kFailed } kind = Kind::kDone;
  std::string sentence;  ///< what went wrong, if it failed
  explicit operator bool() const { return kind == Kind::kDone; }
};

/// A stage made and ready to be wired, as the framework sees it.
class StageInstance {
 public:
  virtual ~StageInstance() = default;
  virtual const StageInfo& info() const noexcept = 0;
  /// By place in info().parameters. The value's alternative must be the one the parameter's kind
  /// asks for.
  virtual Outcome set_parameter(std::size_t place, const ParameterValue& value) noexcept = 0;
  /// By place in info().inputs or outputs. Not for a Map.
  virtual void connect_input(std::size_t place, InputPort* port) noexcept = 0;
  virtual void connect_output(std::size_t place, OutputPort* port) noexcept = 0;
  virtual const PayloadType& output_type(std::size_t place) const noexcept = 0;
  /// Runs a Stage to its end.
  virtual Outcome run(Context& context) noexcept = 0;
  /// Applies a Map to one item of each input, in the order of info().inputs; an empty item where
  /// nothing is wired. Fills `outputs`, in the order of info().outputs.
  virtual Outcome apply(std::span<const AnyItem> inputs, Context& context,
                        std::span<std::shared_ptr<const void>> outputs) const noexcept = 0;
  /// Fills `paths` with the files and folders it reads besides those its parameters name. Called
  /// after set_parameter(), before or instead of run().
  virtual Outcome also_reads(std::vector<std::filesystem::path>& paths) const noexcept = 0;
};

/// Calls `work` and turns what it throws into an Outcome.
template <class Work>
Outcome guarded(Work&& work) noexcept {
  try {
    std::forward<Work>(work)();
    return {};
  } catch (const Cancelled&) {
    return {Outcome::Kind::kCancelled, {}};
  } catch (const std::bad_alloc&) {
    return {Outcome::Kind::kFailed, "there was not enough memory"};
  } catch (const std::exception& error) {
    return {Outcome::Kind::kFailed, error.what()};
  } catch (...) {
    return {Outcome::Kind::kFailed, "something that is not a std::exception was thrown"};
  }
}

/// Fills `info` and `bindings` from the declaration of a stage class S.
template <class S>
void describe_stage(StageInfo& info, Bindings<S>& bindings) {
  About<S> about(info, bindings);
  S::describe(about);
  info.also_reads = AlsoReads<S>;
}

/// The StageInstance of a stage class S. Compiled into the plugin.
template <class S>
class InstanceOf final : public StageInstance {
 public:
  explicit InstanceOf(std::string id) {
    info_.id = std::move(id);
    describe_stage(info_, bindings_);
  }
  const StageInfo& info() const noexcept override { return info_; }
  Outcome set_parameter(std::size_t place, const ParameterValue& value) noexcept override {
    return guarded([&] { bindings_.parameters.at(place)(stage_, value); });
  }
  void connect_input(std::size_t place, InputPort* port) noexcept override {
    bindings_.inputs[place](stage_, port);
  }
  void connect_output(std::size_t place, OutputPort* port) noexcept override {
    bindings_.outputs[place](stage_, port);
  }
  const PayloadType& output_type(std::size_t place) const noexcept override {
    return *bindings_.output_types[place];
  }

  Outcome run([[maybe_unused]] Context& context) noexcept override {
    if constexpr (S::kMap) {
      return {Outcome::Kind::kFailed, "a Map is applied, not run"};
    } else {
      return guarded([&] { stage_.run(context); });
    }
  }

  Outcome apply(
      [[maybe_unused]] std::span<const AnyItem> inputs, [[maybe_unused]] Context& context,
      [[maybe_unused]] std::span<std::shared_ptr<const void>> outputs) const noexcept override {
    if constexpr (S::kMap) {
      return guarded([&] {
        using Inputs = typename S::InputTypes;
        [&]<std::size_t... I>(std::index_sequence<I...>) {
          // Held in one tuple so that each payload stays in memory until apply() returns.
          const std::tuple items{Item<Element<I, Inputs>>(inputs[I])...};
          share(stage_.apply(argument<std::tuple_element_t<I, Inputs>>(std::get<I>(items))...,
                             context),
                outputs);
        }
        (std::make_index_sequence<std::tuple_size_v<Inputs>>());
      });
    } else {
      return {Outcome::Kind::kFailed, "a Stage is run, not applied"};
    }
  }

  Outcome also_reads(
      [[maybe_unused]] std::vector<std::filesystem::path>& paths) const noexcept override {
    if constexpr (AlsoReads<S>) {
      return guarded([&] { paths = stage_.also_reads(); });
    } else {
      return {};
    }
  }

 private:
  template <std::size_t I, class Inputs>
  using Element = typename traits::MapInput<std::tuple_element_t<I, Inputs>>::Value;

  template <class Declared, class T>
  static decltype(auto) argument(const Item<T>& item) {
    if constexpr (std::is_same_v<Declared, T>) {
      return *item;
    } else {
      return Declared(item ? &*item : nullptr);
    }
  }

  template <class... Values>
  static void share(std::tuple<Values...> values, std::span<std::shared_ptr<const void>> outputs) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      ((outputs[I] = std::make_shared<const Values>(std::move(std::get<I>(values)))), ...);
    }
    (std::index_sequence_for<Values...>());
  }
  template <class Value>
  static void share(Value value, std::span<std::shared_ptr<const void>> outputs) {
    outputs[0] = std::make_shared<const Value>(std::move(value));
  }

  StageInfo info_;
  Bindings<S> bindings_;
  S stage_;
};

/// What a plugin says of one stage.
struct StageEntry {
  const char* id;
  /// Fills `info` from the declaration, without making the stage.
  Outcome (*describe)(StageInfo& info) noexcept;
  /// Makes the stage with its default parameters.
  Outcome (*create)(std::unique_ptr<StageInstance>& instance) noexcept;
};

template <class S>
StageEntry stage_entry(const char* id) {
  static const char* const kId = id;
  return {id,
          [](StageInfo& info) noexcept {
            return guarded([&] {
              info = {};
              info.id = kId;
              Bindings<S> bindings;
              describe_stage(info, bindings);
            });
          },
          [](std::unique_ptr<StageInstance>& instance) noexcept {
            return guarded([&] { instance = std::make_unique<InstanceOf<S>>(kId); });
          }};
}

}  // namespace stope

/// Exports the stage class `Class` under the id `"family/name"`. Goes in the stage's .cpp, at
/// namespace scope. The name of the class, in snake_case, is what stope_add_plugin(… STAGES …)
/// lists.
#define STOPE_STAGE(Class, id)                                                \
  extern "C" const ::stope::StageEntry* stope_stage_##Class() {               \
    static const ::stope::StageEntry entry = ::stope::stage_entry<Class>(id); \
    return &entry;                                                            \
  }
