#include "framework/report/run_report.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "framework/report/artefact_writer.hpp"
#include "framework/report/other_files.hpp"
#include "framework/report/page/page.hpp"
#include "framework/report/payload_tap.hpp"
#include "framework/report/pending_file.hpp"
#include "framework/report/port_name.hpp"
#include "framework/report/report_data.hpp"
#include "framework/report/run_directory.hpp"
#include "framework/report/run_json.hpp"
#include "framework/report/run_log.hpp"
#include "framework/report/sha256.hpp"
#include "framework/report/tap_choice.hpp"
#include "framework/report/trace_json.hpp"

namespace stope {
namespace {

using namespace report;

std::vector<FileRead> hash_files(const Plan& plan) {
  std::vector<FileRead> files;
  for (const std::filesystem::path& path : plan.files_read)
    files.push_back({path.string(), sha256_of_file(path).value_or("")});
  return files;
}

}  // namespace

struct RunReport::Parts {
  Parts(const Plan& the_plan, const Catalogue& the_catalogue, RunFacts the_facts,
        const std::filesystem::path& folder)
      : plan(the_plan),
        catalogue(the_catalogue),
        facts(std::move(the_facts)),
        directory(folder),
        log(directory.file("log.txt")),
        files_read(hash_files(plan)),
        choices(choose_taps(plan)) {
    begin();
  }

  void begin() {
    taps.clear();
    known.clear();
    writers.clear();
    directory.forget_claims();
    for (const PlannedOutput& output : plan.outputs)
      writers.push_back(std::make_unique<ArtefactWriter>(directory, output));
    for (const TapChoice& choice : choices)
      taps.push_back(std::make_unique<PayloadTap>(choice.source, is_stream(plan, choice.source),
                                                  choice.digest, choice.draw));
  }

  TapResult seen(const PlannedSource& source) const {
    for (const TapResult& result : known)
      if (result.source == source) return result;
    for (const auto& tap : taps) {
      if (tap->source() != source) continue;
      const auto digest = tap->digest();
      return {source, tap->items(), digest ? digest->text() : "", tap->sketches()};
    }
    return {source, 0, {}, {}};
  }

  ReportData data(const RunRecord& record) const {
    ReportData data{plan,       catalogue, facts, record, log, this_machine(),
                    files_read, {},        {},    {},     {},  reuse};
    for (const TapChoice& choice : choices) data.taps.push_back(seen(choice.source));
    for (const auto& writer : writers) {
      if (record.end == RunRecord::End::kDone) {
        data.outputs.insert(data.outputs.end(), writer->files().begin(), writer->files().end());
      } else if (std::filesystem::exists(directory.folder() / writer->relative())) {
        data.outputs_kept.push_back(writer->relative());
      }
    }
    if (record.end == RunRecord::End::kDone) data.outputs_beside = others_in_outputs();
    return data;
  }

  std::vector<std::string> others_in_outputs() const {
    constexpr std::size_t kBelow = std::string_view("outputs/").size();
    std::set<std::string> owned;
    for (const auto& writer : writers) {
      owned.insert(writer->relative().substr(kBelow));
      for (const WrittenFile& file : writer->files()) owned.insert(file.path.substr(kBelow));
    }
    return other_files(directory.outputs(), owned);
  }

