#pragma once

#include <memory>
#include <vector>

#include "framework/executor/process.hpp"
#include "framework/executor/run.hpp"

namespace stope {

/// The processes and channels that a plan stands for.
class Network {
 public:
  /// Makes and wires everything. Throws Error if a stage cannot be made.
  Network(const Plan& plan, const Catalogue& catalogue, const std::vector<Sink>& sinks,
          std::size_t channel_capacity, const RunServices& services);

  /// Starts every process and waits for all to end.
  void run(RunState& state);

  RunProgress progress() const;
  void record(RunRecord& record) const;

 private:
  void add_stage(const PlannedStage& stage, const Catalogue& catalogue,
                 const RunServices& services);
  void connect(const Plan& plan, const PlannedSource& source, Process& reader, InputEnd& input,
               const std::string& reader_name, std::size_t capacity);

  std::vector<std::unique_ptr<Process>> processes_;  ///< stages in the plan's order, then sinks
  std::vector<std::unique_ptr<Channel>> channels_;
};

}  // namespace stope
