#include "framework/cache/store_contents.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <system_error>
#include <tuple>

#include "framework/cache/checked_file.hpp"
#include "framework/cache/digest_text.hpp"
#include "framework/cache/kept_stage.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

/// Calls `work` for each record that can be read. Records may disappear meanwhile.
void for_each_record(const ObjectStore& store,
                     const std::function<void(const fs::path&, const KeptStage&)>& work) {
  std::error_code error;
  for (fs::recursive_directory_iterator entry(store.root() / "stages", error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code gone;
    if (!entry->is_regular_file(gone) || gone) continue;
    const auto kept = load_checked<KeptStage>(entry->path());
    if (kept && kept->format == KeptStage::kFormat) work(entry->path(), *kept);
  }
}

StoredRecord record_of(const ObjectStore& store, const fs::path& file, const KeptStage& kept) {
  StoredRecord record;
  record.key = digest_of_hex(file.parent_path().filename().string() + file.filename().string())
                   .value_or(Digest{});
  record.name = kept.name;
  for (const KeptOutput& output : kept.outputs) {
    if (output.type != kNoteType)
      record.ports.push_back(output.lazy ? output.port + ", reopened" : output.port);
    for (const KeptItem& item : output.items) {
      struct stat facts {};
      if (::stat(store.file_of(item.object).c_str(), &facts) != 0) {
        ++record.missing;
        continue;
      }
      ++record.items;
      record.bytes += static_cast<std::uint64_t>(facts.st_size);
      record.used = std::max(record.used, facts.st_mtime);
    }
  }
  return record;
}

}  // namespace

std::vector<StoredRecord> contents_of(const ObjectStore& store) {
  std::vector<StoredRecord> records;
  for_each_record(store, [&](const fs::path& file, const KeptStage& kept) {
    records.push_back(record_of(store, file, kept));
  });
  std::sort(records.begin(), records.end(), [](const StoredRecord& a, const StoredRecord& b) {
    return std::tie(b.used, a.name, a.key) < std::tie(a.used, b.name, b.key);
  });
  return records;
}

std::uint64_t forget_what_is_gone(const ObjectStore& store) {
  std::uint64_t forgotten = 0;
  for_each_record(store, [&](const fs::path& file, const KeptStage& kept) {
    if (record_of(store, file, kept).missing == 0) return;
    std::error_code ignored;
    if (fs::remove(file, ignored)) ++forgotten;
  });
  return forgotten;
}

}  // namespace stope