  const Plan& plan;
  const Catalogue& catalogue;
  RunFacts facts;
  RunDirectory directory;
  RunLog log;
  std::vector<FileRead> files_read;
  std::vector<TapChoice> choices;
  std::vector<TapResult> known;  ///< from earlier runs
  std::vector<StageReuse> reuse;
  bool begun = false;
  std::vector<std::unique_ptr<ArtefactWriter>> writers;
  std::vector<std::unique_ptr<PayloadTap>> taps;
  std::vector<WrittenFile> in_place;
};

RunReport::RunReport(const Plan& plan, const Catalogue& catalogue, RunFacts facts,
                     const std::filesystem::path& folder)
    : parts_(std::make_unique<Parts>(plan, catalogue, std::move(facts), folder)) {}

RunReport::~RunReport() = default;

std::vector<PlannedSource> RunReport::needed() const {
  std::vector<PlannedSource> sources;
  for (const PlannedOutput& output : parts_->plan.outputs) sources.push_back({output.stage, 0});
  for (const TapChoice& choice : parts_->choices)
    if (choice.needed) sources.push_back(choice.source);
  return sources;
}

std::vector<PlannedSource> RunReport::welcome() const {
  std::vector<PlannedSource> sources;
  for (const TapChoice& choice : parts_->choices)
    if (!choice.needed) sources.push_back(choice.source);
  return sources;
}

TapResult RunReport::seen(const PlannedSource& source) const { return parts_->seen(source); }
void RunReport::know(TapResult result) { parts_->known.push_back(std::move(result)); }
void RunReport::set_reuse(std::vector<StageReuse> reuse) { parts_->reuse = std::move(reuse); }

std::vector<Sink> RunReport::sinks(const std::function<bool(const PlannedSource&)>& reads) {
  if (parts_->begun) parts_->begin();
  parts_->begun = true;
  std::vector<Sink> sinks;
  for (const auto& writer : parts_->writers)
    sinks.push_back({fmt::format("write {}", writer->output().name),
                     {writer->output().stage, 0},
                     [&writer = *writer](const AnyItem& item) { writer.write(item); },
                     [&writer = *writer] { writer.close(); }});
  for (std::size_t i = 0; i < parts_->taps.size(); ++i) {
    PayloadTap& tap = *parts_->taps[i];
    if (!parts_->choices[i].needed && reads && !reads(tap.source())) continue;
    sinks.push_back({std::string(kTapPrefix) + port_name(parts_->plan, tap.source()), tap.source(),
                     [&tap](const AnyItem& item) { tap.take(item); }, [&tap] { tap.finish(); }});
  }
  return sinks;
}

const std::vector<WrittenFile>& RunReport::outputs() const { return parts_->in_place; }
std::filesystem::path RunReport::scratch() const { return parts_->directory.scratch(); }
std::filesystem::path RunReport::folder() const { return parts_->directory.folder(); }
std::filesystem::path RunReport::report_file() const {
  return parts_->directory.file("report.html");
}

void RunReport::log(LogLevel level, std::string_view stage, std::string_view sentence) {
  parts_->log.add(level, stage, sentence);
}

bool RunReport::is_tap(std::string_view process_name) {
  return process_name.starts_with(kTapPrefix) || process_name.starts_with(kStorePrefix);
}

void RunReport::finish(const RunRecord& record) {
  Parts& parts = *parts_;
  const bool done = record.end == RunRecord::End::kDone;
  if (done) {
    for (const auto& writer : parts.writers) writer->close();
  } else {
    // What these hold may be what fills the disk; the files that tell of it need some room.
    parts.log.add(LogLevel::kInfo, "",
                  fmt::format("the run ended: {}. {}", end_name(record.end), record.sentence));
  }
  const ReportData data = parts.data(record);
  parts.in_place = data.outputs;
  if (!done) parts.writers.clear();

  // All content first, then nothing but renames, so that a full disk cannot leave a mixture.
  PendingFile json(parts.directory.file("run.json"));
  json.write(run_json(data));
  json.close();
  PendingFile page(parts.directory.file("report.html"));
  page.write(report_page(data));
  page.close();
  PendingFile trace(parts.directory.file("trace.json"));
  write_trace(record, parts.plan.name, [&trace](std::string_view text) { trace.write(text); });
  trace.close();
  parts.log.close();

  for (const auto& writer : parts.writers) writer->commit();
  parts.log.commit();
  trace.commit();
  page.commit();
  json.commit();  // last: who sees the new run.json finds all it lists
  sync_folder(parts.directory.folder());
  parts.writers.clear();
}

}  // namespace stope
