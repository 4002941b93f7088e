#include "framework/pipeline/check.hpp"

#include <fmt/format.h>

#include <utility>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/graph_order.hpp"
#include "framework/pipeline/outputs.hpp"
#include "framework/pipeline/overrides.hpp"
#include "framework/pipeline/parameters.hpp"
#include "framework/pipeline/pipeline_tree.hpp"
#include "framework/pipeline/sentence.hpp"
#include "framework/pipeline/source_text.hpp"
#include "framework/pipeline/variables.hpp"
#include "framework/pipeline/wire_reader.hpp"
#include "framework/pipeline/wiring.hpp"

namespace stope {
namespace {

// A section of the tree with its variables replaced; nothing if it is not written.
std::optional<LocatedNode> resolved(const LocatedNode& root, const char* key,
                                    Variables& variables) {
  const LocatedEntry* entry = root.find(key);
  if (!entry) return std::nullopt;
  return variables.resolve(entry->value);
}

std::string pipeline_name(const std::optional<LocatedNode>& name, const std::filesystem::path& file,
                          Diagnostics& diagnostics) {
  if (!name || name->broken) return file.stem().string();
  if (name->is_scalar() && !name->text.empty()) return name->text;
  diagnostics.error(name->is_map() || name->is_sequence() ? code::kWrongKind : code::kNoValue,
                    name->place, "'name' must be a text.", "Leave it out to use the file's name.");
  return {};
}

void set_stems(const std::vector<OutputDraft>& outputs, std::vector<StageDraft>& drafts) {
  for (const OutputDraft& output : outputs) {
    StageDraft& draft = drafts[output.draft];
    const auto& parameters = draft.record->info.parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
      if (parameters[i].name == "stem" && parameters[i].kind == ParameterKind::kText &&
          !(draft.params && draft.params->find("stem")))
        draft.parameters[i] = output.stem;
  }
}

// Only if all wires could be followed: one that could not may be what reads the stage.
void warn_of_unread(const std::vector<StageDraft>& drafts, Diagnostics& diagnostics) {
  for (const Diagnostic& found : diagnostics.sorted())
    if (found.severity == Severity::kError && !code::about_parameters(found.code)) return;
  for (const StageDraft& draft : drafts)
    if (!draft.is_export && !draft.read && draft.record && !draft.record->info.outputs.empty())
      diagnostics.warning(code::kUnread, draft.place,
                          fmt::format("Nothing reads what stage '{}' gives.", draft.name),
                          "Wire it, list it under outputs:, or remove it.");
}

Plan made_plan(std::vector<StageDraft>& drafts, const std::vector<std::size_t>& order,
               const std::vector<OutputDraft>& outputs) {
  Plan plan;
  std::vector<std::size_t> position(drafts.size());
  for (const std::size_t i : order) {
    StageDraft& draft = drafts[i];
    position[i] = plan.stages.size();
    PlannedStage stage;
    stage.name = draft.is_export ? "outputs/" + draft.name : draft.name;
    stage.info = draft.record->info;
    stage.place = draft.place;
    stage.parameters = std::move(draft.parameters);
    stage.inputs = draft.inputs;
    for (auto& input : stage.inputs)
      if (input) input->stage = position[input->stage];
    stage.streams = draft.streams;
    stage.is_export = draft.is_export;
    plan.stages.push_back(std::move(stage));
  }
  for (const OutputDraft& output : outputs)
    plan.outputs.push_back(
        {output.name, position[output.draft], drafts[output.draft].streams.at(0), output.place});
  return plan;
}

std::optional<Plan> check_source_text(const SourceText& source,
                                      const std::vector<Override>& overrides,
                                      const Catalogue& catalogue, Diagnostics& diagnostics) {
  std::optional<PipelineTree> tree = load_pipeline(source, diagnostics);
  if (!tree) return std::nullopt;
  LocatedNode& root = tree->root;
  apply_overrides(root, overrides, diagnostics);

  const LocatedEntry* vars = std::as_const(root).find("vars");
  Variables variables(vars ? &vars->value : nullptr, diagnostics);
  const auto name = resolved(root, "name", variables);
  const auto stages = resolved(root, "stages", variables);
  const auto outputs = resolved(root, "outputs", variables);

  std::vector<StageDraft> drafts =
      draft_stages(stages ? &*stages : nullptr, catalogue, diagnostics);
  if (stages && drafts.empty() && !stages->incomplete && !stages->broken)
    diagnostics.error(code::kNoValue, stages->place, "Nothing is listed under stages:.",
                      "Write 'name: {use: family/name}'.");
  for (StageDraft& draft : drafts) find_producers(drafts, draft, diagnostics);
  for (std::size_t i = 0; i < drafts.size(); ++i) connect(drafts, i, catalogue, diagnostics);
  const std::vector<OutputDraft> output_drafts =
      draft_outputs(outputs ? &*outputs : nullptr, drafts, catalogue, diagnostics);
  for (StageDraft& draft : drafts) read_parameters(draft, catalogue, diagnostics);
  set_stems(output_drafts, drafts);

  const std::vector<std::size_t> order = order_stages(drafts, diagnostics);
  find_streams(drafts, order, diagnostics);
  check_collisions(output_drafts, drafts, diagnostics);
  warn_of_unread(drafts, diagnostics);
  const std::string title = pipeline_name(name, source.file().file, diagnostics);
  std::map<std::string, std::string> record = variables.record();
  if (diagnostics.has_errors()) return std::nullopt;

  Plan plan = made_plan(drafts, order, output_drafts);
  plan.name = title;
  plan.file = source.file().file;
  plan.vars = std::move(record);
  plan.files_read = std::move(tree->files);
  return plan;
}

}  // namespace

std::optional<Plan> check_pipeline(const std::filesystem::path& file,
                                   const std::vector<std::string>& overrides,
                                   const Catalogue& catalogue, Diagnostics& diagnostics) {
  const std::optional<SourceText> source = read_source(file, {file.string(), 0, 0}, diagnostics);
  if (!source) return std::nullopt;
  return check_source_text(*source, read_overrides(overrides, diagnostics), catalogue, diagnostics);
}

std::optional<Plan> check_pipeline(const std::filesystem::path& file, const Place& asked,
                                   const std::vector<Override>& overrides,
                                   const Catalogue& catalogue, Diagnostics& diagnostics) {
  const std::optional<SourceText> source = read_source(file, asked, diagnostics);
  if (!source) return std::nullopt;
  return check_source_text(*source, overrides, catalogue, diagnostics);
}

std::optional<Plan> check_pipeline_text(std::string_view text, const std::filesystem::path& file,
                                        const std::vector<std::string>& overrides,
                                        const Catalogue& catalogue, Diagnostics& diagnostics) {
  std::error_code problem;
  const auto folder = std::filesystem::absolute(file, problem).lexically_normal().parent_path();
  const SourceText source(std::string(text), file.string(), folder.string());
  if (!check_source(source, diagnostics)) return std::nullopt;
  return check_source_text(source, read_overrides(overrides, diagnostics), catalogue, diagnostics);
}

}  // namespace stope
