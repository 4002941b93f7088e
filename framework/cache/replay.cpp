#include "framework/cache/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "framework/cache/file_digests.hpp"
#include "framework/plugins/sdk_build.hpp"
#include "framework/report/sha256.hpp"

namespace stope {
namespace {

/// What a stage's key says of the stage itself: neither the keys of its inputs nor the run's name.
StageKey own_part(const StageKey& key) {
  StageKey own;
  for (const KeyPart& part : key.parts)
    if (part.name != "run" && !part.name.starts_with("input ")) own.parts.push_back(part);
  return own;
}

std::string list_text(const std::vector<std::string>& list) {
  return list.empty() ? "none of those asked about" : fmt::format("{}", fmt::join(list, ", "));
}

void compare_machines(const EarlierRun& earlier, const EarlierRun& now, ReplayVerdict& verdict) {
  if (earlier.features != now.features)
    verdict.remarks.push_back(
        fmt::format("the processor's features were {}, are {}; libraries that choose their code by "
                    "them may round differently",
                    list_text(earlier.features), list_text(now.features)));
  if (earlier.libraries != now.libraries)
    verdict.remarks.push_back(
        fmt::format("the C library was {}, is {}", earlier.libraries, now.libraries));
  if (earlier.version != now.version)
    verdict.remarks.push_back(fmt::format("Stope was {}, is {}", earlier.version, now.version));
}

/// `again`: what the second run wrote; or null. `found`: the SHA-256 of what lies in the first
/// one's folder now, if anything does.
void compare_output(const EarlierOutput& was, const EarlierOutput* again,
                    const std::optional<std::string>& found, ReplayVerdict& verdict) {
  if (!found)
    verdict.differences.push_back(
        fmt::format("{} is not in the recorded run's folder any more", was.path));
  if (!again) {
    verdict.differences.push_back(fmt::format("{} was not written this time", was.path));
    return;
  }
  ++verdict.compared;
  const bool edited = found && *found != was.sha256;
  if (again->sha256 != was.sha256)
    verdict.differences.push_back(fmt::format(
        "{}, whose SHA-256 was {} ({} bytes), is {} ({} bytes){}", was.path, was.sha256, was.bytes,
        again->sha256, again->bytes,
        !edited                   ? ""
        : *found == again->sha256 ? ", as is the file in the recorded run's folder: run.json was "
                                    "edited, or the file replaced"
                                  : ", and the file in the recorded run's folder is a third: it "
                                    "was edited or replaced"));
  else if (edited)
    verdict.differences.push_back(fmt::format(
        "{} was edited or replaced after the recorded run: its SHA-256 was {}, which the second "
        "run gives again, and is {}",
        was.path, was.sha256, *found));
}

}  // namespace

std::vector<StageKey> keys_of(const Plan& plan, const Catalogue& catalogue, std::uint64_t seed,
                              const std::atomic<bool>* stop) {
  FileDigests digests{{}};
  KeyFacts facts;
  facts.seed = seed;
  facts.sdk = sdk_build_id();
  facts.digest_of_path = [&](const std::filesystem::path& path) { return digests.of(path, stop); };
  return stage_keys(plan, catalogue, facts);
}

ReplayVerdict compare_before(const EarlierRun& earlier, const Plan& plan,
                             const std::vector<StageKey>& keys, const std::string& version) {
  ReplayVerdict verdict;
  if (earlier.stages.empty()) {
    verdict.differences.push_back("the record holds no keys to compare with");
    return verdict;
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    const std::string& name = plan.stages[i].name;
    names.insert(name);
    const auto found = earlier.stages.find(name);
    if (found == earlier.stages.end()) {
      verdict.differences.push_back(
          fmt::format("there was no stage \"{}\" when it was recorded", name));
      continue;
    }
    for (const std::string& change : differences(own_part(found->second.key), own_part(keys[i])))
      verdict.differences.push_back(fmt::format("stage \"{}\": {}", name, change));
    if (verdict.same() && !keys[i].only_this_run && found->second.key.digest != keys[i].digest)
      verdict.differences.push_back(
          fmt::format("stage \"{}\" reads its inputs from other stages or ports", name));
  }
  for (const auto& [name, stage] : earlier.stages)
    if (!names.contains(name))
      verdict.differences.push_back(fmt::format("stage \"{}\" is gone", name));
  if (!verdict.same()) {
    if (const std::string changed = first_changed_file(earlier); !changed.empty())
      verdict.remarks.push_back(changed);
    if (earlier.version != version)
      verdict.remarks.push_back(fmt::format("Stope was {}, is {}", earlier.version, version));
  }
  return verdict;
}

void compare_after(const EarlierRun& earlier, const std::filesystem::path& folder,
                   const EarlierRun& now, const std::vector<StageKey>& keys, const Plan& plan,
                   ReplayVerdict& verdict) {
  std::set<std::string> paths;
  for (const EarlierOutput& was : earlier.outputs) {
    paths.insert(was.path);
    const auto is = std::find_if(now.outputs.begin(), now.outputs.end(),
                                 [&](const EarlierOutput& one) { return one.path == was.path; });
    compare_output(was, is == now.outputs.end() ? nullptr : &*is,
                   report::sha256_of_file(folder / was.path), verdict);
  }
  for (const EarlierOutput& is : now.outputs)
    if (!paths.contains(is.path)) verdict.differences.push_back(fmt::format("{} is new", is.path));
  for (std::size_t i = 0; i < plan.stages.size(); ++i) {
    if (!plan.stages[i].info.deterministic || plan.stages[i].info.live)
      verdict.remarks.push_back(
          fmt::format("stage \"{}\" ({}) does not promise the same bytes each time",
                      plan.stages[i].name, plan.stages[i].info.id));
    else if (keys[i].only_this_run &&
             std::none_of(plan.stages[i].inputs.begin(), plan.stages[i].inputs.end(),
                          [](const auto& input) { return input.has_value(); }))
      verdict.remarks.push_back(fmt::format(
          "stage \"{}\" reads files that could not be read to tell whether they have changed",
          plan.stages[i].name));
  }
  compare_machines(earlier, now, verdict);
}

std::string first_changed_file(const EarlierRun& earlier) {
  for (const EarlierFile& file : earlier.files) {
    const auto sha256 = report::sha256_of_file(file.path);
    if (!sha256) return fmt::format("{} is not there any more", file.path.string());
    if (*sha256 != file.sha256)
      return fmt::format("{} has changed since it was recorded", file.path.string());
  }
  return {};
}

}  // namespace stope
