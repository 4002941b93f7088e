#include "framework/executor/network.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "framework/executor/map_process.hpp"
#include "framework/executor/sink_process.hpp"
#include "framework/executor/stage_process.hpp"

namespace stope {

Network::Network(const Plan& plan, const Catalogue& catalogue, const std::vector<Sink>& sinks,
                 std::size_t channel_capacity, const RunServices& services) {
  for (const PlannedStage& stage : plan.stages) {
    try {
      add_stage(stage, catalogue, services);
    } catch (const Error& error) {
      services.state.fail(stage.name,
                          fmt::format("stage \"{}\" cannot be made: {}", stage.name, error.what()));
      throw;
    }
  }
  for (const Sink& sink : sinks)
    processes_.push_back(std::make_unique<SinkProcess>(sink, services));

  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    const PlannedStage& stage = plan.stages[i];
    for (std::size_t port = 0; port < stage.inputs.size(); ++port) {
      if (!stage.inputs[port]) continue;
      connect(plan, *stage.inputs[port], *processes_[i], *processes_[i]->inputs()[port],
              stage.name + "." + stage.info.inputs[port].name, channel_capacity);
    }
  }
  for (std::size_t i = 0; i < sinks.size(); ++i) {
    Process& process = *processes_[plan.stages.size() + i];
    connect(plan, sinks[i].source, process, *process.inputs()[0], sinks[i].name, channel_capacity);
  }
}

void Network::add_stage(const PlannedStage& stage, const Catalogue& catalogue,
                        const RunServices& services) {
  std::unique_ptr<StageInstance> made = catalogue.create(stage.info.id);
  StageInstance& instance = *made;
  for (std::size_t i = 0; i < stage.parameters.size(); ++i) {
    const Outcome set = instance.set_parameter(i, stage.parameters[i]);
    if (!set)
      throw Error(fmt::format("parameter \"{}\" cannot be set: {}", stage.info.parameters[i].name,
                              set.sentence));
  }
  std::unique_ptr<Process> process;
  if (stage.info.map) {
    process = std::make_unique<MapProcess>(stage, services, std::move(made));
  } else {
    process = std::make_unique<StageProcess>(stage, services, std::move(made));
  }
  for (std::size_t port = 0; port < stage.info.inputs.size(); ++port)
    process->inputs().push_back(std::make_unique<InputEnd>(*process));
  for (std::size_t port = 0; port < stage.info.outputs.size(); ++port)
    process->outputs().push_back(
        std::make_unique<OutputEnd>(*process, services.store, instance.output_type(port),
                                    stage.info.outputs[port].name, stage.streams[port]));
  processes_.push_back(std::move(process));
}

void Network::connect(const Plan& plan, const PlannedSource& source, Process& reader,
                      InputEnd& input, const std::string& reader_name, std::size_t capacity) {
  const PlannedStage& stage = plan.stages[source.stage];
  Process& writer = *processes_[source.stage];
  channels_.push_back(
      std::make_unique<Channel>(stage.name + "." + stage.info.outputs[source.port].name,
                                reader_name, capacity, writer, reader));
  writer.outputs()[source.port]->wire(*channels_.back());
  input.wire(*channels_.back(), stage.streams[source.port]);
}

void Network::run(RunState& state) {
  try {
    for (const auto& process : processes_) process->start();
  } catch (const std::system_error& error) {
    state.fail("", fmt::format("the machine gives no more threads ({} processes are needed): {}",
                               processes_.size(), error.what()));
  }
  for (const auto& process : processes_) process->join();
}

RunProgress Network::progress() const {
  RunProgress progress;
  for (const auto& process : processes_)
    progress.processes.push_back({process->name(), process->items_read(), process->items_written(),
                                  process->fraction(), process->finished()});
  return progress;
}

void Network::record(RunRecord& record) const {
  for (const auto& process : processes_) record.processes.push_back(process->record());
  for (const auto& channel : channels_) record.channels.push_back(channel->record());
}

}  // namespace stope
