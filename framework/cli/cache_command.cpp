#include <fmt/chrono.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/cache/cached_run.hpp"
#include "framework/cache/store_contents.hpp"
#include "framework/cli/arguments.hpp"
#include "framework/cli/byte_size.hpp"
#include "framework/cli/cache_use.hpp"
#include "framework/cli/exit_code.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

using Json = nlohmann::ordered_json;

std::filesystem::path store_of(const Arguments& arguments) {
  const std::filesystem::path store = cache_use(arguments).store;
  if (store.empty()) throw Error("there is no store: give --cache, or set STOPE_CACHE or HOME");
  return store;
}

void print(const Json& json) {
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

Json json_of(const StoreUsage& usage) {
  return {{"objects", usage.objects}, {"bytes", usage.bytes}};
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
    fmt::print("{}  {}  {:>10}  {} ({}){}\n", time_text(record.used),
               record.key.text().substr(0, 12), byte_size_text(record.bytes), record.name,
               fmt::join(record.ports, ", "),
               record.missing == 0 ? "" : fmt::format(", {} items are gone", record.missing));
  fmt::print("{} results of stages, {} objects, {} in {}\n", records.size(), usage.objects,
             byte_size_text(usage.bytes), root.string());
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
    fmt::print("{} freed; {} objects, {} of at most {}, are left in {}\n", byte_size_text(freed),
               after.objects, byte_size_text(after.bytes), byte_size_text(limit), root.string());
  }
  return kDone;
}

int cache_verify_command(const Arguments& arguments) {
  const std::filesystem::path root = store_of(arguments);
  ObjectStore store(root);
  const std::uint64_t damaged = verify(store);
  const std::uint64_t forgotten = forget_what_is_gone(store);
  const StoreUsage usage = usage_of(store);
  if (arguments.json) {
    Json json = json_of(usage);
    json["damaged"] = damaged;
    json["forgotten"] = forgotten;
    print(json);
  } else if (damaged == 0) {
    fmt::print("All {} objects ({}) in {} are sound.\n", usage.objects, byte_size_text(usage.bytes),
               root.string());
  } else {
    fmt::print(
        "{} damaged objects were removed from {}; the {} others are sound. What they "
        "belonged to will be computed again when it is needed.\n",
        damaged, root.string(), usage.objects);
  }
  return damaged == 0 ? kDone : kRunFailed;
}

}  // namespace stope
