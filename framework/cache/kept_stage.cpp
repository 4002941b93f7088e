#include "framework/cache/kept_stage.hpp"

#include <fmt/format.h>

#include <system_error>

#include "framework/cache/checked_file.hpp"

namespace stope {

const KeptOutput* KeptStage::find(const PortInfo& port) const {
  for (const KeptOutput& output : outputs)
    if (output.port == port.name && output.type == port.type && output.layout == port.layout)
      return &output;
  return nullptr;
}

KeptStages::KeptStages(const std::filesystem::path& root) : folder_(root / "stages") {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw Error(fmt::format("cannot make the store {}: {}", root.string(), error.message()));
}

std::filesystem::path KeptStages::file_of(const Digest& key) const {
  const std::string name = key.text();
  return folder_ / name.substr(0, 2) / name.substr(2);
}

std::optional<KeptStage> KeptStages::find(const Digest& key) const {
  auto kept = load_checked<KeptStage>(file_of(key));
  std::error_code ignored;
  if (!kept && std::filesystem::exists(file_of(key), ignored)) ++damaged_;
  if (kept && kept->format != KeptStage::kFormat) kept.reset();
  return kept;
}

void KeptStages::save(const Digest& key, const KeptStage& stage) {
  KeptStage all = stage;
  // An earlier run may have read other outputs of the stage.
  if (const auto known = find(key)) {
    for (const KeptOutput& output : known->outputs) {
      const auto same = [&](const KeptOutput& own) { return own.port == output.port; };
      if (std::none_of(stage.outputs.begin(), stage.outputs.end(), same))
        all.outputs.push_back(output);
    }
  }
  std::error_code error;
  std::filesystem::create_directory(file_of(key).parent_path(), error);
  if (error)
    throw Error(fmt::format("cannot make the folder {}: {}", file_of(key).parent_path().string(),
                            error.message()));
  save_checked(file_of(key), all);
}

}  // namespace stope
