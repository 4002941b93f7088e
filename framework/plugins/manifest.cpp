#include "framework/plugins/manifest.hpp"

#include <type_traits>
#include <utility>
#include <variant>

namespace stope {

namespace {

/// Writes each member it visits.
class Writer {
 public:
  explicit Writer(ByteSink& sink) : sink_(sink) {}

  template <class T>
  void operator()(const T& value) {
    encode(value, sink_);
  }
  void operator()(const ParameterValue& value) {
    encode(static_cast<std::uint32_t>(value.index()), sink_);
    std::visit(
        [this]<class T>([[maybe_unused]] const T& held) {
          if constexpr (!std::is_same_v<T, std::monostate>) encode(held, sink_);
        },
        value);
  }
  template <class T, class Visit>
  void list(const std::vector<T>& values, Visit&& visit) {
    encode<std::uint64_t>(values.size(), sink_);
    for (const T& value : values) visit(value);
  }

 private:
  ByteSink& sink_;
};

/// Reads each member it visits.
class Reader {
 public:
  explicit Reader(ByteSource& source) : source_(source) {}

  template <class T>
  void operator()(T& value) {
    decode(value, source_);
  }
  void operator()(ParameterValue& value) {
    std::uint32_t index = 0;
    decode(index, source_);
    if (!read_alternative(index, value,
                          std::make_index_sequence<std::variant_size_v<ParameterValue>>())) {
      throw Error("the manifest holds a value of an unknown kind");
    }
  }
  template <class T, class Visit>
  void list(std::vector<T>& values, Visit&& visit) {
    std::uint64_t size = 0;
    decode(size, source_);
    // One by one: a corrupt length meets the end of the bytes before it has asked for much memory.
    for (values.clear(); values.size() < size;) visit(values.emplace_back());
  }

 private:
  template <std::size_t... I>
  bool read_alternative(std::uint32_t index, ParameterValue& value, std::index_sequence<I...>) {
    const auto read = [&]<std::size_t Place>(std::integral_constant<std::size_t, Place>) {
      if (index != Place) return false;
      [[maybe_unused]] auto& held = value.emplace<Place>();
      if constexpr (Place != 0) decode(held, source_);
      return true;
    };
    return (read(std::integral_constant<std::size_t, I>()) || ...);
  }

  ByteSource& source_;
};

// One list of members for each struct serves both directions.

void visit_port(auto& visit, auto& port) {
  visit(port.name);
  visit(port.type);
  visit(port.layout);
  visit(port.stream);
  visit(port.required);
  visit(port.doc);
}

void visit_limits(auto& visit, auto& limits) {
  visit(limits.least);
  visit(limits.most);
  visit(limits.least_excluded);
  visit(limits.most_excluded);
  visit(limits.choices);
  visit(limits.count_least);
  visit(limits.count_most);
  visit(limits.path);
  visit(limits.required);
}

void visit_parameter(auto& visit, auto& parameter) {
  visit(parameter.name);
  visit(parameter.kind);
  visit(parameter.optional);
  visit(parameter.default_value);
  visit(parameter.unit);
  visit_limits(visit, parameter.limits);
  visit(parameter.doc);
}

void visit_stage(auto& visit, auto& stage) {
  visit(stage.id);
  visit(stage.summary);
  visit(stage.source);
  visit(stage.notes);
  visit.list(stage.inputs, [&](auto& port) { visit_port(visit, port); });
  visit.list(stage.outputs, [&](auto& port) { visit_port(visit, port); });
  visit.list(stage.parameters, [&](auto& parameter) { visit_parameter(visit, parameter); });
  visit(stage.map);
  visit(stage.in_order);
  visit(stage.deterministic);
  visit(stage.live);
  visit(stage.also_reads);
  visit(stage.extensions);
}

void visit_manifest(auto& visit, auto& manifest) {
  visit(manifest.plugin_id);
  visit(manifest.plugin_version);
  visit.list(manifest.stages, [&](auto& stage) { visit_stage(visit, stage); });
  visit.list(manifest.libraries, [&](auto& library) { visit(library); });
}

}  // namespace

void encode_manifest(const Manifest& manifest, ByteSink& sink) {
  Writer writer(sink);
  visit_manifest(writer, manifest);
}

Manifest decode_manifest(ByteSource& source) {
  Manifest manifest;
  Reader reader(source);
  visit_manifest(reader, manifest);
  return manifest;
}

}  // namespace stope
