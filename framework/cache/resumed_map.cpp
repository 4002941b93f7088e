#include "framework/cache/resumed_map.hpp"

#include <utility>

#include "stope/context.hpp"

namespace stope {
namespace {

class ResumedMap final : public StageInstance {
 public:
  ResumedMap(std::unique_ptr<StageInstance> original, MadeItems made, ObjectStore& store)
      : original_(std::move(original)), made_(std::move(made)), store_(store) {}

  const StageInfo& info() const noexcept override { return original_->info(); }
  Outcome set_parameter(std::size_t place, const ParameterValue& value) noexcept override {
    return original_->set_parameter(place, value);
  }
  void connect_input(std::size_t place, InputPort* port) noexcept override {
    original_->connect_input(place, port);
  }
  void connect_output(std::size_t place, OutputPort* port) noexcept override {
    original_->connect_output(place, port);
  }
  const PayloadType& output_type(std::size_t place) const noexcept override {
    return original_->output_type(place);
  }
  Outcome run(Context& context) noexcept override { return original_->run(context); }
  Outcome apply(std::span<const AnyItem> inputs, Context& context,
                std::span<std::shared_ptr<const void>> outputs) const noexcept override {
    bool taken = false;
    // What cannot be taken is computed, whatever the reason.
    const Outcome ignored = guarded([&] { taken = take(context.index(), outputs); });
    if (ignored && taken) return {};
    return original_->apply(inputs, context, outputs);
  }
  Outcome also_reads(std::vector<std::filesystem::path>& paths) const noexcept override {
    return original_->also_reads(paths);
  }

 private:
  bool take(std::uint64_t index, std::span<std::shared_ptr<const void>> outputs) const {
    for (std::size_t port = 0; port < outputs.size(); ++port) {
      const auto item = made_[port].find(index);
      if (item == made_[port].end()) return false;
      const PayloadType& type = original_->output_type(port);
      if (!store_.get(item->second.object,
                      [&](ByteSource& source) { outputs[port] = type.decode(source); }))
        return false;
    }
    return true;
  }

  std::unique_ptr<StageInstance> original_;
  MadeItems made_;
  ObjectStore& store_;
};

}  // namespace

std::unique_ptr<StageInstance> resume_map(std::unique_ptr<StageInstance> original, MadeItems made,
                                          ObjectStore& store) {
  return std::make_unique<ResumedMap>(std::move(original), std::move(made), store);
}

}  // namespace stope
