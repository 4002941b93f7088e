// Problem: put stages in an order in which each follows what it reads, and name the cycles if there
// are any. Idea: Kahn's algorithm, taking the first ready stage as written each time; what is left
// over holds a cycle, which walking backwards along wires must run into. Cost: stages times wires.
#include "framework/pipeline/graph_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <queue>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

class Order {
 public:
  Order(const std::vector<StageDraft>& drafts, Diagnostics& diagnostics)
      : drafts_(drafts),
        diagnostics_(diagnostics),
        waits_for_(drafts.size(), 0),
        readers_(drafts.size()),
        taken_(drafts.size(), false) {
    for (std::size_t i = 0; i < drafts.size(); ++i)
      for (const auto& input : drafts[i].inputs)
        if (input) {
          ++waits_for_[i];
          readers_[input->stage].push_back(i);
        }
  }

  std::vector<std::size_t> find() {
    std::priority_queue<std::size_t, std::vector<std::size_t>, std::greater<>> ready;
    for (std::size_t i = 0; i < drafts_.size(); ++i)
      if (waits_for_[i] == 0) ready.push(i);
    std::vector<std::size_t> order;
    while (!ready.empty()) {
      const std::size_t stage = ready.top();
      ready.pop();
      order.push_back(stage);
      taken_[stage] = true;
      for (const std::size_t reader : readers_[stage])
        if (--waits_for_[reader] == 0) ready.push(reader);
    }
    report_cycles();
    return order;
  }

 private:
  // Every stage left over waits for another one left over: going back from it must come round.
  void report_cycles() {
    std::vector<int> visited(drafts_.size(), 0);
    int walk = 0;
    for (std::size_t begin = 0; begin < drafts_.size(); ++begin) {
      if (taken_[begin] || visited[begin] != 0) continue;
      ++walk;
      std::size_t stage = begin;
      while (visited[stage] == 0) {
        visited[stage] = walk;
        stage = producer_left_over(stage)->stage;
      }
      if (visited[stage] == walk) report_cycle(stage);
    }
  }

  const PlannedSource* producer_left_over(std::size_t stage) const {
    for (const auto& input : drafts_[stage].inputs)
      if (input && !taken_[input->stage]) return &*input;
    return nullptr;
  }

  void report_cycle(std::size_t stage) {
    std::vector<std::size_t> cycle{stage};
    while (producer_left_over(cycle.back())->stage != stage)
      cycle.push_back(producer_left_over(cycle.back())->stage);
    // Data flows the other way; begin with what stands first in the file.
    std::reverse(cycle.begin(), cycle.end());
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    std::string chain;
    for (const std::size_t i : cycle) chain.append(drafts_[i].name).append(" -> ");
    const StageDraft& first = drafts_[cycle[0]];
    const PlannedSource* wire = producer_left_over(cycle[0]);
    Place place = first.place;
    for (std::size_t i = 0; i < first.inputs.size(); ++i)
      if (first.inputs[i] && &*first.inputs[i] == wire) place = first.input_places[i];
    diagnostics_.error(code::kCycle, place,
                       cycle.size() == 1 ? fmt::format("{} reads its own output.", first.subject())
                                         : fmt::format("These stages wait for one another: {}{}.",
                                                       chain, first.name),
                       "Data flows one way: corrections travel downstream as data of their own.");
  }

  const std::vector<StageDraft>& drafts_;
  Diagnostics& diagnostics_;
  std::vector<std::size_t> waits_for_;
  std::vector<std::vector<std::size_t>> readers_;
  std::vector<bool> taken_;
};

void report_stream(const StageDraft& reader, std::size_t input,
                   const std::vector<StageDraft>& drafts, Diagnostics& diagnostics) {
  const PortInfo& to = reader.record->info.inputs[input];
  const StageDraft& producer = drafts[reader.inputs[input]->stage];
  const PortInfo& from = producer.record->info.outputs[reader.inputs[input]->port];
  std::vector<std::string> values;
  for (const StageDraft& draft : drafts) {
    if (!draft.record || &draft == &reader || draft.is_export) continue;
    for (std::size_t i = 0; i < draft.streams.size(); ++i)
      if (!draft.streams[i] && draft.record->info.outputs[i].type == to.type)
        values.push_back(draft.name + "." + draft.record->info.outputs[i].name);
  }
  diagnostics.error(code::kStreamIntoValue, reader.input_places[input],
                    fmt::format("{} takes one value as '{}', but '{}.{}' is a stream of many.",
                                reader.subject(), to.name, producer.name, from.name),
                    values.empty()
                        ? "Put a stage between them that makes one value of a stream."
                        : fmt::format("Single values of that type: {}.", quoted_list(values)));
}

}  // namespace

std::vector<std::size_t> order_stages(const std::vector<StageDraft>& drafts,
                                      Diagnostics& diagnostics) {
  return Order(drafts, diagnostics).find();
}

void find_streams(std::vector<StageDraft>& drafts, const std::vector<std::size_t>& order,
                  Diagnostics& diagnostics) {
  std::vector<std::pair<std::size_t, std::size_t>> wrong;
  for (const std::size_t stage : order) {
    StageDraft& draft = drafts[stage];
    if (!draft.record) continue;
    const StageInfo& info = draft.record->info;
    bool fed_by_stream = false;
    for (std::size_t i = 0; i < draft.inputs.size(); ++i) {
      if (!draft.inputs[i]) continue;
      const bool stream = drafts[draft.inputs[i]->stage].streams[draft.inputs[i]->port];
      fed_by_stream = fed_by_stream || stream;
      if (stream && !info.map && !info.inputs[i].stream) wrong.emplace_back(stage, i);
    }
    for (const PortInfo& output : info.outputs)
      draft.streams.push_back(info.map ? fed_by_stream : output.stream);
  }
  for (const auto& [stage, input] : wrong) report_stream(drafts[stage], input, drafts, diagnostics);
}

}  // namespace stope
