#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "framework/executor/channel.hpp"
#include "framework/executor/payload_store.hpp"
#include "stope/ports.hpp"

namespace stope {

/// A process's end of an output: writes each item to every channel that starts here. Keeps the
/// promises of a stream: stamps never decrease, indices increase, a value is given once.
class OutputEnd final : public OutputPort {
 public:
  OutputEnd(Process& process, PayloadStore& store, const PayloadType& type, std::string name,
            bool stream);
  void wire(Channel& channel);

  const std::string& name() const { return name_; }
  bool stream() const { return stream_; }

  bool wanted() const override { return !channels_.empty(); }
  void put(Stamp stamp, std::optional<std::uint64_t> index,
           std::shared_ptr<const void> value) override;
  void put_lazy(Stamp stamp, std::optional<std::uint64_t> index, PayloadLoader load,
                std::size_t bytes) override;
  /// Makes a payload for this output. From any thread.
  std::shared_ptr<RunPayload> make_payload(std::shared_ptr<const void> value);
  /// Writes a payload made before.
  void put(Stamp stamp, std::uint64_t index, std::shared_ptr<RunPayload> payload);

  /// Whether it is wired and everyone who reads it has left.
  bool abandoned() const;
  /// Whether anything was put.
  bool given() const { return last_index_.has_value(); }
  /// The last item, for messages. Of an output that was given one.
  std::string last_text() const;
  /// There will be no more items.
  void close();
  /// The same, and some are missing.
  void break_off();
  std::uint64_t items() const { return items_.load(std::memory_order_relaxed); }

 private:
  std::uint64_t check(Stamp stamp, std::optional<std::uint64_t> index);
  void send(Stamp stamp, std::uint64_t index, std::shared_ptr<RunPayload> payload);

  Process& process_;
  PayloadStore& store_;
  Shelf& shelf_;
  const PayloadType& type_;
  std::string name_;
  bool stream_;
  std::vector<Channel*> channels_;
  Stamp last_stamp_ = 0;
  std::optional<std::uint64_t> last_index_;
  std::atomic<std::uint64_t> items_{0};
};

}  // namespace stope
