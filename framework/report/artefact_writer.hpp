#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/pipeline/plan.hpp"
#include "framework/report/pending_file.hpp"
#include "framework/report/pending_folder.hpp"
#include "framework/report/run_directory.hpp"
#include "framework/report/written_output.hpp"
#include "stope/payload.hpp"
#include "stope/payloads/artefact.hpp"

namespace stope::report {

/// Writes what one entry under `outputs:` asks for: a file and its companions, or of a stream a
/// folder of numbered ones. Everything stays under temporary names until commit().
class ArtefactWriter {
 public:
  /// Throws Error if the output's name would leave the folder or meets something it cannot replace.
  ArtefactWriter(RunDirectory& directory, PlannedOutput output);

  /// Writes one item, whose payload is an Artefact. Throws Error if the disk is full.
  void write(const AnyItem& item);
  /// Brings everything to the disk. Throws Error if the disk is full or nothing came.
  void close();
  /// Gives everything its final name, in place of what an earlier run left there.
  void commit();

  const PlannedOutput& output() const { return output_; }
  /// What it will be called, relative to the run directory: a file, or of a stream a folder.
  std::string relative() const {
    return "outputs/" + (output_.stream ? folder_name_ : output_.name);
  }
  /// What was written, companions after the file they belong to.
  const std::vector<WrittenFile>& files() const { return files_; }

 private:
  void write_value(const Artefact& artefact);
  void write_stream_item(const Artefact& artefact, std::uint64_t index);
  void note(std::string relative, const ArtefactFile& file, bool companion);

  RunDirectory& directory_;
  PlannedOutput output_;
  std::vector<PendingFile> pending_;       ///< of a value
  std::unique_ptr<PendingFolder> folder_;  ///< of a stream
  std::string folder_name_;                ///< of a stream, relative to outputs/
  std::vector<WrittenFile> files_;
};

}  // namespace stope::report
