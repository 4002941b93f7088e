#include "framework/cache/store_contents.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <system_error>
#include <tuple>

#include "framework/cache/checked_file.hpp"
#include "framework/cache/digest_text.hpp"
#include "framework/cache/kept_stage.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

/// A record that somebody wrote for so long has been given up: he was killed.
constexpr auto kAbandoned = std::chrono::hours(24);

/// Calls `work` for each file among the records. They may disappear meanwhile.
void for_each_file(const ObjectStore& store, const std::function<void(const fs::path&)>& work) {
  std::error_code error;
  for (fs::recursive_directory_iterator entry(store.root() / "stages", error), end;
       !error && entry != end; entry.increment(error)) {
    std::error_code gone;
    if (entry->is_regular_file(gone) && !gone) work(entry->path());
  }
}

std::optional<Digest> key_of(const fs::path& file) {
  return digest_of_hex(file.parent_path().filename().string() + file.filename().string());
}

std::optional<KeptStage> load(const fs::path& file) {
  auto kept = load_checked<KeptStage>(file);
  if (kept && kept->format != KeptStage::kFormat) kept.reset();
  return kept;
}

/// Calls `work` for each record that can be read.
void for_each_record(const ObjectStore& store,
                     const std::function<void(const fs::path&, const KeptStage&)>& work) {
  for_each_file(store, [&](const fs::path& file) {
    if (const auto kept = load(file)) work(file, *kept);
  });
}

/// Whether another process writes this file: it has its name from write_checked(), or had no time
/// to remove it.
bool is_being_written(const fs::path& file) {
  std::error_code error;
  const auto written = fs::last_write_time(file, error);
  return file.has_extension() && !error && written + kAbandoned > fs::file_time_type::clock::now();
}

StoredRecord record_of(const ObjectStore& store, const fs::path& file, const KeptStage& kept) {
  StoredRecord record;
  record.key = key_of(file).value_or(Digest{});
  record.name = kept.name;
  // Of what has no items, or has none left, it is all there is to tell.
  struct stat own {};
  if (::stat(file.c_str(), &own) == 0) record.used = own.st_mtime;
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

std::uint64_t verify_records(const ObjectStore& store) {
  std::uint64_t damaged = 0;
  const auto judge = [&](const fs::path& file, bool sound) {
    std::error_code ignored;
    if (!sound && fs::remove(file, ignored)) ++damaged;
  };
  for_each_file(store, [&](const fs::path& file) {
    if (!is_being_written(file)) judge(file, key_of(file) && load(file));
  });
  const fs::path table = store.root() / "digests";
  judge(table, read_checked(table).has_value());
  return damaged;
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
