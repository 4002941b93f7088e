#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "framework/pipeline/overrides.hpp"
#include "framework/pipeline/plan.hpp"
#include "framework/plugins/catalogue.hpp"

namespace stope {

/// Reads a pipeline file and checks all of it before any data is read: syntax, variables, stages,
/// wires, types, parameters, units, paths, outputs. Everything that is wrong is reported in one go;
/// the plan is given if none of it is an error. `overrides` are what `--set` was given:
/// `stage.parameter=value`, `stage.use=family/name`, `vars.name=value`.
std::optional<Plan> check_pipeline(const std::filesystem::path& file,
                                   const std::vector<std::string>& overrides,
                                   const Catalogue& catalogue, Diagnostics& diagnostics);

/// The same with overrides that were written elsewhere. `asked` is where the file is named.
std::optional<Plan> check_pipeline(const std::filesystem::path& file, const Place& asked,
                                   const std::vector<Override>& overrides,
                                   const Catalogue& catalogue, Diagnostics& diagnostics);

/// The same for a text in memory. `file` is what diagnostics call it; paths in it are relative to
/// that file's folder.
std::optional<Plan> check_pipeline_text(std::string_view text, const std::filesystem::path& file,
                                        const std::vector<std::string>& overrides,
                                        const Catalogue& catalogue, Diagnostics& diagnostics);

}  // namespace stope
