#pragma once

#include <string>
#include <vector>

#include "framework/pipeline/stage_draft.hpp"

namespace stope {

/// The only input of an export that must be wired, or null if there are none or several.
const PortInfo* exported_input(const StageInfo& stage);

/// Whether the stage turns something into an artefact.
bool is_export(const StageInfo& stage);

/// The exports that write this extension.
std::vector<const StageRecord*> exports_writing(const Catalogue& catalogue,
                                                const std::string& extension);

/// The exports that write this extension and take this output.
std::vector<const StageRecord*> exports_for(const Catalogue& catalogue,
                                            const std::string& extension, const PortInfo& output);

/// All extensions that some export writes, of this output if one is given; sorted.
std::vector<std::string> written_extensions(const Catalogue& catalogue, const PortInfo* output);

}  // namespace stope
