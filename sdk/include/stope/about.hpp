#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "stope/ports.hpp"
#include "stope/stage.hpp"
#include "stope/stage_info.hpp"

namespace stope {

namespace traits {

template <class T>
struct MapInput {
  using Value = T;
  static constexpr bool kRequired = true;
};
template <class T>
struct MapInput<Optional<T>> {
  using Value = T;
  static constexpr bool kRequired = false;
};

template <class T>
PortInfo port_info(std::string name, bool stream, bool required, std::string doc) {
  return {std::move(name), std::string(T::kType), layout_hash<T>(), stream,
          required,        std::move(doc)};
}

}  // namespace traits

/// How to fill a stage's members, gathered from its declaration beside the StageInfo.
template <class S>
struct Bindings {
  std::vector<std::function<void(S&, const ParameterValue&)>>
      parameters;                                             ///< as StageInfo::parameters
  std::vector<std::function<void(S&, InputPort*)>> inputs;    ///< as StageInfo::inputs
  std::vector<std::function<void(S&, OutputPort*)>> outputs;  ///< as StageInfo::outputs
  std::vector<const PayloadType*> output_types;               ///< as StageInfo::outputs
};

/// What a stage's `static void describe(About<S>& about)` talks to. Every port and parameter is
/// declared here, once.
template <class S>
class About {
 public:
  About(StageInfo& info, Bindings<S>& bindings) : info_(info), bindings_(bindings) {}

  /// What the stage does, in one sentence.
  About& summary(std::string sentence) { return info_.summary = std::move(sentence), *this; }
  /// Where the method comes from: paper and section.
  About& from(std::string source) { return info_.source = std::move(source), *this; }
  /// What a user must know before choosing it: limits, when another member is better.
  About& notes(std::string text) { return info_.notes = std::move(text), *this; }
  /// Same inputs may give other bytes: outputs are not reused.
  About& nondeterministic() { return info_.deterministic = false, *this; }
  /// A sensor, or a recording replayed at its own pace.
  About& live() { return info_.live = true, *this; }
  /// Of an export (a Map to Artefact): the file endings it writes, without the dot.
  About& writes(std::vector<std::string> extensions) {
    return info_.extensions = std::move(extensions), *this;
  }

  /// Of a Map that keeps something of earlier items to be faster at the next, never different: it
  /// is given one item at a time, in order. What it keeps is a mutable member.
  About& in_order() {
    static_assert(S::kMap, "in_order() is for a Map; a Stage reads its inputs in order anyway");
    return info_.in_order = true, *this;
  }

  /// Of a Map: the names of its inputs in the order of its signature, then of its outputs.
  template <class... Names>
  About& ports(Names... names) {
    static_assert(S::kMap, "ports() is for a Map; a Stage declares each with input() and output()");
    using Inputs = typename S::InputTypes;
    using Outputs = typename S::OutputTypes;
    constexpr std::size_t kInputs = std::tuple_size_v<Inputs>;
    constexpr std::size_t kOutputs = std::tuple_size_v<Outputs>;
    static_assert(sizeof...(Names) == kInputs + kOutputs,
                  "one name for each input, then one for each output");
    if (info_.map) throw Error("describe() calls ports() more than once");
    const std::vector<std::string> list{std::string(names)...};
    info_.map = true;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (info_.inputs.push_back(
           traits::port_info<typename traits::MapInput<std::tuple_element_t<I, Inputs>>::Value>(
               list[I], true, traits::MapInput<std::tuple_element_t<I, Inputs>>::kRequired, "")),
       ...);
    }
    (std::make_index_sequence<kInputs>());
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (info_.outputs.push_back(
           traits::port_info<std::tuple_element_t<I, Outputs>>(list[kInputs + I], true, true, "")),
       ...);
      (bindings_.output_types.push_back(&payload_type<std::tuple_element_t<I, Outputs>>()), ...);
    }
    (std::make_index_sequence<kOutputs>());
    return *this;
  }

  /// Of a Stage: an input that must be wired. `port` is a member of type In or InValue.
  template <class Port>
  About& input(std::string name, Port S::*port, std::string doc = "") {
    return add_input(std::move(name), port, true, std::move(doc));
  }
  /// Of a Stage: an input that may be left unwired.
  template <class Port>
  About& optional_input(std::string name, Port S::*port, std::string doc = "") {
    return add_input(std::move(name), port, false, std::move(doc));
  }
  /// Of a Stage: an output. `port` is a member of type Out or OutValue.
  template <class Port>
  About& output(std::string name, Port S::*port, std::string doc = "") {
    info_.outputs.push_back(traits::port_info<typename Port::Value>(std::move(name), Port::kStream,
                                                                    true, std::move(doc)));
    bindings_.output_types.push_back(&payload_type<typename Port::Value>());
    bindings_.outputs.push_back([port](S& stage, OutputPort* end) { (stage.*port).connect(end); });
    return *this;
  }

  /// A parameter: a member of S::Params, whose initial value is the default, with its unit, limits
  /// and one sentence.
  template <class Params, class Member>
  About& param(std::string name, Member Params::*member, std::string unit, Limits limits,
               std::string doc) {
    using Traits = ParameterTraits<Member>;
    info_.parameters.push_back({std::move(name), Traits::kind(), Traits::kOptional,
                                Traits::to_value(Params{}.*member), std::move(unit),
                                Traits::implied_limits() + limits, std::move(doc)});
    bindings_.parameters.push_back([member](S& stage, const ParameterValue& value) {
      Traits::assign(stage.params.*member, value);
    });
    return *this;
  }
  /// A parameter without a unit.
  template <class Params, class Member>
  About& param(std::string name, Member Params::*member, Limits limits, std::string doc) {
    return param(std::move(name), member, "", std::move(limits), std::move(doc));
  }
  /// A parameter with neither unit nor limits.
  template <class Params, class Member>
  About& param(std::string name, Member Params::*member, std::string doc) {
    return param(std::move(name), member, "", any(), std::move(doc));
  }

 private:
  template <class Port>
  About& add_input(std::string name, Port S::*port, bool required, std::string doc) {
    info_.inputs.push_back(traits::port_info<typename Port::Value>(std::move(name), Port::kStream,
                                                                   required, std::move(doc)));
    bindings_.inputs.push_back([port](S& stage, InputPort* end) { (stage.*port).connect(end); });
    return *this;
  }

  StageInfo& info_;
  Bindings<S>& bindings_;
};

}  // namespace stope
