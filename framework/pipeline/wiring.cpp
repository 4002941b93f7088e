#include "framework/pipeline/wiring.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/members.hpp"
#include "framework/pipeline/port_choice.hpp"
#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

std::vector<std::string> names_of(const std::vector<PortInfo>& ports) {
  std::vector<std::string> names;
  for (const PortInfo& port : ports) names.push_back(port.name);
  return names;
}

std::string port_list(const std::vector<PortInfo>& ports, const char* what) {
  if (ports.empty()) return fmt::format("it has no {}s", what);
  return fmt::format("it has {}", quoted_list(names_of(ports)));
}

class Wiring {
 public:
  Wiring(std::vector<StageDraft>& drafts, std::size_t stage, const Catalogue& catalogue,
         Diagnostics& diagnostics)
      : drafts_(drafts),
        stage_(stage),
        reader_(drafts[stage]),
        catalogue_(catalogue),
        diagnostics_(diagnostics) {}

  void connect() {
    if (!reader_.record) return;
    wired_.assign(info().inputs.size(), reader_.wires_broken);
    for (const Wire& wire : reader_.wires) connect(wire);
    for (std::size_t i = 0; i < info().inputs.size(); ++i)
      if (info().inputs[i].required && !wired_[i]) report_missing(info().inputs[i]);
  }

 private:
  const StageInfo& info() const { return reader_.record->info; }

  void connect(const Wire& wire) {
    const auto input = choose_input(info(), wire.input);
    if (!input) return report_no_input(wire);
    wired_[*input] = true;
    reader_.input_places[*input] = wire.place;
    if (!wire.producer || !drafts_[*wire.producer].record) return;
    const StageDraft& producer = drafts_[*wire.producer];
    const PortInfo& to = info().inputs[*input];
    const OutputChoice choice = choose_output(producer.record->info, wire.port, &to);
    if (!choice.port) return report_no_output(wire, producer, to, choice.ambiguous);
    const PortInfo& from = producer.record->info.outputs[*choice.port];
    if (from.type != to.type) return report_types(wire, producer, from, to);
    if (!same_payload(from, to)) return report_layouts(wire, producer, from);
    reader_.inputs[*input] = PlannedSource{*wire.producer, *choice.port};
  }

  void report_no_input(const Wire& wire) {
    if (wire.input.empty()) {
      // What is missing would only say the same again.
      std::fill(wired_.begin(), wired_.end(), true);
      return report_short_form(wire);
    }
    if (optional_in_family(wire.input)) {
      diagnostics_.note(code::kUnusedInput, wire.input_place,
                        fmt::format("{} has no input '{}'; other members of {} can use it. This "
                                    "wire is left out.",
                                    reader_.subject(), wire.input, family_of(reader_.use)));
      return;
    }
    diagnostics_.error(code::kUnknownInputPort, wire.input_place,
                       fmt::format("{} has no input '{}'; {}.", reader_.subject(),
                                   shown(wire.input), port_list(info().inputs, "input")),
                       joined(did_you_mean(wire.input, names_of(info().inputs)), fitting(stage_)));
    // Most likely the misspelt name of what is missing.
    if (const std::string meant = nearest_name(wire.input, names_of(info().inputs)); !meant.empty())
      for (std::size_t i = 0; i < info().inputs.size(); ++i)
        if (info().inputs[i].name == meant) wired_[i] = true;
  }

  void report_short_form(const Wire& wire) {
    if (info().inputs.empty()) {
      diagnostics_.error(code::kNoInputs, wire.place,
                         fmt::format("{} reads nothing, it has no inputs.", reader_.subject()),
                         joined("Remove 'in'.", fitting(stage_)));
      return;
    }
    std::vector<std::string> names, form;
    for (const PortInfo& input : info().inputs) {
      const bool any_required = std::any_of(info().inputs.begin(), info().inputs.end(),
                                            [](const PortInfo& p) { return p.required; });
      if (any_required && !input.required) continue;
      names.push_back(input.name);
      form.push_back(input.name + ": …");
    }
    std::string braces;
    for (const std::string& part : form) braces.append(braces.empty() ? "" : ", ").append(part);
    diagnostics_.error(code::kAmbiguousInput, wire.place,
                       fmt::format("{} has the inputs {}; 'in' must say which of them reads '{}'.",
                                   reader_.subject(), quoted_list(names), written(wire)),
                       joined(fmt::format("Write 'in: {{{}}}'.", braces), fitting(stage_)));
  }

  bool optional_in_family(const std::string& input) const {
    for (const StageRecord& record : catalogue_.stages()) {
      if (family_of(record.info.id) != family_of(reader_.use)) continue;
      for (const PortInfo& port : record.info.inputs)
        if (port.name == input && !port.required) return true;
    }
    return false;
  }

