#include <fmt/format.h>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/outputs.hpp"

namespace stope {

void check_collisions(const std::vector<OutputDraft>& outputs,
                      const std::vector<StageDraft>& drafts, Diagnostics& diagnostics) {
  std::vector<std::string> files;
  for (const OutputDraft& output : outputs) {
    const StageDraft& draft = drafts[output.draft];
    std::string file = output.name;
    if (!draft.streams.empty() && draft.streams[0]) {
      const std::size_t dot = file.rfind('.');
      file = file.substr(0, dot) + "/000000" + file.substr(dot);
    }
    for (std::size_t i = 0; i < files.size(); ++i) {
      if (files[i] != file && !files[i].starts_with(file + "/") &&
          !file.starts_with(files[i] + "/"))
        continue;
      const bool file_first = file.size() > files[i].size();
      diagnostics.error(
          code::kOutputCollision, output.place,
          files[i] == file
              ? fmt::format("The outputs '{}' and '{}' would both be the file '{}'.",
                            outputs[i].name, output.name, file)
              : fmt::format("The output '{}' would be a file, and the folder that '{}' is in.",
                            file_first ? outputs[i].name : output.name,
                            file_first ? output.name : outputs[i].name),
          "Rename one of them.");
    }
    files.push_back(file);
  }
}

}  // namespace stope
