#include <fmt/chrono.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/cache/cached_run.hpp"
#include "framework/cache/store_contents.hpp"
#include "framework/cache/store_folder.hpp"
#include "framework/cli/arguments.hpp"
#include "framework/cli/byte_size.hpp"
#include "framework/cli/cache_use.hpp"
#include "framework/cli/exit_code.hpp"
#include "framework/cli/wrong_argument.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope {
namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path store_of(const Arguments& arguments) {
  const std::filesystem::path store = cache_use(arguments).store;
  if (store.empty())
    throw WrongArgument("there is no store: give --cache, or set STOPE_CACHE or HOME");
  if (!is_store(store))
    throw WrongArgument(fmt::format(
        "there is no store in {}: a run that keeps results there makes one", store.string()));
  return store;
}

void print(const Json& json) {
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

Json json_of(const StoreUsage& usage) {
  return {{"objects", usage.objects}, {"bytes", usage.bytes}};
}

std::string objects_text(std::uint64_t count) {
  return report::count_text(count, "object", "objects");
}

std::string time_text(std::time_t time) {
  return fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(time));
}

}  // namespace

int cache_ls_command(const Arguments& arguments) {
  const std::filesystem::path root = store_of(arguments);
  ObjectStore store(root);
  const std::vector<StoredRecord> records = contents_of(store);
  const StoreUsage usage = usage_of(store);
  if (arguments.json) {
    Json list = Json::array();
    for (const StoredRecord& record : records)
      list.push_back({{"stage", record.name},
                      {"key", record.key.text()},
                      {"outputs", record.ports},
                      {"items", record.items},
                      {"bytes", record.bytes},
                      {"whole", record.missing == 0},
                      {"used", static_cast<std::int64_t>(record.used)}});
    Json json = json_of(usage);
    json["store"] = root.string();
    json["stages"] = list;
    print(json);
    return kDone;
  }
  for (const StoredRecord& record : records)
    fmt::print(
        "{}  {}  {:>10}  {} ({}){}\n", time_text(record.used), record.key.text().substr(0, 12),
        byte_size_text(record.bytes), record.name, fmt::join(record.ports, ", "),
        record.missing == 0 ? ""
                            : ", gone: " + report::count_text(record.missing, "item", "items"));
  fmt::print("{}, {}, {} in {}\n",
             report::count_text(records.size(), "result of a stage", "results of stages"),
             objects_text(usage.objects), byte_size_text(usage.bytes), root.string());
  return kDone;
}

int cache_gc_command(const Arguments& arguments) {
  const std::filesystem::path root = store_of(arguments);
  ObjectStore store(root);
  const std::uint64_t limit =
      arguments.cache_limit > 0 ? arguments.cache_limit : kDefaultStoreLimit;
  const StoreUsage before = usage_of(store);
  const StoreUsage after = collect_garbage(store, limit);
  const std::uint64_t forgotten = forget_what_is_gone(store);
  const std::uint64_t freed = before.bytes > after.bytes ? before.bytes - after.bytes : 0;
  if (arguments.json) {
    Json json = json_of(after);
    json["freed"] = freed;
    json["forgotten"] = forgotten;
    print(json);
  } else {
    fmt::print("{} freed; left in {}: {}, {} of at most {}\n", byte_size_text(freed), root.string(),
               objects_text(after.objects), byte_size_text(after.bytes), byte_size_text(limit));
  }
  return kDone;
}

int cache_verify_command(const Arguments& arguments) {
  const std::filesystem::path root = store_of(arguments);
  ObjectStore store(root);
  const std::uint64_t damaged = verify(store);
  const std::uint64_t damaged_records = verify_records(store);
  const std::uint64_t forgotten = forget_what_is_gone(store);
  const StoreUsage usage = usage_of(store);
  const std::string left =
      fmt::format("{} ({})", objects_text(usage.objects), byte_size_text(usage.bytes));
  const bool sound = damaged + damaged_records == 0;
  if (arguments.json) {
    Json json = json_of(usage);
    json["damaged"] = damaged;
    json["damaged_records"] = damaged_records;
    json["forgotten"] = forgotten;
    print(json);
  } else if (sound) {
    fmt::print("Nothing is damaged in {}: {}.\n", root.string(), left);
  } else {
    fmt::print(
        "Damaged, and removed from {}: {}, {}. What they belonged to will be computed again when "
        "it is needed. Left and sound: {}.\n",
        root.string(), objects_text(damaged),
        report::count_text(damaged_records, "record", "records"), left);
  }
  return sound ? kDone : kRunFailed;
}

}  // namespace stope
