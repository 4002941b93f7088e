#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "framework/executor/doorbell.hpp"
#include "framework/executor/input_end.hpp"
#include "framework/executor/output_end.hpp"
#include "framework/executor/patience.hpp"
#include "framework/executor/run_services.hpp"
#include "framework/executor/trace.hpp"
#include "stope/stage_instance.hpp"

namespace stope {

/// A sequential process of the network, with a thread of its own: reads its inputs, writes its
/// outputs, sleeps when it can do neither.
class Process {
 public:
  Process(std::string name, const RunServices& services);
  virtual ~Process() = default;
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  const std::string& name() const { return name_; }
  Doorbell& doorbell() { return *doorbell_; }
  Trace& trace() { return trace_; }
  bool stopping() const { return state_.stopping(); }

  /// One end for each port of the stage, in its order. Unwired inputs have an end too.
  std::vector<std::unique_ptr<InputEnd>>& inputs() { return inputs_; }
  std::vector<std::unique_ptr<OutputEnd>>& outputs() { return outputs_; }

  /// Starts the thread. Once everything is wired.
  void start();
  /// Waits for the thread to end.
  void join();

  /// Of its own thread: sleeps until the channel can be read or written. Throws Cancelled when the
  /// run stops.
  void wait_to_read(Channel& channel);
  void wait_to_write(Channel& channel);
  /// Of its own thread: everyone who could read what it writes has left, or what it reads was
  /// broken off. Ends it; that is no failure of its own.
  [[noreturn]] void give_up();

  /// Where it waits, for the WaitGraph.
  std::atomic<Channel*>& waits_at() { return waits_at_; }
  const std::atomic<Channel*>& waits_at() const { return waits_at_; }

  /// The item it is at, for messages.
  void set_item(const AnyItem& item);
  std::string item_text() const;

  std::uint64_t items_read() const;
  std::uint64_t items_written() const;
  bool finished() const { return finished_.load(); }
  double fraction() const { return fraction_.load(); }
  void set_fraction(double fraction) { fraction_.store(fraction); }

  /// After join().
  ProcessRecord record() const;

 protected:
  /// The process's life. What it throws is turned into an outcome.
  virtual Outcome work() = 0;
  /// Nanoseconds of work done elsewhere in its name.
  virtual std::int64_t work_elsewhere() const { return 0; }
  /// Of its own thread, when its life is over: lets go of payloads it still holds.
  virtual void release() {}

  /// Tells the run of an error, in a sentence that names the stage and `where`, such as `at item 3
  /// (1.200 s)`.
  void fail(const std::string& where, const std::string& what);
  /// Wakes the writers of its inputs that wait for half empty channels. Before any sleep.
  void wake_writers();
  const std::shared_ptr<Doorbell>& shared_doorbell() const { return doorbell_; }

 private:
  void live();
  void settle(const Outcome& outcome);
  /// Whether it did all it was there for; tells if it failed.
  bool succeeded(const Outcome& outcome);
  /// Where it is, for its errors: at the item it read, or after the one it wrote.
  std::string place_text() const;

  std::string name_;
  RunState& state_;
  WaitGraph& waits_;
  Trace trace_;
  std::shared_ptr<Doorbell> doorbell_ = std::make_shared<Doorbell>();
  Patience patience_;
  std::vector<std::unique_ptr<InputEnd>> inputs_;
  std::vector<std::unique_ptr<OutputEnd>> outputs_;
  std::atomic<Channel*> waits_at_{nullptr};
  std::atomic<Stamp> item_stamp_{0};
  std::atomic<std::uint64_t> item_index_{0};
  std::atomic<bool> has_item_{false}, finished_{false};
  std::atomic<double> fraction_{-1.0};
  bool gave_up_ = false;
  std::thread thread_;
};

}  // namespace stope
