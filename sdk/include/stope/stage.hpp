#pragma once

#include <optional>
#include <tuple>

#include "stope/context.hpp"
#include "stope/ports.hpp"

namespace stope {

/// A sequential process: reads its inputs and writes its outputs in a loop of its own. Derive from
/// it, declare ports as members (In, InValue, Out, OutValue), parameters in `struct Params {…}
/// params;`, both once more in describe().
class Stage {
 public:
  static constexpr bool kMap = false;
  virtual ~Stage() = default;
  /// Does the work. May return before its inputs end; the rest is discarded. Throw Error to stop
  /// the run.
  virtual void run(Context& context) = 0;
};

template <class Signature>
class Map;

/// What a Map with more than one output gives: Map<Outputs<RoadGraph, RegionMap>(OccupancyGrid)>,
/// whose apply() returns std::tuple<RoadGraph, RegionMap>.
template <PayloadStruct... Values>
struct Outputs {};

/// A pure function of one item from each input, which the framework calls for several items at
/// once. `Inputs` are payload structs or Optional of them; streams among them are read in step and
/// must carry equal stamps.
template <PayloadStruct Output, class... Inputs>
class Map<Output(Inputs...)> {
 public:
  static constexpr bool kMap = true;
  using OutputTypes = std::tuple<Output>;
  using InputTypes = std::tuple<Inputs...>;
  virtual ~Map() = default;
};

template <PayloadStruct... Values, class... Inputs>
class Map<Outputs<Values...>(Inputs...)> {
 public:
  static constexpr bool kMap = true;
  using OutputTypes = std::tuple<Values...>;
  using InputTypes = std::tuple<Inputs...>;
  virtual ~Map() = default;
};

}  // namespace stope
