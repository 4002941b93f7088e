#pragma once

#include <mutex>
#include <string>

#include "framework/executor/run_services.hpp"
#include "stope/context.hpp"

namespace stope {

class Process;

/// What a stage's run() is offered.
class StageContext final : public Context {
 public:
  /// Its seed is a function of the run's and of `seed_name`.
  StageContext(Process& process, const std::string& seed_name, const RunServices& services);

  void log(LogLevel level, std::string_view sentence) override;
  void progress(double fraction) override;
  std::uint64_t seed() const override { return seed_; }
  bool cancelled() const override;
  int threads() const override { return pool_.threads(); }
  std::filesystem::path temporary_folder() override;

  /// Log with the item named by the caller.
  void log_at(LogLevel level, std::string_view sentence, const std::string& item);

 private:
  Process& process_;
  RunLog& log_;
  ScratchFolder& scratch_;
  const WorkerPool& pool_;
  std::uint64_t seed_;
  std::mutex mutex_;
  std::filesystem::path temporary_folder_;
};

/// What a map is offered for one item.
class ItemContext final : public Context {
 public:
  ItemContext(StageContext& stage, std::uint64_t index, Stamp stamp)
      : stage_(stage), index_(index), stamp_(stamp) {}

  void log(LogLevel level, std::string_view sentence) override;
  void progress(double fraction) override { stage_.progress(fraction); }
  std::uint64_t seed() const override { return mix_seed(stage_.seed(), index_); }
  std::uint64_t index() const override { return index_; }
  bool cancelled() const override { return stage_.cancelled(); }
  int threads() const override { return stage_.threads(); }
  std::filesystem::path temporary_folder() override { return stage_.temporary_folder(); }

 private:
  StageContext& stage_;
  std::uint64_t index_;
  Stamp stamp_;
};

}  // namespace stope
