#include "framework/cache/warning_memory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "stope/codec.hpp"

namespace stope {
namespace {

// A port's name holds no blank.
constexpr std::string_view kName = "warned of";
constexpr std::size_t kSentencesKept = 100;

}  // namespace

void WarningMemory::log(LogLevel level, const std::string& stage, const std::string& sentence) {
  if (level == LogLevel::kWarning && !stage.empty()) {
    const std::lock_guard lock(mutex_);
    StageWarnings& own = by_stage_[stage];
    if (own.sentences.size() < kSentencesKept) {
      own.sentences.push_back(sentence);
    } else {
      ++own.more;
    }
  }
  observer_.log(level, stage, sentence);
}

std::optional<KeptOutput> WarningMemory::take(const std::string& stage, ObjectStore& store) {
  StageWarnings said;
  {
    const std::lock_guard lock(mutex_);
    auto taken = by_stage_.extract(stage);
    if (!taken) return std::nullopt;
    said = std::move(taken.mapped());
  }
  const StoredObject object = store.put([&](ByteSink& sink) { encode(said, sink); });
  return KeptOutput{
      std::string(kName), std::string(kNoteType), 0, false, {{0, 0, object.digest, object.size}}};
}

void repeat_warnings(const KeptStage& kept, const std::string& stage, ObjectStore& store,
                     RunObserver& observer) {
  const auto note = std::find_if(kept.outputs.begin(), kept.outputs.end(),
                                 [](const KeptOutput& output) { return output.port == kName; });
  if (note == kept.outputs.end() || note->items.size() != 1) return;
  StageWarnings said;
  if (!store.get(note->items[0].object, [&](ByteSource& bytes) { decode(said, bytes); })) return;
  for (const std::string& sentence : said.sentences)
    observer.log(LogLevel::kWarning, stage, sentence);
  if (said.more > 0)
    observer.log(LogLevel::kWarning, stage,
                 fmt::format("it warned {} more times when it was computed", said.more));
}

}  // namespace stope
