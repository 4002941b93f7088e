#pragma once

#include <concepts>
#include <filesystem>
#include <optional>
#include <tuple>
#include <vector>

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

/// A stage, or Map, that reads more files than its parameters of type std::filesystem::path name,
/// such as the picture that a map's yaml names:
///
///     std::vector<std::filesystem::path> also_reads() const;
///
/// gives the others, files or whole folders, for the parameters it has been given. The framework
/// asks before it runs the stage, or without running it, to tell by their content whether what it
/// gave before still holds. One that is not there is given like any other; throw Error where it
/// cannot be told, and run() will say what is wrong.
template <class S>
concept AlsoReads = requires(const S& stage) {
  { stage.also_reads() } -> std::same_as<std::vector<std::filesystem::path>>;
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
