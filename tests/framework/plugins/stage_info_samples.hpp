#pragma once

#include "framework/plugins/manifest.hpp"

namespace stope {

/// A manifest in which no member has its default value, so that a lost one shows.
inline Manifest full_manifest() {
  StageInfo stage;
  stage.id = "acme/everything";
  stage.summary = "Has one of each.";
  stage.source = "Agricola, De re metallica, book V";
  stage.notes = "Use with care.";
  stage.inputs = {{"scans", "stope/LidarScan@1", 7, false, false, "What is seen."}};
  stage.outputs = {{"sheet", "stope/Artefact@1", 9, false, false, "What is drawn."}};
  stage.map = true;
  stage.deterministic = false;
  stage.live = true;
  stage.also_reads = true;
  stage.extensions = {"pdf", "svg"};
  const auto add = [&stage](const std::string& name, ParameterKind kind, ParameterValue value,
                            const Limits& limits) {
    stage.parameters.push_back(
        {name, kind, kind == ParameterKind::kReal, std::move(value), "m", limits, "A sentence."});
  };
  Limits real = more_than(0.5) + less_than(2.5);
  add("real", ParameterKind::kReal, 1.5, real);
  add("absent", ParameterKind::kReal, std::monostate(), any());
  add("flag", ParameterKind::kBool, true, any());
  add("integer", ParameterKind::kInteger, std::int64_t{-3}, between(-4, 4));
  add("text", ParameterKind::kText, std::string("b"), one_of({"a", "b"}));
  add("file", ParameterKind::kPath, std::string("/x"), existing(PathKind::kFolder) + required());
  add("reals", ParameterKind::kReals, std::vector{1.0, 2.0}, count(1, 3));
  add("texts", ParameterKind::kTexts, std::vector<std::string>{"p", "q"}, count(0, 9));
  return {"acme", "4.5.6", {stage, stage}, {{"/usr/lib/libhammer.so.1", 12, 34, 56, "abcd"}}};
}

}  // namespace stope
