#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "framework/cache/reuse.hpp"

namespace stope {

/// A plan in which stored stages have become sources, and stages that are not needed give nothing.
/// Places of stages and ports stay, so that sinks fit. Run it with a ReusingCatalogue.
Plan with_reuse(const Plan& plan, const Reuse& reuse);

/// A catalogue that makes the stages of such a plan: those that run as another catalogue does, the
/// others as sources whose items are read from the store when they are touched.
class ReusingCatalogue final : public Catalogue {
 public:
  /// All must live as long as this and what it made.
  ReusingCatalogue(const Plan& plan, const Reuse& reuse, const Catalogue& catalogue,
                   ObjectStore& store)
      : plan_(plan), reuse_(reuse), catalogue_(catalogue), store_(store) {}
  const std::vector<StageRecord>& stages() const override { return catalogue_.stages(); }
  const StageRecord* find(std::string_view id) const override { return catalogue_.find(id); }
  std::unique_ptr<StageInstance> create(std::string_view id) const override;
  /// Whether an object turned out to be damaged, or was gone, when it was touched. The run failed
  /// then; the object is no longer there, so that another decide() will not count on it.
  bool damaged() const { return damaged_; }

 private:
  const Plan& plan_;
  const Reuse& reuse_;
  const Catalogue& catalogue_;
  ObjectStore& store_;
  mutable std::atomic<bool> damaged_{false};
};

}  // namespace stope