  void report_no_output(const Wire& wire, const StageDraft& producer, const PortInfo& to,
                        bool ambiguous) {
    const StageInfo& from = producer.record->info;
    if (ambiguous) {
      std::vector<std::string> choices;
      for (const PortInfo& output : from.outputs)
        choices.push_back(producer.name + "." + output.name);
      diagnostics_.error(
          code::kAmbiguousOutput, wire.place,
          fmt::format("{} has several outputs, and none is called '{}' or alone in giving {}.",
                      producer.subject(), to.name, to.type),
          fmt::format("Write one of {}.", quoted_list(choices, "or")));
      return;
    }
    if (wire.port.empty()) {
      diagnostics_.error(code::kUnknownOutputPort, wire.place,
                         fmt::format("{} gives nothing that could be read.", producer.subject()));
      return;
    }
    diagnostics_.error(
        code::kUnknownOutputPort, wire.place,
        fmt::format("{} has no output '{}'; {}.", producer.subject(), shown(wire.port),
                    port_list(from.outputs, "output")),
        joined(did_you_mean(wire.port, names_of(from.outputs)), fitting(*wire.producer)));
  }

  void report_types(const Wire& wire, const StageDraft& producer, const PortInfo& from,
                    const PortInfo& to) {
    const auto base = [](const std::string& type) { return type.substr(0, type.find('@')); };
    std::string hint;
    if (base(from.type) == base(to.type)) {
      hint = "They are versions of one type: bring the older plugin up to date.";
    } else {
      hint = joined(givers(to), fitting(stage_));
      if (hint.empty()) hint = fitting(*wire.producer);
    }
    diagnostics_.error(code::kTypeMismatch, wire.place,
                       fmt::format("{} takes {} as '{}', but '{}.{}' gives {}.", reader_.subject(),
                                   to.type, to.name, producer.name, from.name, from.type),
                       hint);
  }

  void report_layouts(const Wire& wire, const StageDraft& producer, const PortInfo& from) {
    diagnostics_.error(code::kLayoutMismatch, wire.place,
                       fmt::format("{} and {} were built with different layouts of {}.",
                                   reader_.subject(), producer.subject(), from.type),
                       fmt::format("Rebuild '{}' and '{}' against the same headers.",
                                   reader_.record->plugin_id, producer.record->plugin_id));
  }

  void report_missing(const PortInfo& input) {
    const std::vector<std::string> sources = sources_of(input);
    std::string hint;
    if (sources.empty()) {
      hint = fmt::format("No other stage of this pipeline gives {}.", input.type);
    } else if (!reader_.wires.empty()) {
      hint = fmt::format("Add '{}: {}' to its 'in'.", input.name, sources[0]);
    } else if (choose_input(info(), "")) {
      hint = fmt::format("Write 'in: {}'.", sources[0]);
    } else {
      hint = fmt::format("Write 'in: {{{}: {}, …}}'.", input.name, sources[0]);
    }
    if (sources.size() > 1) hint = fmt::format("{} Of that type: {}.", hint, quoted_list(sources));
    diagnostics_.error(code::kMissingInput, reader_.place,
                       fmt::format("{} needs the input '{}' ({}), which is not wired.",
                                   reader_.subject(), input.name, input.type),
                       reader_.wires.empty() ? hint : joined(hint, fitting(stage_)));
  }

  /// The stages that read this one, directly or through others, by place: reading one would close a
  /// ring.
  std::vector<bool> downstream() const {
    std::vector<bool> below(drafts_.size(), false);
    below[stage_] = true;
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t i = 0; i < drafts_.size(); ++i) {
        if (below[i]) continue;
        for (const Wire& wire : drafts_[i].wires)
          if (wire.producer && below[*wire.producer]) below[i] = grown = true;
      }
    }
    return below;
  }

  // What in the pipeline gives the input's type, as people would write it.
  std::vector<std::string> sources_of(const PortInfo& input) const {
    std::vector<std::string> names;
    const std::vector<bool> below = downstream();
    for (std::size_t i = 0; i < drafts_.size(); ++i) {
      if (below[i] || drafts_[i].is_export || !drafts_[i].record) continue;
      const std::vector<PortInfo>& outputs = drafts_[i].record->info.outputs;
      for (const PortInfo& output : outputs)
        if (same_payload(output, input))
          names.push_back(outputs.size() == 1 ? drafts_[i].name
                                              : drafts_[i].name + "." + output.name);
    }
    return names;
  }

  std::string givers(const PortInfo& input) const {
    const std::vector<std::string> names = sources_of(input);
    return names.empty() ? "" : fmt::format("Of that type: {}.", quoted_list(names));
  }

  std::string fitting(std::size_t stage) const {
    const std::vector<std::string> ids = members_that_fit(drafts_, stage, catalogue_);
    if (ids.empty() || drafts_[stage].is_export) return "";
    return fmt::format("With the wires as they are, '{}' could use {}.", drafts_[stage].name,
                       quoted_list(ids, "or"));
  }

  static std::string written(const Wire& wire) {
    return wire.port.empty() ? wire.stage : wire.stage + "." + wire.port;
  }

  std::vector<StageDraft>& drafts_;
  std::size_t stage_;
  StageDraft& reader_;
  const Catalogue& catalogue_;
  Diagnostics& diagnostics_;
  std::vector<bool> wired_;
};

}  // namespace

void connect(std::vector<StageDraft>& drafts, std::size_t stage, const Catalogue& catalogue,
             Diagnostics& diagnostics) {
  Wiring(drafts, stage, catalogue, diagnostics).connect();
}

}  // namespace stope
