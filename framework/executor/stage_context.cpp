#include "framework/executor/stage_context.hpp"

#include <algorithm>

#include "framework/executor/item_text.hpp"
#include "framework/executor/process.hpp"
#include "stope/digest.hpp"

namespace stope {

StageContext::StageContext(Process& process, const std::string& seed_name,
                           const RunServices& services)
    : process_(process),
      log_(services.log),
      scratch_(services.scratch),
      pool_(services.pool),
      seed_(mix_seed(services.seed, digest_of(seed_name).low)) {}

void StageContext::log(LogLevel level, std::string_view sentence) {
  log_at(level, sentence, process_.item_text());
}

void StageContext::log_at(LogLevel level, std::string_view sentence, const std::string& item) {
  log_.write(level, process_.name(),
             item.empty() ? std::string(sentence) : item + ": " + std::string(sentence));
}

void StageContext::progress(double fraction) {
  process_.set_fraction(std::clamp(fraction, 0.0, 1.0));
}

bool StageContext::cancelled() const { return process_.stopping(); }

std::filesystem::path StageContext::temporary_folder() {
  const std::lock_guard lock(mutex_);
  if (temporary_folder_.empty()) temporary_folder_ = scratch_.make_folder(process_.name());
  return temporary_folder_;
}

void ItemContext::log(LogLevel level, std::string_view sentence) {
  stage_.log_at(level, sentence, item_text(index_, stamp_));
}

}  // namespace stope
