#pragma once

#include "framework/plugins/catalogue.hpp"

namespace stope {

/// A catalogue that stays as it is whatever the plugins become: stages that declare themselves and
/// do nothing.
class FakeCatalogue final : public Catalogue {
 public:
  FakeCatalogue();
  const std::vector<StageRecord>& stages() const override { return stages_; }
  const StageRecord* find(std::string_view id) const override;
  std::unique_ptr<StageInstance> create(std::string_view id) const override;

 private:
  std::vector<StageRecord> stages_;
};

}  // namespace stope
