#include "framework/report/artefact_writer.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "framework/report/output_name.hpp"
#include "framework/report/sha256.hpp"
#include "stope/error.hpp"

namespace stope::report {
namespace {

namespace fs = std::filesystem;

void refuse_other_kind(const fs::path& target, bool folder, const std::string& owner) {
  const fs::file_status status = fs::symlink_status(target);
  if (!fs::exists(status) || fs::is_directory(status) == folder) return;
  throw Error(
      fmt::format("the output {} cannot be written: {} is {}. Move it away or rename the "
                  "output.",
                  owner, target.string(), folder ? "not a folder" : "a folder"));
}

}  // namespace

ArtefactWriter::ArtefactWriter(RunDirectory& directory, PlannedOutput output)
    : directory_(directory), output_(std::move(output)) {
  check_output_name(output_.name);
  if (output_.stream) {
    folder_name_ = output_stem(output_.name, "");
    const fs::path target = directory_.claim(folder_name_, output_.name);
    refuse_other_kind(target, true, output_.name);
    folder_ = std::make_unique<PendingFolder>(target);
  } else {
    refuse_other_kind(directory_.claim(output_.name, output_.name), false, output_.name);
  }
}

void ArtefactWriter::write(const AnyItem& item) {
  const auto artefact = std::static_pointer_cast<const Artefact>(item.payload->pin());
  if (artefact->files.empty())
    throw Error(fmt::format("the export of the output {} made no file.", output_.name));
  for (const ArtefactFile& file : artefact->files) check_extension(file.extension);
  if (output_.stream) {
    write_stream_item(*artefact, item.index);
  } else {
    if (!files_.empty())
      throw Error(
          fmt::format("the output {} got a second item, but it is one file.", output_.name));
    write_value(*artefact);
  }
}

void ArtefactWriter::write_value(const Artefact& artefact) {
  const std::string stem = output_stem(output_.name, artefact.files.front().extension);
  for (std::size_t i = 0; i < artefact.files.size(); ++i) {
    const ArtefactFile& file = artefact.files[i];
    // The first is called exactly as the pipeline says, whatever extension the export gave.
    const std::string name = i == 0 ? output_.name : stem + "." + file.extension;
    const fs::path target =
        i == 0 ? directory_.outputs() / name : directory_.claim(name, output_.name);
    refuse_other_kind(target, false, output_.name);
    pending_.emplace_back(target).write(file.bytes.data(), file.bytes.size());
    note(name, file, i > 0);
  }
}

void ArtefactWriter::write_stream_item(const Artefact& artefact, std::uint64_t index) {
  for (std::size_t i = 0; i < artefact.files.size(); ++i) {
    const ArtefactFile& file = artefact.files[i];
    const std::string name = item_stem(index) + "." + file.extension;
    const fs::path target = folder_->path() / name;
    if (fs::exists(target))
      throw Error(fmt::format("the export of the output {} made {} twice.", output_.name, name));
    // The whole folder is temporary, so that a rename here only guards against a full disk.
    PendingFile pending(target);
    pending.write(file.bytes.data(), file.bytes.size());
    pending.commit();
    note(folder_name_ + "/" + name, file, i > 0);
  }
}

void ArtefactWriter::note(std::string relative, const ArtefactFile& file, bool companion) {
  files_.push_back({output_.name, "outputs/" + std::move(relative), file.bytes.size(),
                    sha256_of(file.bytes), companion});
}

void ArtefactWriter::close() {
  if (!output_.stream && files_.empty())
    throw Error(fmt::format("the export of the output {} ended without giving it.", output_.name));
  for (PendingFile& file : pending_) file.close();
}

void ArtefactWriter::commit() {
  for (PendingFile& file : pending_) file.commit();
  if (folder_) folder_->commit();
  for (const PendingFile& file : pending_) sync_folder(file.final_path().parent_path());
}

}  // namespace stope::report
