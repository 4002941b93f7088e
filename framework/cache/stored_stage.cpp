#include "framework/cache/stored_stage.hpp"

#include <fmt/format.h>

#include <charconv>
#include <tuple>
#include <utility>

#include "framework/plugins/sdk_payloads.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

/// No stage of a plugin has such an id: it is not of the form family/name. The stage's place
/// follows.
constexpr std::string_view kStored = "stored:", kResumed = "resumed:";

/// What an output carries that nothing is asked of.
struct Nothing {
  static constexpr std::string_view kType = "stope/Nothing@1";
  static constexpr void fields(auto&, auto&&) {}
};

/// Writes what the store holds of a stage's outputs, in the order of stamps.
class StoredStage final : public StageInstance {
 public:
  StoredStage(const PlannedStage& stage, const KeptStage& kept, const Catalogue& catalogue,
              ObjectStore& store, std::atomic<bool>& damaged)
      : stage_(stage),
        kept_(kept),
        store_(store),
        damaged_(damaged),
        outputs_(stage.info.outputs.size(), nullptr) {
    for (std::size_t port = 0; port < stage.info.outputs.size(); ++port) {
      const PortInfo& info = stage.info.outputs[port];
      types_.push_back(kept.find(info) ? sdk_payload(info.type, info.layout)
                                       : &payload_type<Nothing>());
      if (types_.back()) continue;
      // Only its plugin can read it. Others are not even opened, which is most of what a run that
      // executes nothing would take.
      if (!original_) original_ = catalogue.create(stage.info.id);
      types_.back() = &original_->output_type(port);
    }
  }

  const StageInfo& info() const noexcept override { return stage_.info; }
  Outcome set_parameter(std::size_t, const ParameterValue&) noexcept override { return {}; }
  void connect_input(std::size_t, InputPort*) noexcept override {}
  void connect_output(std::size_t place, OutputPort* port) noexcept override {
    outputs_[place] = port;
  }
  const PayloadType& output_type(std::size_t place) const noexcept override {
    return *types_[place];
  }
  Outcome run(Context&) noexcept override {
    return guarded([&] {
      for (const auto& [stamp, port, item] : in_time_order()) put(port, *item);
    });
  }
  Outcome apply(std::span<const AnyItem>, Context&,
                std::span<std::shared_ptr<const void>>) const noexcept override {
    return {Outcome::Kind::kFailed, "a stored stage is run, not applied"};
  }
  Outcome also_reads(std::vector<std::filesystem::path>&) const noexcept override { return {}; }

 private:
  using Entry = std::tuple<Stamp, std::size_t, const KeptItem*>;

  std::vector<Entry> in_time_order() const {
    std::vector<Entry> entries;
    for (std::size_t port = 0; port < outputs_.size(); ++port) {
      if (!outputs_[port] || !outputs_[port]->wanted()) continue;
      const KeptOutput* output = kept_.find(stage_.info.outputs[port]);
      if (!output) continue;
      for (const KeptItem& item : output->items) entries.emplace_back(item.stamp, port, &item);
    }
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return std::get<Stamp>(a) < std::get<Stamp>(b);
    });
    return entries;
  }

  void put(std::size_t port, const KeptItem& item) {
    const PayloadType& type = *types_[port];
    outputs_[port]->put_lazy(
        item.stamp, item.index,
        [&type, &store = store_, &damaged = damaged_, object = item.object, name = stage_.name] {
          std::shared_ptr<const void> value;
          if (!store.get(object, [&](ByteSource& source) { value = type.decode(source); })) {
            damaged = true;
            throw Error(fmt::format(
                "what the store kept of stage \"{}\" has been damaged or removed since the run "
                "began; run again, and it is computed anew",
                name));
          }
          return value;
        },
        item.size);
  }

  const PlannedStage& stage_;
  const KeptStage& kept_;
  std::unique_ptr<StageInstance> original_;  ///< or none
  std::vector<const PayloadType*> types_;    ///< by output
  ObjectStore& store_;
  std::atomic<bool>& damaged_;
  std::vector<OutputPort*> outputs_;
};

}  // namespace

Plan with_reuse(const Plan& plan, const Reuse& reuse) {
  Plan result = plan;
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    PlannedStage& stage = result.stages[i];
    if (i < reuse.made.size() && !reuse.made[i].empty())
      stage.info.id = fmt::format("{}{}", kResumed, i);
    if (is_made(reuse.fates[i])) continue;
    stage.info.id = fmt::format("{}{}", kStored, i);
    stage.info.map = stage.info.in_order = false;
    stage.info.inputs.clear();
    stage.inputs.clear();
    stage.info.parameters.clear();
    stage.parameters.clear();
  }
  return result;
}

std::unique_ptr<StageInstance> ReusingCatalogue::create(std::string_view id) const {
  const bool stored = id.starts_with(kStored), resumed = id.starts_with(kResumed);
  if (!stored && !resumed) return catalogue_.create(id);
  std::size_t stage = 0;
  const std::size_t begin = (stored ? kStored : kResumed).size();
  std::from_chars(id.data() + begin, id.data() + id.size(), stage);
  if (resumed)
    return resume_map(catalogue_.create(plan_.stages[stage].info.id), reuse_.made[stage], store_);
  return std::make_unique<StoredStage>(plan_.stages[stage], reuse_.stored[stage], catalogue_,
                                       store_, damaged_);
}

}  // namespace stope
